// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/calibrated_limit.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("the limits that were measured") {
  const ConstantStrainTriangle three_nodes;
  CHECK(calibrated_limit(three_nodes, 25) == near_relative(0.221, 1e-15));
  CHECK(calibrated_limit(three_nodes, 50) == near_relative(0.280, 1e-15));
  CHECK(calibrated_limit(three_nodes, 100) == near_relative(0.316, 1e-15));
  CHECK(calibrated_limit(three_nodes, 200) == near_relative(0.348, 1e-15));
  CHECK(calibrated_limit(three_nodes, 400) == near_relative(0.369, 1e-15));
  const LinearStrainTriangle six_nodes;
  CHECK(calibrated_limit(six_nodes, 50) == near_relative(0.328, 1e-15));
  CHECK(calibrated_limit(six_nodes, 100) == near_relative(0.354, 1e-15));
  CHECK(calibrated_limit(six_nodes, 200) == near_relative(0.372, 1e-15));
  CHECK(calibrated_limit(six_nodes, 400) == near_relative(0.385, 1e-15));
}

TEST_CASE("in between the limit is linear in the logarithm of the number of points") {
  // 71 / 50 and 141 / 100 are the square root of two within 0.5 %: the middle, within 0.4 % of the
  // difference of 0.036.
  CHECK(calibrated_limit(ConstantStrainTriangle{}, 71) == near_relative(0.298, 1e-3));
  CHECK(calibrated_limit(LinearStrainTriangle{}, 141) == near_relative(0.363, 1e-3));
  const double part = std::log(160.0 / 100) / std::log(2.0);
  CHECK(calibrated_limit(ConstantStrainTriangle{}, 160) ==
        near_relative(0.316 + part * (0.348 - 0.316), 1e-14));
  for (std::size_t samples = 26; samples <= 400; ++samples)
    CHECK(calibrated_limit(ConstantStrainTriangle{}, samples) >
          calibrated_limit(ConstantStrainTriangle{}, samples - 1));
}

TEST_CASE("outside of what was measured there is no limit") {
  CHECK_THROWS_WITH_AS((void)calibrated_limit(ConstantStrainTriangle{}, 24),
                       "calibrated_limit: sampling points = 24: must lie in [25, 400], where the "
                       "limit was measured",
                       InvalidInput);
  CHECK_THROWS_AS((void)calibrated_limit(ConstantStrainTriangle{}, 401), InvalidInput);
  CHECK_THROWS_AS((void)calibrated_limit(ConstantStrainTriangle{}, 0), InvalidInput);
  CHECK_THROWS_AS((void)calibrated_limit(LinearStrainTriangle{}, 49), InvalidInput);
  CHECK_THROWS_AS((void)calibrated_limit(LinearStrainTriangle{}, 401), InvalidInput);
}
