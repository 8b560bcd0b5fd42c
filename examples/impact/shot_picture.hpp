// SPDX-License-Identifier: BSL-1.0
#pragma once
// Particles before and after an impact, side by side.

#include <string>
#include <vector>

#include <riprap/output/svg.hpp>

// Rings of particles above the plate, whose surface is axis 1 [m].
using Outlines = std::vector<std::vector<riprap::Vec2>>;

struct ShotPanel {
  std::string title;
  Outlines before{};
  Outlines after{};
};

// Two to a row, each eight diameters wide. @param diameter of a particle [m]
[[nodiscard]] riprap::Svg shot_picture(const std::vector<ShotPanel>& panels, double diameter);
