// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A short biaxial test with a preset.

#include <cstddef>
#include <string>
#include <type_traits>

#include <riprap/conformance/acceleration.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>

namespace riprap::test {

template <class Policy, class T>
[[nodiscard]] constexpr bool is(const T& /*policy*/) {
  return std::is_same_v<Policy, T>;
}

struct PresetRun {
  std::string tables;
  std::size_t breaks = 0;
};

/// 40 particles at 16 MPa, at which some break within 1 % of strain.
template <class ModelType>
[[nodiscard]] PresetRun run_preset(const ModelType& model) {
  Simulation sim{model, random_assembly({.count = 40, .seed = 1}), Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = 16e6, .axial_strain = 0.01}.run(sim, curve);
  return {curve_csv(curve) + energy_csv(curve) + breakages_csv(curve), sim.breaks().size()};
}

}  // namespace riprap::test
