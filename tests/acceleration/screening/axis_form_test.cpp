// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/axis_form.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

// Sums of a few terms in single precision.
TEST_CASE("a form turned by an angle keeps its eigenvalues") {
  // Eigenvalues 5 and 2, the larger one along (3, 4) / 5.
  const AxisForm form{(5.0f * 9 + 2 * 16) / 25, 3.0f * 12 / 25, 3.0f * 12 / 25,
                      (5.0f * 16 + 2 * 9) / 25};
  CHECK(form.largest_eigenvalue() == near_relative(5, 1e-6));
  CHECK(form.square(3, 4) == near_relative(5 * 25, 1e-6));
  CHECK(form.square(-4, 3) == near_relative(2 * 25, 1e-6));
  CHECK(AxisForm{}.largest_eigenvalue() == 0);
}

TEST_CASE("four lanes are summed") { CHECK(lane_sum(FourFloats{1, 2, 4, 8}) == 15); }
