// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What an unconfined compression test finds.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>
#include <riprap/stress/sampling_points.hpp>

namespace riprap {

/// A node on a platen.
struct PlatenNode {
  std::uint32_t node = 0;
  bool top = false;
  Vec2 force{0, 0};  ///< of the platen on the specimen [N]
  double slip = 0;   ///< along axis 1 [m]

  /// Positive while the platen presses [N].
  [[nodiscard]] double normal_force() const { return top ? -force.y() : force.y(); }
};

/// The specimen under its load, centre at the origin, loaded along axis 2.
struct UnconfinedResult {
  Mesh mesh;  ///< with the nodes of the element
  std::span<const TrianglePoint> sampling_rule = centroid_rule;
  ElementStress stress;
  std::vector<ElementFailure> elements;  ///< at their sampling points
  FailureCount failures;
  std::size_t tensile = 0;  ///< elements that failed in tension
  std::size_t shear = 0;

  double strength = 0;                   ///< uniaxial compressive strength of the criterion [Pa]
  double platen_stress = 0;              ///< mean, positive in compression [Pa]
  double axial_strain = 0;               ///< shortening over height [-]
  std::vector<PlatenNode> platen_nodes;  ///< of the bottom platen from the left, then of the top's

  /// Refers to `mesh`.
  [[nodiscard]] SamplingPoints sampling_points() const& {
    return SamplingPoints(mesh, sampling_rule);
  }
  [[nodiscard]] SamplingPoints sampling_points() const&& = delete;  // would outlive the mesh
  /// Rat [-].
  [[nodiscard]] double ratio() const { return failures.ratio(); }

  /// The least force with which a platen presses on a node [N]. Nodes cannot lift off: below 0 the
  /// platens were glued on there.
  [[nodiscard]] double least_normal_force() const {
    double least = std::numeric_limits<double>::infinity();
    for (const PlatenNode& n : platen_nodes) least = std::min(least, n.normal_force());
    return least;
  }
  [[nodiscard]] std::size_t slipping_nodes() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(platen_nodes, [](const PlatenNode& n) { return n.slip != 0; }));
  }
};

/// The line through the failed elements that the fit draws; none where nothing failed.
template <Criterion C, LineFit F>
[[nodiscard]] std::optional<Line> failure_line(const UnconfinedResult& result, const C& criterion,
                                               const F& fit) {
  if (result.failures.failed == 0) return std::nullopt;
  const std::size_t first = result.failures.first_failed;
  const FailurePlanes planes =
      failure_planes(criterion, result.stress[first], result.elements[first].mode);
  const SamplingPoints samples = result.sampling_points();
  const auto points = failed_points(criterion, samples, result.stress, Body{});
  return fit_line(fit, points, planes, mean_stress(samples, result.stress));
}

}  // namespace riprap
