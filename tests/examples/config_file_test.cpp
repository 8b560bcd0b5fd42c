// SPDX-License-Identifier: BSL-1.0
#include <command_line/config_file.hpp>

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include <support/message_of.hpp>
#include <support/temporary_file.hpp>

using riprap::test::contains;

namespace {

/// Options as a program reads them from a file.
struct Read {
  std::string pressure = "unset";
  std::string law = "unset";
  bool fast = false;

  explicit Read(const std::string& text, const std::vector<std::string>& arguments = {}) {
    const riprap::test::TemporaryFile file;
    std::ofstream(file.path(), std::ios::binary) << text;
    CLI::App app;
    command_line::add_config_option(app);
    app.add_option("--pressure", pressure);
    app.add_option("--law", law);
    app.add_flag("--fast", fast);
    const std::string path = file.path();
    std::vector<const char*> argv{"program", "--config", path.c_str()};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    app.parse(static_cast<int>(argv.size()), argv.data());
    command_line::check_config_option(app);
  }
};

std::string refusal(const std::string& text) {
  try {
    const Read read(text);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a file in TOML has a line for each option") {
  const Read read(
      "# all\n\npressure = 8e6  # Pa\r\n  law=\"a # \\\"b\\\" \\u00e9\"\nfast = true\n");
  CHECK(read.pressure == "8e6");
  CHECK(read.law == "a # \"b\" \u00e9");
  CHECK(read.fast);
  CHECK(Read("law = 'C:\\new'").law == "C:\\new");
  CHECK(Read("law = ''  # none").law == "");
  CHECK(!Read("fast = false").fast);
  CHECK(Read("").pressure == "unset");
}

TEST_CASE("a file in JSON is an object of options") {
  const Read read(" {\"pressure\": 8e6,\n\"law\": \"a\\\"b\", \"fast\": true}");
  CHECK(read.pressure == "8000000.0");
  CHECK(read.law == "a\"b");
  CHECK(read.fast);
  CHECK(Read("{\"pressure\": 18446744073709551615}").pressure == "18446744073709551615");
  CHECK(Read("{}").pressure == "unset");
}

TEST_CASE("what stands in the command wins over the file") {
  for (const std::string text :
       {"pressure = 1\nlaw = \"x\"", "{\"pressure\": 1, \"law\": \"x\"}"}) {
    const Read read(text, {"--pressure", "2"});
    CHECK(read.pressure == "2");
    CHECK(read.law == "x");
  }
}

TEST_CASE("a mistake in TOML is refused with its line") {
  CHECK(refusal("\npresure = 1") ==
        "--config: line 2: 'presure' is not the name of an option, without its dashes");
  CHECK(contains(refusal("--pressure = 1"), "line 1: '--pressure' is not the name"));
  CHECK(contains(refusal("config = \"x\""), "'config' is not the name"));
  CHECK(contains(refusal("help = true"), "'help' is not the name"));
  CHECK(contains(refusal("= 1"), "'' is not the name"));
  CHECK(contains(refusal("pressure = 1\n\npressure = 2"), "line 3: 'pressure' comes twice"));
  CHECK(contains(refusal("pressure 1"), "line 1: 'pressure 1' is not NAME = VALUE"));
  CHECK(contains(refusal("[section]"), "is not NAME = VALUE"));
  CHECK(contains(refusal("pressure ="), "line 1: a value is missing"));
  CHECK(contains(refusal("pressure = # 1"), "a value is missing"));
  CHECK(contains(refusal("pressure = 1 2"), "'2' after the value"));
  CHECK(contains(refusal("law = \"x\" y"), "'y' after the value"));
  CHECK(contains(refusal("law = \"x"), "the string has no end"));
  CHECK(contains(refusal("law = \"x\\\""), "the string has no end"));
  CHECK(contains(refusal("law = \"\\q\""), "is not a string"));
  CHECK(contains(refusal("law = [1,2]"), "arrays and tables"));
  CHECK(contains(refusal("law = {a=1}"), "arrays and tables"));
}

TEST_CASE("a mistake in JSON is refused") {
  CHECK(contains(refusal("{\"presure\": 1}"), "JSON: 'presure' is not the name of an option"));
  CHECK(contains(refusal("{\"pressure\": 1, \"pressure\": 2}"), "'pressure' comes twice"));
  CHECK(contains(refusal("{\"pressure\": [1]}"), "'pressure' is neither a string"));
  CHECK(contains(refusal("{\"pressure\": {\"value\": 1}}"), "'pressure' is neither a string"));
  CHECK(contains(refusal("{\"pressure\": null}"), "'pressure' is neither a string"));
  CHECK(contains(refusal("{\"pressure\": 1"), "JSON, byte 15: this is no object"));
  CHECK(contains(refusal("{\"pressure\": 1} x"), "this is no object"));
  CHECK(contains(refusal("{\"law\": \"\xff\"}"), "this is no object"));
}

TEST_CASE("a file that is missing, a folder, and no name are refused") {
  const auto refusal_of = [](const char* name) -> std::string {
    CLI::App app;
    command_line::add_config_option(app);
    const std::vector<const char*> argv{"program", "--config", name};
    try {
      app.parse(3, argv.data());
      command_line::check_config_option(app);
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return {};
  };
  CHECK(contains(refusal_of("/no/such/file"), "/no/such/file"));
  CHECK(contains(refusal_of("/"), "/"));
  CHECK(refusal_of("") == "--config: must not be empty");
}
