// SPDX-License-Identifier: BSL-1.0
#include <command_line/option_names.hpp>

#include <doctest/doctest.h>

#include <string>

using command_line::in_options;
using command_line::OptionNames;

namespace {

const OptionNames names{{"Rock.young", "--young"},
                        {"HoekBrown.s", "--s"},
                        {"RandomAssembly.solid_fraction", "--solid-fraction"},
                        {"RandomAssembly.dense_fraction", "--dense-fraction"},
                        {"MohrCoulomb.tension", "--tensile-strength"}};

}  // namespace

TEST_CASE("an error names the option that was typed, in its rule as well") {
  CHECK(in_options("Rock.young = -1: must be a finite number above 0", names) ==
        "--young = -1: must be a finite number above 0");
  CHECK(in_options("RandomAssembly.dense_fraction = 0.1: must lie above solid_fraction and be at "
                   "most 1",
                   names) ==
        "--dense-fraction = 0.1: must lie above --solid-fraction and be at most 1");
}

TEST_CASE("names that only begin or end alike, and words of a sentence, stay as they are") {
  for (const std::string text :
       {"Rock.young_at_rest = 1", "MyRock.young = 1", "HoekBrown.size = 1", "a.HoekBrown.s = 1",
        "tension is tension", "my_solid_fraction", "s", ""})
    CHECK(in_options(text, names) == text);
}
