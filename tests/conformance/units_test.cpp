// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/conformance/units.hpp>

using namespace riprap;

TEST_CASE(
    "in millimetres, grams and milliseconds forces are newtons again and stresses megapascals") {
  constexpr Units units;
  CHECK(units.velocity() == 1);
  CHECK(units.area() == 1e6);
  CHECK(units.force() == 1);
  CHECK(units.stress() == 1e-6);
  CHECK(units.energy() == 1e3);
  CHECK(units.stiffness() == 1e-3);
}
