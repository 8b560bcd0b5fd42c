// SPDX-License-Identifier: BSL-1.0
#include <command_line/option_table.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include <support/message_of.hpp>

using command_line::OptionTable;
using riprap::test::contains;

namespace {

/// A program with an option of each kind.
struct Program {
  std::string law = "linear";
  double stiffness = 1;
  double other_stiffness = 2;
  double size = 0.5;
  std::uint64_t seed = 1;
  bool pulls = false;
  std::string out = "here";
  CLI::App app{"A program"};
  OptionTable table{app};

  Program() {
    table.begin_group("Model");
    table.add_choice("--law", law, {"linear", "area", "dashpot"}, "of contact");
    table.add_number("--stiffness",
                     std::vector<command_line::Member<double>>{
                         {&stiffness, "Linear.stiffness", "linear"},
                         {&other_stiffness, "Dashpot.stiffness", "dashpot"}},
                     "of a contact", "--law");
    table.add_flag("--pull", pulls, "may pull", "--law", "dashpot");
    table.add_number("--size", size, "Model.size", "[m]");
    table.add_number("--seed", seed, "Model.seed", "of the sample");
    table.begin_group("Program", false);
    table.add_text("--out", out, "a folder");
  }
  void parse(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{"program"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    app.parse(static_cast<int>(argv.size()), argv.data());
    table.check_choices();
  }
};

std::string refusal(const std::vector<std::string>& arguments) {
  try {
    Program().parse(arguments);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("options set their members, those of every choice") {
  Program program;
  program.parse({"--law", "dashpot", "--stiffness", "5", "--pull", "--seed", "18446744073709551615",
                 "--size", "-1e-3", "--out", "there"});
  CHECK(program.law == "dashpot");
  CHECK(program.stiffness == 5);
  CHECK(program.other_stiffness == 5);
  CHECK(program.pulls);
  CHECK(program.seed == 18446744073709551615U);
  CHECK(program.size == -1e-3);
  CHECK(program.out == "there");
  CHECK(program.table.is_given("--size"));
  CHECK(!Program().table.is_given("--size"));
}

TEST_CASE("what is no value of an option is refused by the option's name") {
  CHECK(refusal({"--seed", "-1"}) ==
        "--seed: '-1' is not a whole number from 0 to 18446744073709551615");
  CHECK(refusal({"--seed", "-18446744073709551615"}).starts_with("--seed: "));
  CHECK(refusal({"--size", "nan"}) == "--size: 'nan' is not a finite decimal number");
  CHECK(refusal({"--law", "none"}) == "--law: 'none' is none of linear, area, dashpot");
  CHECK(refusal({"--out", ""}) == "--out: must not be empty");
  CHECK(contains(refusal({"--size", "1", "--size", "2"}), "--size"));
  CHECK(contains(refusal({"--size"}), "--size"));
  CHECK(contains(refusal({"--sizes", "1"}), "--sizes"));
}

TEST_CASE("an option that has no meaning with what was chosen is refused, not ignored") {
  CHECK(refusal({"--law", "area", "--stiffness", "5"}) ==
        "--stiffness: goes with --law linear, dashpot; with --law area it has no meaning");
  CHECK(refusal({"--pull"}) ==
        "--pull: goes with --law dashpot; with --law linear it has no meaning");
  CHECK(refusal({"--law", "dashpot", "--pull"}) == "");
}

TEST_CASE("help has the defaults, those of every choice where they differ") {
  const std::string help = Program().app.help();
  CHECK(contains(help, "--law TEXT:{linear,area,dashpot}=linear"));
  CHECK(contains(help, "--stiffness FLOAT=1 (linear), 2 (dashpot)"));
  CHECK(contains(help, "of a contact; with --law linear, dashpot"));
  CHECK(contains(help, "--seed UINT=1"));
  CHECK(contains(help, "may pull; with --law dashpot"));
}

TEST_CASE("the file of parameters has what has a meaning with what was chosen") {
  Program program;
  program.parse({"--law", "dashpot", "--out", "there", "--size", "0.1"});
  const std::string text = program.table.toml();
  const std::string after_comment = text.substr(text.find('\n') + 1);
  CHECK(after_comment == "\n# Model\nlaw = \"dashpot\"\nstiffness = 2\npull = false\nsize = 0.1\n"
                         "seed = 1\n");
  Program area;
  area.parse({"--law", "area"});
  CHECK(!contains(area.table.toml(), "stiffness"));
  CHECK(!contains(area.table.toml(), "pull"));
}

TEST_CASE("the table has the member that each option sets") {
  CHECK(Program().table.names() == command_line::OptionNames{{"Linear.stiffness", "--stiffness"},
                                                             {"Dashpot.stiffness", "--stiffness"},
                                                             {"Model.size", "--size"},
                                                             {"Model.seed", "--seed"}});
}
