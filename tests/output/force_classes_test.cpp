// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <riprap/output/force_classes.hpp>
#include <support/extreme_numbers.hpp>
#include <support/message_of.hpp>

using namespace riprap;

namespace {

std::vector<std::string> names(const ForceClasses& classes) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < classes.size(); ++k) out.push_back(classes.name(k));
  return out;
}

}  // namespace

TEST_CASE("a bound belongs to the class above it") {
  const ForceClasses classes;
  REQUIRE(classes.size() == 6);
  const std::vector<double> bounds{200, 500, 700, 1000, 1400};
  CHECK(classes(0) == 0);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    CHECK(classes(std::nextafter(bounds[k], 0.0)) == k);
    CHECK(classes(bounds[k]) == k + 1);
  }
  CHECK(classes(1e12) == 5);
}

TEST_CASE("the default is the legend of Fig. 11") {
  CHECK(names({}) == std::vector<std::string>{"below 200 N", "200 to 500 N", "500 to 700 N",
                                              "700 to 1000 N", "1000 to 1400 N", "from 1400 N"});
}

TEST_CASE("scaled classes sort forces that are larger by the same factor alike") {
  const ForceClasses classes;
  for (const double factor : {0.25, 4.0, 1e6})
    for (const double force : {0.0, 100.0, 200.0, 650.0, 999.0, 1000.0, 2000.0})
      CHECK(classes.scaled(factor)(factor * force) == classes(force));
}

TEST_CASE("names are rounded and have the unit that suits, below a newton and above a meganewton") {
  // 0.3 as the product that is not quite 0.3.
  CHECK(names({{3 * 0.1, 0.75}}) ==
        std::vector<std::string>{"below 300 mN", "300 to 750 mN", "from 750 mN"});
  CHECK(names({{2.5e6, 1.2e7}}) ==
        std::vector<std::string>{"below 2.5 MN", "2.5 to 12 MN", "from 12 MN"});
  CHECK(names(ForceClasses{}.scaled(7))[4] == "7 to 9.8 kN");
  CHECK(names({{2e-5}}) == std::vector<std::string>{"below 20 uN", "from 20 uN"});
}

TEST_CASE(
    "bounds must be there, positive, finite and rising; the message names the first wrong one") {
  CHECK_NOTHROW(ForceClasses{}.validate());
  const auto message = [](const std::vector<double>& bounds) {
    return test::message_of([&] { ForceClasses{bounds}.validate(); });
  };
  CHECK(message({}) == "ForceClasses.bounds is empty");
  CHECK(message({0, 1}) == "ForceClasses.bounds = 0: must be a finite number above 0");
  CHECK(message({200, 200}) ==
        "ForceClasses.bounds = 200: must be larger than the bound before it");
  CHECK(message({200, 500, 300}) ==
        "ForceClasses.bounds = 300: must be larger than the bound before it");
  CHECK(message({200, std::numeric_limits<double>::infinity()}) ==
        "ForceClasses.bounds = inf: must be a finite number above 0");
}

TEST_CASE("any force has a class, and bounds of any size have names") {
  const ForceClasses classes;
  for (const double force : test::extreme_numbers) CHECK(classes(force) < classes.size());
  const ForceClasses huge{{1e-300, 1, 1e300}};
  CHECK_NOTHROW(huge.validate());
  for (std::size_t k = 0; k < huge.size(); ++k) CHECK(!huge.name(k).empty());
}
