// SPDX-License-Identifier: BSL-1.0
#include <command_line/toml.hpp>

#include <doctest/doctest.h>

#include <support/message_of.hpp>

using command_line::is_open_list;
using command_line::toml_value;
using riprap::test::message_of;
using Items = std::vector<std::string>;

TEST_CASE("a value is a string, a word, or a list of these") {
  CHECK(toml_value(" 8e6 # Pa").items == Items{"8e6"});
  CHECK(!toml_value("8e6").is_list);
  CHECK(toml_value("\"a ] # \\\"b\\\"\"").items == Items{"a ] # \"b\""});
  CHECK(toml_value("[]").items.empty());
  CHECK(toml_value("[]").is_list);
  CHECK(toml_value("[1, 'b,c' ,\"d]\", true] # rest").items == Items{"1", "b,c", "d]", "true"});
  CHECK(toml_value("[\n  1,  # one\n  2,\n]").items == Items{"1", "2"});
}

TEST_CASE("a value that is none is refused") {
  const auto refusal = [](const char* text) { return message_of([&] { (void)toml_value(text); }); };
  CHECK(refusal("") == "a value is missing");
  CHECK(refusal("[1, 2") == "the list has no end");
  CHECK(refusal("[1 2]") == "',' or ']' must come after '1'");
  CHECK(refusal("[1,,2]") == "a value is missing");
  CHECK(refusal("[1] 2") == "'2' after the value");
  CHECK(refusal("[[1], 2]") == "arrays and tables have no meaning here");
}

TEST_CASE("a list that goes on in the next line") {
  CHECK(is_open_list(" [1,"));
  CHECK(is_open_list("['a]', # ]"));
  CHECK(!is_open_list("[1, 2] # ["));
  CHECK(!is_open_list("\"[\""));
  CHECK(!is_open_list("['a"));
}
