// SPDX-License-Identifier: BSL-1.0
#pragma once
// A random sample in a periodic cell that is sheared at a constant rate (Lees and Edwards 1972).

#include <cstdint>
#include <functional>
#include <vector>

#include <riprap/core/stress2.hpp>
#include <riprap/output/svg.hpp>

#include "options.hpp"

namespace shear_tests {

struct CellTest {
  double normal_stress = 0;      // before shear on both axes, in shear on axis 2 [Pa]
  double inertial_number = 0;    // of shear, at that stress
  bool constant_volume = false;  // the cell keeps its height, and not its normal stress
  std::uint64_t seed = 1;
};

// The state after an interval of shear, and the mean stress over it.
struct CellRecord {
  double strain = 0;          // of simple shear: the integral of dv_1/dx_2
  riprap::Stress2 stress;     // [Pa]
  double asymmetry = 0;       // sigma_12 - sigma_21 over the shear stress
  double contraction = 0;     // rate of shortening along axis 2 over the shear rate
  double rise = 0;            // of the cell's height over that at the start of shear, less 1
  double work = 0;            // of the cell since the start of shear [J/kg]
  double stress_work = 0;     // the same from the mean stresses and the strains [J/kg]
  std::size_t breakages = 0;  // since the start of shear
  std::size_t particles = 0;
  double broken = 0;    // mass of pieces over all [-]
  double detached = 0;  // mass that has left its particle, but for the largest piece, over all [-]

  // Of the shear stress that resists to the normal stress on the plane of shear.
  [[nodiscard]] double ratio() const { return -stress.s12 / stress.s22; }
};

struct CellResult {
  CellTest test{};
  double rate = 0;  // of shear [1/s]
  double solid_fraction = 0;
  std::size_t breakages_before_shear = 0;
  std::vector<CellRecord> records{};
  // Mean velocity along axis 1, over rate times height, at heights over the cell's from its centre.
  std::vector<riprap::Vec2> profile{};
  riprap::Svg picture{0, 0};
};

// Calls `progress(share)` now and then. Throws SimulationError if the sample cannot be prepared.
[[nodiscard]] CellResult sheared_cell(const Options& options, const CellTest& test,
                                      const std::function<void(double)>& progress);

}  // namespace shear_tests
