// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/ring_distance.hpp>
#include <riprap/geometry/wadell_roundness.hpp>

namespace riprap {

namespace internal {

/// Of a closed curve the first point, another one, and those between that keep it within
/// `deviation` [m] of straight lines, each the farthest from the line between those before and
/// after it (U. Ramer, Comput. Graph. Image Process. 1, 1972).
[[nodiscard]] inline std::vector<std::size_t> key_points(std::span<const Vec2> closed,
                                                         std::size_t other, double deviation) {
  std::vector<std::size_t> keys;
  std::vector<std::size_t> ends{closed.size() - 1, other};
  for (std::size_t from = 0; !ends.empty();) {
    std::size_t farthest = from;
    double distance = deviation;
    for (std::size_t k = from + 1; k < ends.back(); ++k) {
      const double here = distance_to_segment(closed[k], closed[from], closed[ends.back()]);
      if (here <= distance) continue;
      farthest = k;
      distance = here;
    }
    if (farthest != from) {
      ends.push_back(farthest);
      continue;
    }
    keys.push_back(from);
    from = ends.back();
    ends.pop_back();
  }
  return keys;
}

[[nodiscard]] inline std::size_t farthest_from(const Vec2& x, Ring ring) {
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - x).norm() < (b - x).norm(); };
  return static_cast<std::size_t>(std::max_element(ring.begin(), ring.end(), nearer) -
                                  ring.begin());
}

/// Fits circles to an outline, which is stored twice round so that stretches of it are spans.
class CornerSearch {
 public:
  CornerSearch(Ring ring, const Circle& inside, const CornerFit& fit)
      : ring_(ring), inside_(inside), fit_(fit) {
    const std::size_t start = farthest_from(inside.centre, ring);
    for (std::size_t k = 0; k < 2 * ring.size(); ++k)
      twice_.push_back(ring[(start + k) % ring.size()]);
    keys_ = key_points(std::span(twice_).first(ring.size() + 1), farthest_from(twice_[0], twice_),
                       fit.deviation * inside.radius);
    const std::size_t n = keys_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 before = twice_[keys_[k]] - twice_[keys_[previous_vertex(k, n)]];
      const Vec2 after = twice_[keys_[next_vertex(k, n)]] - twice_[keys_[k]];
      turns_.push_back(std::atan2(cross(before, after), before.dot(after)));
    }
  }

  [[nodiscard]] std::vector<Circle> corners() const {
    std::vector<Candidate> candidates;
    for (std::size_t first = 0; first < keys_.size(); ++first) add_candidates(first, candidates);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.turn > b.turn; });
    std::vector<Circle> corners;
    std::vector<bool> taken(keys_.size());
    const std::size_t n = keys_.size();
    for (const Candidate& c : candidates) {
      bool is_free = true;
      for (std::size_t k = 0; k < c.count; ++k) is_free = is_free && !taken[(c.first + k) % n];
      if (!is_free) continue;
      for (std::size_t k = 0; k < c.count; ++k) taken[(c.first + k) % n] = true;
      corners.push_back({c.circle.centre, std::min(c.circle.radius, inside_.radius)});
    }
    for (std::size_t k = 0; k < n; ++k)
      if (!taken[k] && turns_[k] > 2 * std::acos(fit_.closeness))
        corners.push_back({twice_[keys_[k]], 0});
    return corners;
  }

 private:
  /// Of a row of key points, its first, their number, and the angle by which the outline turns.
  struct Candidate {
    std::size_t first = 0;
    std::size_t count = 0;
    double turn = 0;
    Circle circle;
  };

  void add_candidates(std::size_t first, std::vector<Candidate>& candidates) const {
    const std::size_t n = keys_.size();
    double turn = 0;
    for (std::size_t count = 1; count <= n; ++count) {
      const std::size_t last = first + count - 1;
      if (turns_[last % n] <= 0) return;
      turn += turns_[last % n];
      if (count < 3) continue;
      const std::size_t end = keys_[last % n] + (last < n ? 0 : ring_.size());
      const auto points = std::span(twice_).subspan(keys_[first], end - keys_[first] + 1);
      const Circle circle = least_squares_circle(points);
      if (fits(circle, points)) candidates.push_back({first, count, turn, circle});
    }
  }

  [[nodiscard]] bool fits(const Circle& circle, std::span<const Vec2> points) const {
    if (!(circle.radius * fit_.closeness <= inside_.radius)) return false;
    for (const Vec2& p : points)
      if ((p - circle.centre).norm() * fit_.closeness > circle.radius) return false;
    return distance_to_ring(circle.centre, ring_) >= fit_.closeness * circle.radius;
  }

  Ring ring_;
  Circle inside_;
  CornerFit fit_;
  std::vector<Vec2> twice_;
  std::vector<std::size_t> keys_;
  std::vector<double> turns_;  ///< at the key points, left positive [rad]
};

}  // namespace internal

RIPRAP_INLINE void CornerFit::validate() const {
  require(deviation > 0 && deviation < 1, "CornerFit.deviation", deviation, "must lie in (0, 1)");
  require(closeness > 0 && closeness < 1, "CornerFit.closeness", closeness, "must lie in (0, 1)");
}

RIPRAP_INLINE OutlineCorners outline_corners(const Outline& outline, const CornerFit& fit) {
  fit.validate();
  const Circle inside = inscribed_circle(outline);
  std::vector<Circle> corners = internal::CornerSearch(outline.ring(), inside, fit).corners();
  if (corners.empty())
    throw InvalidInput(
        "outline has no corner with CornerFit.deviation = " + to_text(fit.deviation) +
        " and closeness = " + to_text(fit.closeness) + ": must have one or more");
  return {inside, std::move(corners)};
}

RIPRAP_INLINE double wadell_roundness(const Outline& outline, const CornerFit& fit) {
  const OutlineCorners found = outline_corners(outline, fit);
  double sum = 0;
  for (const Circle& corner : found.corners) sum += corner.radius;
  return sum / (static_cast<double>(found.corners.size()) * found.inside.radius);
}

}  // namespace riprap
