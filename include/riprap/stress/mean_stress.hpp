// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Mean stress of one particle.

#include <cstddef>

#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/sampling_points.hpp>

namespace riprap {

/// [Pa], in the body's own frame: the mean over the volume, each sampling point with its area. By
/// virtual work it follows from the forces on the particle alone, those of its inertia included,
/// whatever the mesh: -1/V times the sum of the symmetric products of arm and force.
[[nodiscard]] inline Stress2 mean_stress(const SamplingPoints& samples,
                                         const ElementStress& stress) {
  double area = 0;
  Stress2 sum;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double share = samples.area(i);
    area += share;
    sum += share * stress[i];
  }
  return (1 / area) * sum;
}

}  // namespace riprap
