// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From the stress in a particle to the crack through it and the pieces it leaves.

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/sampling_points.hpp>

namespace riprap {

/// How a particle is to be split.
struct Crack {
  FailureCount failures;  ///< no elements where neither trigger nor line fit needs them
  FailureMode mode = FailureMode::intact;  ///< of the first failed element, or by the trigger
  Line line;                               ///< in laboratory coordinates
  double length = 0;                       ///< [m]
  CutRings pieces;
  std::array<bool, 2> is_dust{false, false};  ///< left, right: counted, no longer simulated

  [[nodiscard]] bool leaves_dust() const { return is_dust[0] || is_dust[1]; }
};

/// Failed sampling points of the elements with their weights 1/SF, areas and stresses, in
/// laboratory axes. Throws InvalidInput if there are more or fewer sampling points than stresses.
template <Criterion C>
[[nodiscard]] std::vector<WeightedPoint>
failed_points(const C& criterion, const SamplingPoints& samples, const ElementStress& stress,
              const Body& body) {
  require(samples.size() == stress.size(), "SamplingPoints.size()",
          static_cast<double>(samples.size()), "must be that of the ElementStress");
  std::vector<WeightedPoint> points;
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const ElementFailure element = evaluate(criterion, stress[e]);
    if (element.failed())
      points.push_back({body.position + body.rotation * samples.position(e), element.weight(),
                        samples.area(e), stress[e].rotated(body.rotation)});
  }
  return points;
}

namespace internal {

/// A splitter must neither make nor lose mass; round-off far from the origin is allowed for.
inline void require_whole(const CutRings& pieces, Ring ring) {
  const double share =
      (polygon_area(pieces.left) + polygon_area(pieces.right)) / polygon_area(ring);
  require(std::abs(share - 1) <= 1e-9, "splitter: area of both pieces over the particle's", share,
          "must be 1");
}

}  // namespace internal

/// The crack along a line and the pieces on its two sides; nothing if the splitter refuses, a piece
/// breaks a rule of ConvexPolygon (of at most 64 vertices), or both pieces are dust. Failures and
/// mode are left to the caller.
/// Throws InvalidInput if the areas of the pieces do not add up to that of the ring.
/// @param model offers `splitter`
/// @param ring  of the particle, in laboratory coordinates
/// @param mean_area of the intact particles [m^2]
template <class BreakagePart>
[[nodiscard]] std::optional<Crack> crack_along(const BreakagePart& model, const Line& line,
                                               Ring ring, double mean_area) {
  std::optional<CutRings> pieces = model.splitter(ring, line, mean_area);
  if (!pieces || !try_convex_polygon(pieces->left) || !try_convex_polygon(pieces->right))
    return std::nullopt;
  internal::require_whole(*pieces, ring);
  Crack crack;
  crack.line = line;
  if constexpr (requires { model.splitter.is_dust(pieces->left, mean_area); })
    crack.is_dust = {model.splitter.is_dust(pieces->left, mean_area),
                     model.splitter.is_dust(pieces->right, mean_area)};
  if (crack.is_dust[0] && crack.is_dust[1]) return std::nullopt;
  crack.length = 0.5 * (perimeter(pieces->left) + perimeter(pieces->right) - perimeter(ring));
  crack.pieces = std::move(*pieces);
  return crack;
}

namespace internal {

// `draw(points, planes, mean_stress)` gives the line.
template <class BreakagePart, Criterion C, class Draw>
[[nodiscard]] std::optional<Crack>
find_crack(const BreakagePart& model, const C& criterion, const FailureCount& failures,
           const SamplingPoints& samples, const ElementStress& stress, const Body& body, Ring ring,
           double mean_area, Draw&& draw) {
  const Stress2 first = stress[failures.first_failed];
  const FailureMode mode = evaluate(criterion, first).mode;
  const FailurePlanes planes = failure_planes(criterion, first.rotated(body.rotation), mode);
  const auto points = failed_points(criterion, samples, stress, body);
  const std::optional<Line> line =
      draw(points, planes, mean_stress(samples, stress).rotated(body.rotation));
  if (!line) return std::nullopt;
  std::optional<Crack> crack = crack_along(model, *line, ring, mean_area);
  if (!crack) return std::nullopt;
  crack->failures = failures;
  crack->mode = mode;
  return crack;
}

}  // namespace internal

/// The line through the failed elements and the pieces on its two sides; nothing if there is no
/// line, or no crack along it. For line fits that take no LoadedParticle.
/// Throws InvalidInput if the areas of the pieces do not add up to that of the ring, and if there
/// are more or fewer sampling points than stresses.
/// @param model  offers `criterion`, `line_fit` and `splitter`
/// @param failures  of `stress` under the criterion
/// @param samples where in the particle its stress is sampled
/// @param stress at the sampling points, in the body's own frame
/// @param ring   of the particle, in laboratory coordinates
/// @param mean_area of the intact particles [m^2]
template <class BreakagePart>
[[nodiscard]] std::optional<Crack>
find_crack(const BreakagePart& model, const FailureCount& failures, const SamplingPoints& samples,
           const ElementStress& stress, const Body& body, Ring ring, double mean_area) {
  return internal::find_crack(
      model, model.criterion, failures, samples, stress, body, ring, mean_area,
      [&](const auto&... shown) { return fit_line(model.line_fit, shown...); });
}

/// The same for any line fit, by the criterion of the particle's material.
/// @param particle of which the stress is
template <class BreakagePart>
[[nodiscard]] std::optional<Crack>
find_crack(const BreakagePart& model, const FailureCount& failures, const SamplingPoints& samples,
           const ElementStress& stress, const LoadedParticle& particle, double mean_area) {
  return internal::find_crack(
      model, criterion_of(model.criterion, particle.material()), failures, samples, stress,
      particle.body(), particle.ring(), mean_area,
      [&](const auto&... shown) { return fit_line(model.line_fit, shown..., particle); });
}

}  // namespace riprap
