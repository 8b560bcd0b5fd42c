// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include <riprap/core/argsort.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_parts.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

namespace internal {

/// Cuts ears off a ring, each time the one whose least height over its longest side is greatest.
class EarClipping {
 public:
  explicit EarClipping(Ring ring) : ring_(ring), quality_(ring.size()) {
    left_.resize(ring.size());
    std::iota(left_.begin(), left_.end(), 0U);
    for (std::size_t k = 0; k < left_.size(); ++k) quality_[k] = quality(k);
  }

  [[nodiscard]] std::vector<TriangleIndices> triangles() {
    std::vector<TriangleIndices> out;
    while (left_.size() > 3) {
      const auto best = std::max_element(quality_.begin(), quality_.end()) - quality_.begin();
      if (quality_[static_cast<std::size_t>(best)] <= 0) fail();
      out.push_back(ear(static_cast<std::size_t>(best)));
      left_.erase(left_.begin() + best);
      quality_.erase(quality_.begin() + best);
      const std::size_t after = static_cast<std::size_t>(best) % left_.size();
      const std::size_t before = previous_vertex(after, left_.size());
      quality_[before] = quality(before);
      quality_[after] = quality(after);
    }
    out.push_back({left_[0], left_[1], left_[2]});
    if (shape(out.back()) <= 0) fail();
    return out;
  }

 private:
  [[noreturn]] static void fail() {
    throw InvalidInput("outline: too thin to be cut into triangles");
  }
  [[nodiscard]] TriangleIndices ear(std::size_t k) const {
    return {left_[previous_vertex(k, left_.size())], left_[k], left_[next_vertex(k, left_.size())]};
  }
  /// Least height over longest side [-], negative where the corner is concave.
  [[nodiscard]] double shape(const TriangleIndices& t) const {
    const Vec2 &a = ring_[t[0]], &b = ring_[t[1]], &c = ring_[t[2]];
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return cross(b - a, c - a) / longest;
  }
  /// The shape of an ear, 0 of a corner that is none.
  [[nodiscard]] double quality(std::size_t k) const {
    const TriangleIndices t = ear(k);
    const double of_shape = shape(t);
    if (of_shape <= 0) return 0;
    for (const std::uint32_t v : left_)
      if (v != t[0] && v != t[1] && v != t[2] && holds(t, ring_[v])) return 0;
    return of_shape;
  }
  [[nodiscard]] bool holds(const TriangleIndices& t, const Vec2& v) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (LineSide(ring_[t[i]], ring_[t[(i + 1) % 3]])(v) < 0) return false;
    return true;
  }

  Ring ring_;
  std::vector<std::uint32_t> left_;  // of the ring, in its order
  std::vector<double> quality_;
};

/// From one vertex to another, with the triangle to the left.
using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// The triangle, or other part, to the left of each edge.
template <class Part>
[[nodiscard]] std::map<DirectedEdge, std::size_t> parts_by_edge(const std::vector<Part>& parts) {
  std::map<DirectedEdge, std::size_t> out;
  for (std::size_t n = 0; n < parts.size(); ++n)
    for (std::size_t k = 0; k < parts[n].size(); ++k)
      out[{parts[n][k], parts[n][next_vertex(k, parts[n].size())]}] = n;
  return out;
}

/// Exchanges diagonals until the two angles that face each are at most 180 degrees together
/// (Lawson 1977).
class DiagonalFlips {
 public:
  DiagonalFlips(Ring ring, std::vector<TriangleIndices> triangles)
      : ring_(ring), triangles_(std::move(triangles)), left_of_(parts_by_edge(triangles_)) {}

  [[nodiscard]] std::vector<TriangleIndices> run() {
    std::vector<DirectedEdge> to_check;
    for (const auto& entry : left_of_) to_check.push_back(entry.first);
    while (!to_check.empty()) {
      const DirectedEdge edge = to_check.back();
      to_check.pop_back();
      flip(edge, to_check);
    }
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] std::uint32_t apex(std::size_t triangle, const DirectedEdge& edge) const {
    for (const std::uint32_t v : triangles_[triangle])
      if (v != edge.first && v != edge.second) return v;
    return edge.first;
  }
  void put(std::size_t triangle, const TriangleIndices& t, std::vector<DirectedEdge>& to_check) {
    triangles_[triangle] = t;
    for (std::size_t k = 0; k < 3; ++k) {
      const DirectedEdge edge{t[k], t[(k + 1) % 3]};
      left_of_[edge] = triangle;
      to_check.push_back(edge);
    }
  }
  void flip(const DirectedEdge& edge, std::vector<DirectedEdge>& to_check) {
    const auto left = left_of_.find(edge);
    const auto right = left_of_.find({edge.second, edge.first});
    if (left == left_of_.end() || right == left_of_.end()) return;
    const std::size_t first = left->second;
    const std::size_t second = right->second;
    const std::uint32_t c = apex(first, edge);
    const std::uint32_t d = apex(second, edge);
    const Vec2 to_c_a = ring_[edge.first] - ring_[c], to_c_b = ring_[edge.second] - ring_[c];
    const Vec2 to_d_a = ring_[edge.first] - ring_[d], to_d_b = ring_[edge.second] - ring_[d];
    // Sine of the sum of the angles at c and d, times the four lengths.
    const double sine =
        cross(to_c_a, to_c_b) * to_d_b.dot(to_d_a) + to_c_a.dot(to_c_b) * cross(to_d_b, to_d_a);
    // Where it is a round-off from 180 degrees either diagonal will do.
    const double scale = to_c_a.norm() * to_c_b.norm() * to_d_a.norm() * to_d_b.norm();
    if (sine >= -1e-12 * scale) return;
    // Past 180 degrees the two triangles make a convex quadrangle, but for round-off.
    if (cross(ring_[d] - ring_[c], ring_[edge.first] - ring_[c]) >= 0 ||
        cross(ring_[d] - ring_[c], ring_[edge.second] - ring_[c]) <= 0)
      return;
    left_of_.erase(left);
    left_of_.erase({edge.second, edge.first});
    put(first, {c, edge.first, d}, to_check);
    put(second, {d, edge.second, c}, to_check);
  }

