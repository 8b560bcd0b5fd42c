// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The model for results that are to depend on the mesh as little as possible.

#include <riprap/breakage/line_fit/mean_tension_line.hpp>
#include <riprap/breakage/trigger/calibrated_limit.hpp>
#include <riprap/breakage/trigger/failed_area_ratio.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>

namespace riprap::presets {

/// Model{}, with its contacts named, and three choices of its own: 50 six-node triangles; a failed
/// share of the area, whose limit is that of the mesh (0.377 of 200 sampling points stands for 0.4
/// of a very fine mesh); a crack across the mean tension. docs/presets.md has what differs.
[[nodiscard]] inline auto recommended() {
  constexpr unsigned triangles = 50;
  constexpr LinearStrainTriangle element{};
  return Model{}
      .narrow_phase(OverlapMoments{})
      .contact_law(EnergyConservingSpring{})
      .mesher(UniformMesher{.triangles = triangles})
      .element(element)
      .trigger(FailedAreaRatio{
          .critical = calibrated_limit(element, element.sampling_points.size() * triangles)})
      .line_fit(MeanTensionLine{});
}

}  // namespace riprap::presets
