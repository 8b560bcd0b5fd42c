// SPDX-License-Identifier: BSL-1.0
#pragma once
// What a biaxial test of a table depends on, beside its model.

#include <cstdint>

namespace run_table {

struct Setup {
  double pressure = 8e6;  // [Pa]
  std::uint64_t seed = 1;
  unsigned particles = 500;
  double strain = 0.2;
  double inertial_number = 1e-3;
};

}  // namespace run_table
