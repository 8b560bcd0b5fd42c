// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the line fit.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/conformance/loaded_sample.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>

namespace riprap {
namespace internal {

/// Failed elements, the failure planes of the first one, the mean stress of the particle, and the
/// particle, which is about as large as the cloud.
struct FailedCloud {
  std::vector<WeightedPoint> points;
  FailurePlanes planes;
  Stress2 mean_stress;
  LoadedSample sample{};

  /// The same in a plane that was turned, drawn larger and shifted, in this order.
  [[nodiscard]] FailedCloud moved(const Rotation& turn, double scale, const Vec2& shift) const {
    FailedCloud out = *this;
    for (WeightedPoint& p : out.points) {
      p.position = scale * (turn * p.position) + shift;
      p.area *= scale * scale;
      p.stress = p.stress.rotated(turn);
    }
    for (Vec2& direction : out.planes.directions) direction = turn * direction;
    out.mean_stress = mean_stress.rotated(turn);
    out.sample = sample.moved(turn, scale, shift);
    return out;
  }
  template <LineFit F>
  [[nodiscard]] std::optional<Line> line(const F& fit) const {
    if constexpr (LineFitOfParticle<F>)
      return sample.particle([&](const LoadedParticle& particle) {
        return fit_line(fit, points, planes, mean_stress, particle);
      });
    else
      return fit_line(fit, points, planes, mean_stress);
  }
};

/// Tension of 1 to 20 MPa along `direction` under up to 10 MPa across it.
[[nodiscard]] inline Stress2 random_tension(const Rotation& direction, Random& random) {
  return Stress2{-1e6 * random.uniform(1, 20), 1e6 * random.uniform(0, 10), 0}.rotated(direction);
}

/// Clouds of about 1 m with random weights, failure planes, areas and tensions; those of a cloud
/// are alike.
/// @param slimness width over length: 0 for points on a straight line
[[nodiscard]] inline std::vector<FailedCloud> failed_clouds(double slimness) {
  Random random(1);
  Random stresses(2);
  std::vector<FailedCloud> clouds;
  for (const LoadedSample& sample : loaded_samples(1, 50)) {
    FailedCloud cloud;
    cloud.sample = sample.times(1e7);
    const Rotation along = Rotation::from_angle(random.uniform(0, 3));
    for (unsigned n = random.uniform_integer(3, 40); n > 0; --n)
      cloud.points.push_back(
          {along * Vec2{random.uniform(-0.5, 0.5), slimness * random.uniform(-0.5, 0.5)},
           random.uniform(1, 5)});
    const Rotation plane = Rotation::from_angle(random.uniform(0, 3));
    cloud.planes.count = random.uniform_integer(1, 2);
    cloud.planes.directions = {plane * Vec2{1, 0}, plane * Vec2{0.6, 0.8}};
    const double tension = stresses.uniform(0, 3);
    for (WeightedPoint& p : cloud.points) {
      p.area = stresses.uniform(0.01, 0.03);
      const double off = stresses.uniform(-0.7, 0.7);
      p.stress = random_tension(Rotation::from_angle(tension + off), stresses);
    }
    cloud.mean_stress = random_tension(Rotation::from_angle(tension), stresses);
    clouds.push_back(cloud);
  }
  return clouds;
}

/// That two lines through clouds of about `size` [m] are one, whichever way they point.
inline void check_same_line(std::string_view axiom, const std::optional<Line>& found,
                            const std::optional<Line>& expected, double size, AxiomCheck& check) {
  check.equal(axiom, found.has_value(), expected.has_value(), 0);
  if (!found || !expected) return;
  // Sums over tens of points round off by 1e-14; a cloud that is nearly round turns its axis more.
  check.equal(axiom, cross(found->direction, expected->direction), 0, 1e-10);
  check.equal(axiom, expected->left_distance(found->point), 0, 1e-10 * size);
}

/// That a line cuts among positions: how far the nearest side of them reaches.
[[nodiscard]] inline double least_reach(const Line& line, std::span<const Vec2> positions) {
  double left = -1;
  double right = -1;
  for (const Vec2& x : positions) {
    left = std::max(left, line.left_distance(x));
    right = std::max(right, -line.left_distance(x));
  }
  return std::min(left, right);
}

template <LineFit F>
void check_line(const F& fit, const FailedCloud& cloud, AxiomCheck& check) {
  const std::optional<Line> line = cloud.line(fit);
  if (line) {
    check.equal("the direction is a unit vector", line->direction.norm(), 1, 1e-12);
    if constexpr (LineFitOfParticle<F>) {
      check.at_least("the line runs through the particle: reach on its other side",
                     least_reach(*line, cloud.sample.polygon.ring()), -1e-12);
    } else {
      std::vector<Vec2> positions;
      for (const WeightedPoint& p : cloud.points) positions.push_back(p.position);
      check.at_least("the line runs among the points: reach on its other side",
                     least_reach(*line, positions), -1e-12);
    }
  }
  const Vec2 shift{40, -70};
  auto moved = cloud.moved({}, 1, shift).line(fit);
  if (moved) moved->point -= shift;
  check_same_line("shifted points have the shifted line", moved, line, 100, check);

  auto larger = cloud.moved({}, 1e3, {0, 0}).line(fit);
  if (larger) larger->point /= 1e3;
  check_same_line("in other units of length the line is the same", larger, line, 1, check);

  FailedCloud other = cloud;
  for (WeightedPoint& p : other.points) p.weight *= 3;
  check_same_line("only the ratios of the weights matter", other.line(fit), line, 1, check);

  other = cloud;
  for (WeightedPoint& p : other.points) p.stress = 1e-6 * p.stress;
  other.mean_stress = 1e-6 * other.mean_stress;
  if constexpr (!LoadLineFit<F>) other.sample = other.sample.times(1e-6);
  check_same_line("in other units of stress the line is the same", other.line(fit), line, 1, check);

  other = cloud;
  std::reverse(other.points.begin(), other.points.end());
  other.sample = other.sample.reversed();
  check_same_line("the order of the points does not matter", other.line(fit), line, 1, check);
}

}  // namespace internal

/// Which axioms a line fit breaks.
template <LineFit F>
[[nodiscard]] Violations line_fit_violations(const F& fit) {
  AxiomCheck check;
  for (const internal::FailedCloud& cloud : internal::failed_clouds(0.3))
    internal::check_line(fit, cloud, check);
  return std::move(check).violations();
}

/// For fits that take their direction from the points: points on a straight line give that line, or
/// none.
template <LineFit F>
  requires(!LoadLineFit<F>)
[[nodiscard]] Violations line_fit_collinear_violations(const F& fit) {
  AxiomCheck check;
  for (const internal::FailedCloud& cloud : internal::failed_clouds(0)) {
    const std::optional<Line> line = cloud.line(fit);
    if (!line) continue;
    for (const WeightedPoint& p : cloud.points)
      check.equal("points on a straight line lie on their line", line->left_distance(p.position), 0,
                  1e-12);
  }
  return std::move(check).violations();
}

/// For fits without preferred axes: points and failure planes turned together have the turned line.
template <LineFit F>
[[nodiscard]] Violations line_fit_rotation_violations(const F& fit) {
  AxiomCheck check;
  const Rotation turn = Rotation::from_angle(0.7);
  for (const internal::FailedCloud& cloud : internal::failed_clouds(0.3)) {
    auto expected = cloud.line(fit);
    if (expected) expected = Line{turn * expected->point, turn * expected->direction};
    internal::check_same_line("turned points have the turned line",
                              cloud.moved(turn, 1, {0, 0}).line(fit), expected, 1, check);
  }
  return std::move(check).violations();
}

}  // namespace riprap
