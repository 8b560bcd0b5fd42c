// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/calibrated_limit.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("the limits that were measured") {
  const ConstantStrainTriangle three_nodes;
  CHECK(calibrated_limit(three_nodes, 25) == near_relative(0.245, 1e-15));
  CHECK(calibrated_limit(three_nodes, 50) == near_relative(0.285, 1e-15));
  CHECK(calibrated_limit(three_nodes, 100) == near_relative(0.328, 1e-15));
  CHECK(calibrated_limit(three_nodes, 200) == near_relative(0.353, 1e-15));
  CHECK(calibrated_limit(three_nodes, 400) == near_relative(0.371, 1e-15));
  const LinearStrainTriangle six_nodes;
  CHECK(calibrated_limit(six_nodes, 52) == near_relative(0.336, 1e-15));
  CHECK(calibrated_limit(six_nodes, 100) == near_relative(0.364, 1e-15));
  CHECK(calibrated_limit(six_nodes, 200) == near_relative(0.377, 1e-15));
  CHECK(calibrated_limit(six_nodes, 400) == near_relative(0.386, 1e-15));
}

TEST_CASE("in between the limit is linear in the logarithm of the number of points") {
  // 71 / 50 and 141 / 100 are the square root of two within 0.5 %: the middle, within 0.4 % of the
  // difference of 0.043 and 0.013.
  CHECK(calibrated_limit(ConstantStrainTriangle{}, 71) == near_relative(0.3065, 1e-3));
  CHECK(calibrated_limit(LinearStrainTriangle{}, 141) == near_relative(0.3705, 1e-3));
  const double part = std::log(160.0 / 100) / std::log(2.0);
  CHECK(calibrated_limit(ConstantStrainTriangle{}, 160) ==
        near_relative(0.328 + part * (0.353 - 0.328), 1e-14));
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
  CHECK_THROWS_AS((void)calibrated_limit(LinearStrainTriangle{}, 51), InvalidInput);
  CHECK_THROWS_AS((void)calibrated_limit(LinearStrainTriangle{}, 401), InvalidInput);
}
