// SPDX-License-Identifier: BSL-1.0
#pragma once
// Stress in a particle on a mesh, the load at which it breaks, and its crack.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/sampling_points.hpp>

#include "loaded_particle.hpp"

namespace convergence {

enum class Plane { stress, strain };

struct MeshChoice {
  const char* name;
  unsigned triangles = 100;
  bool six_nodes = false;
  bool graded = false;  // towards the forces
};

struct Field {
  riprap::Mesh mesh{};
  std::span<const riprap::TrianglePoint> rule{};
  riprap::ElementStress stress{};  // [Pa]

  [[nodiscard]] riprap::SamplingPoints points() const { return riprap::SamplingPoints(mesh, rule); }
  [[nodiscard]] std::vector<double> areas() const;  // of the points [m^2]
};

// Of the free particle (inertia relief), Rock{}.
[[nodiscard]] Field stress_field(const LoadedParticle& particle, double thickness,
                                 const MeshChoice& choice, Plane plane);

// The share of the area that has failed under `factor` times the stress.
[[nodiscard]] double failed_share(const riprap::HoekBrown& criterion,
                                  const riprap::ElementStress& stress,
                                  std::span<const double> areas, double factor);

// The least factor of the loads at which the failed share of the area reaches `limit`: the share
// grows with the load, for the strength is convex and includes zero stress.
[[nodiscard]] double critical_load(const riprap::HoekBrown& criterion,
                                   const riprap::ElementStress& stress,
                                   std::span<const double> areas, double limit);

// The line fits that are compared.
inline constexpr std::array line_names{"WeightedXY", "TotalLeastSquares", "MeanTensionLine",
                                       "WeightedXYByMeanStress"};

// By each of them, under `factor` times the stress.
[[nodiscard]] std::array<std::optional<riprap::Line>, line_names.size()>
crack_lines(const riprap::HoekBrown& criterion, const Field& field, double factor);

}  // namespace convergence
