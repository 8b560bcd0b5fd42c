// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/errors.hpp>

#include <cstdlib>
#include <doctest/doctest.h>
#include <limits>
#include <type_traits>

#include <support/message_of.hpp>

using namespace riprap;
using test::message_of;

static_assert(std::is_base_of_v<std::invalid_argument, InvalidInput>);
static_assert(std::is_base_of_v<std::runtime_error, SimulationError>);
static_assert(!std::is_base_of_v<std::runtime_error, InvalidInput>, "the two can be distinguished");

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
}  // namespace

TEST_CASE("a number's text is the shortest that reads back as the same number") {
  CHECK(to_text(0.1) == "0.1");
  CHECK(to_text(2500) == "2500");
  CHECK(to_text(-12e6) == "-1.2e+07");
  CHECK(to_text(not_a_number) == "nan");
  CHECK(to_text(-infinity) == "-inf");
  const double extremes[] = {1.0 / 3,
                             0.1 + 0.2,
                             -std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::denorm_min(),
                             5e-324,
                             1 + 2.3e-16};
  for (const double value : extremes) CHECK(std::strtod(to_text(value).c_str(), nullptr) == value);
}

TEST_CASE("an error names the value, its name and the rule") {
  CHECK(message_of([] { require(false, "Rock.poisson", 0.5, "must lie in [0, 0.5)"); }) ==
        "Rock.poisson = 0.5: must lie in [0, 0.5)");
  CHECK(message_of([] { require(true, "Rock.poisson", 0.2, "must lie in [0, 0.5)"); }).empty());
}

TEST_CASE("positive means finite and above zero") {
  CHECK(message_of([] { require_positive("x", 1e-300); }).empty());
  CHECK(message_of([] { require_positive("x", 0); }) == "x = 0: must be a finite number above 0");
  for (const double value : {-1.0, -0.0, not_a_number, infinity, -infinity})
    CHECK(message_of([=] { require_positive("x", value); }) ==
          "x = " + to_text(value) + ": must be a finite number above 0");
}

TEST_CASE("non-negative means finite and not below zero") {
  CHECK(message_of([] { require_non_negative("x", 0); }).empty());
  CHECK(message_of([] { require_non_negative("x", 3); }).empty());
  for (const double value : {-1e-300, not_a_number, infinity, -infinity})
    CHECK(message_of([=] { require_non_negative("x", value); }) ==
          "x = " + to_text(value) + ": must be a finite number, 0 or above");
}

TEST_CASE("a particle is named by its id") { CHECK(particle_text(42) == "particle 42"); }