  Ring ring_;
  std::vector<TriangleIndices> triangles_;
  std::map<DirectedEdge, std::size_t> left_of_;
};

/// Parts by the places of their vertices in a ring, which can be joined.
class JoinedParts {
 public:
  JoinedParts(Ring ring, const std::vector<TriangleIndices>& triangles)
      : ring_(ring), extent_(diameter(ring)) {
    for (const TriangleIndices& t : triangles) parts_.emplace_back(t.begin(), t.end());
    left_of_ = parts_by_edge(parts_);
  }

  /// Joins convex parts until no more can be joined, across the longest diagonals first.
  void join_all() {
    std::vector<DirectedEdge> diagonals;
    std::vector<double> shortness;
    for (const auto& [edge, part] : left_of_) {
      if (edge.first > edge.second || !left_of_.contains({edge.second, edge.first})) continue;
      diagonals.push_back(edge);
      shortness.push_back(-(ring_[edge.second] - ring_[edge.first]).norm());
    }
    for (const std::size_t k : argsort(shortness)) join(diagonals[k]);
  }
  [[nodiscard]] std::vector<ConvexPolygon> polygons() const {
    std::vector<ConvexPolygon> out;
    for (const auto& part : parts_)
      if (!part.empty()) append(part, out);
    return out;
  }

 private:
  [[nodiscard]] std::vector<Vec2> vertices(const std::vector<std::uint32_t>& part) const {
    std::vector<Vec2> out;
    for (const std::uint32_t v : part) out.push_back(ring_[v]);
    return out;
  }
  /// Adds a part; of one with more vertices than a polygon may have about half that many are cut
  /// off, until it has no more.
  void append(std::vector<std::uint32_t> part, std::vector<ConvexPolygon>& out) const {
    constexpr std::ptrdiff_t half = max_polygon_vertices / 2;
    while (part.size() > max_polygon_vertices) {
      out.emplace_back(vertices({part.begin(), part.begin() + half + 1}));
      // The ends of the cut stay.
      part.erase(part.begin() + 1, part.begin() + half);
    }
    out.emplace_back(vertices(part));
  }
  /// Does a ring turn left at a vertex, clearly more than a ConvexPolygon has to?
  [[nodiscard]] bool turns_left(std::uint32_t before, std::uint32_t at, std::uint32_t after) const {
    const Vec2 in = ring_[at] - ring_[before];
    const Vec2 out = ring_[after] - ring_[at];
    return cross(in, out) > 1e-8 * extent_ * std::max(in.norm(), out.norm());
  }
  /// The ring of a part from one of its vertices on.
  [[nodiscard]] static std::vector<std::uint32_t> begun_at(std::vector<std::uint32_t> part,
                                                           std::uint32_t first) {
    std::rotate(part.begin(), std::find(part.begin(), part.end(), first), part.end());
    return part;
  }
  void join(const DirectedEdge& diagonal) {
    const auto [a, b] = diagonal;
    const std::size_t left = left_of_.at(diagonal);
    const std::size_t right = left_of_.at({b, a});
    // From b round to a, and from a round to b: the diagonal closes both.
    std::vector<std::uint32_t> joined = begun_at(parts_[left], b);
    const std::vector<std::uint32_t> other = begun_at(parts_[right], a);
    if (!turns_left(joined[joined.size() - 2], a, other[1])) return;
    if (!turns_left(other[other.size() - 2], b, joined[1])) return;
    joined.insert(joined.end(), other.begin() + 1, other.end() - 1);
    for (std::size_t k = 0; k < other.size(); ++k)
      left_of_[{other[k], other[next_vertex(k, other.size())]}] = left;
    parts_[left] = std::move(joined);
    parts_[right].clear();
  }

  Ring ring_;
  double extent_;
  std::vector<std::vector<std::uint32_t>> parts_;
  std::map<DirectedEdge, std::size_t> left_of_;
};

}  // namespace internal

RIPRAP_INLINE std::vector<TriangleIndices> triangulate(const Outline& outline) {
  internal::EarClipping ears(outline.ring());
  return internal::DiagonalFlips(outline.ring(), ears.triangles()).run();
}

RIPRAP_INLINE std::vector<ConvexPolygon> convex_parts(const Outline& outline) {
  internal::JoinedParts parts(outline.ring(), triangulate(outline));
  parts.join_all();
  return parts.polygons();
}

}  // namespace riprap
