// SPDX-License-Identifier: BSL-1.0
#pragma once
// One direct shear test of a random sample.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

#include "../shear_tests/options.hpp"
#include "shear_box.hpp"

namespace direct_shear {

struct Options : shear_tests::Options {
  std::string sides = "smooth";  // or rough
};

// The state after an interval of shear, and the mean forces over it.
struct Record {
  double normal_stress = 0;  // that the lid is to hold [Pa]
  std::uint64_t seed = 0;
  double displacement = 0;  // of the lower half [m]
  double lift = 0;          // of the lid since the start of shear [m]
  BoxForces forces{};
  std::size_t breakages = 0;  // since the start of shear
  std::size_t particles = 0;
};

struct BoxResult {
  BoxSize size{};
  double thickness = 0;  // of the particles [m]
  double height = 0;     // of the sample at the start of shear [m]
  double solid_fraction = 0;
  std::size_t breakages_before_shear = 0;
  std::size_t lost = 0;  // particles whose centroid has left the box
  std::vector<Record> records{};
  // Of the particles that are whole at the end: height in the sample at the start of shear over the
  // sample's height, and the way along axis 1 over that of the lower half.
  std::vector<riprap::Vec2> profile{};
  riprap::Svg picture{0, 0};

  [[nodiscard]] double area() const { return size.width * thickness; }  // of the plane [m^2]
};

// Calls `progress(share)` now and then. Throws SimulationError if the sample does not come to rest.
[[nodiscard]] BoxResult box_test(const Options& options, double normal_stress, std::uint64_t seed,
                                 const std::function<void(double)>& progress);

}  // namespace direct_shear
