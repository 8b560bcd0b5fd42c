// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/units.hpp>

#include <cmath>
#include <doctest/doctest.h>

using namespace riprap::literals;

// Powers of ten are exact in both forms; only degrees need a rounding.

TEST_CASE("pressures come out in pascal") {
  CHECK(3_Pa == 3.0);
  CHECK(3.5_Pa == 3.5);
  CHECK(2_kPa == 2e3);
  CHECK(2.5_kPa == 2500.0);
  CHECK(14_MPa == 14e6);
  CHECK(0.5_MPa == 5e5);
  CHECK(70_GPa == 70e9);
  CHECK(1.5_GPa == 1.5e9);
  CHECK(1_GPa == 1000_MPa);
  CHECK(1_MPa == 1000_kPa);
  CHECK(1_kPa == 1000_Pa);
}

TEST_CASE("lengths come out in metres") {
  CHECK(16_mm == 0.016);
  CHECK(0.5_mm == 0.0005);
}

TEST_CASE("angles come out in radians") {
  // One rounding of the product and one of the quotient.
  CHECK(std::abs(180_deg - std::acos(-1.0)) <= 4.5e-16);
  CHECK(std::abs(22.5_deg - std::atan(1.0) / 2) <= 1e-16);
  CHECK(std::abs(std::sin(30_deg) - 0.5) <= 2e-16);
}

TEST_CASE("units are constants of the compiler") {
  static_assert(2_MPa == 2e6);
  static_assert(90_deg > 1.57);
  CHECK(-12_MPa == -12e6);
}
