// SPDX-License-Identifier: BSL-1.0
#include <riprap/material/rock.hpp>

#include <doctest/doctest.h>
#include <limits>

#include <support/message_of.hpp>

using namespace riprap;
using test::message_of;

namespace {

std::string complaint(double young, double poisson, double density) {
  return message_of(
      [=] { Rock{.young = young, .poisson = poisson, .density = density}.validate(); });
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("the default rock is that of Table 1 of Bagherzadeh-Khalkhali et al. (2008)") {
  const Rock rock;
  CHECK(rock.young == 7e4 * 1e6);
  CHECK(rock.poisson == 0.17);
  CHECK(rock.density == 2500);
  CHECK_NOTHROW(rock.validate());
}

TEST_CASE("stiffness and density are above zero") {
  CHECK(complaint(0, 0.2, 2500) == "Rock.young = 0: must be a finite number above 0");
  CHECK(complaint(-7e10, 0.2, 2500) == "Rock.young = -7e+10: must be a finite number above 0");
  CHECK(complaint(not_a_number, 0.2, 2500) == "Rock.young = nan: must be a finite number above 0");
  CHECK(complaint(7e10, 0.2, 0) == "Rock.density = 0: must be a finite number above 0");
  CHECK(complaint(7e10, 0.2, -1) == "Rock.density = -1: must be a finite number above 0");
}

TEST_CASE("Poisson's ratio lies in [0, 0.5)") {
  CHECK(complaint(7e10, 0, 2500).empty());
  CHECK(complaint(7e10, 0.4999, 2500).empty());
  CHECK(complaint(7e10, 0.5, 2500) == "Rock.poisson = 0.5: must lie in [0, 0.5)");
  CHECK(complaint(7e10, -0.1, 2500) == "Rock.poisson = -0.1: must lie in [0, 0.5)");
  CHECK(complaint(7e10, not_a_number, 2500) == "Rock.poisson = nan: must lie in [0, 0.5)");
}
