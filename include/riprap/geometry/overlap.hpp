// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The common part of two convex rings, with a note of which ring each of its edges comes from.

#include <array>
#include <cmath>
#include <cstdint>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// Where an edge of the overlap polygon comes from.
struct EdgeSource {
  bool of_b;
  std::uint8_t edge;
  friend bool operator==(const EdgeSource&, const EdgeSource&) = default;
};

/// A convex ring on the stack; edge i runs from vertex i to vertex i + 1.
struct OverlapPolygon {
  std::array<Vec2, 2 * max_polygon_vertices> vertices;
  std::array<EdgeSource, 2 * max_polygon_vertices> sources;
  std::size_t size = 0;

  [[nodiscard]] Ring ring() const { return {vertices.data(), size}; }
  void push(const Vec2& v, EdgeSource source) {
    vertices[size] = v;
    sources[size] = source;
    ++size;
  }
};

namespace internal {

/// Where the vertices of `in` lie to the line from p along `edge`: to the left, not negative. False
/// if none lies to the right: most edges cut nothing, and then nothing need be copied.
[[nodiscard]] inline bool is_cut(const OverlapPolygon& in, const Vec2& p, const Vec2& edge,
                                 std::array<double, 2 * max_polygon_vertices>& distances) {
  bool cut = false;
  for (std::size_t i = 0; i < in.size; ++i) {
    distances[i] = cross(edge, in.vertices[i] - p);
    cut |= distances[i] < 0;
  }
  return cut;
}

/// Keeps what lies to the left of a line; the new edge is labelled `cutter`. Sutherland and Hodgman
/// (1974); for convex input at most one edge is new.
/// @param distances of the vertices of `in` from the line
inline void clip_by_edge(const OverlapPolygon& in,
                         const std::array<double, 2 * max_polygon_vertices>& distances,
                         EdgeSource cutter, OverlapPolygon& out) {
  out.size = 0;
  for (std::size_t i = 0; i < in.size; ++i) {
    const std::size_t next = i + 1 == in.size ? 0 : i + 1;
    const double d = distances[i];
    const double d_next = distances[next];
    const bool inside = d >= 0;
    if (inside) out.push(in.vertices[i], in.sources[i]);
    if (inside != (d_next >= 0)) {
      const Vec2 x = in.vertices[i] + (d / (d - d_next)) * (in.vertices[next] - in.vertices[i]);
      out.push(x, inside ? cutter : in.sources[i]);
    }
  }
}

/// Copies a polygon without its edges shorter than `tolerance`: vertices that fall together carry
/// no information.
inline void copy_long_edges(const OverlapPolygon& in, double tolerance, OverlapPolygon& out) {
  for (std::size_t i = 0; i < in.size; ++i) {
    const std::size_t next = i + 1 == in.size ? 0 : i + 1;
    const Vec2 edge = in.vertices[next] - in.vertices[i];
    if (edge.dot(edge) > tolerance * tolerance) out.push(in.vertices[i], in.sources[i]);
  }
}

}  // namespace internal

/// Common part of two convex rings, in coordinates relative to `origin`; empty (size 0) where they
/// do not overlap in an area. Edges shorter than `tolerance` [m] are dropped.
[[nodiscard]] inline OverlapPolygon overlap(Ring a, Ring b, const Vec2& origin, double tolerance) {
  OverlapPolygon buffers[2];
  std::size_t current = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    buffers[0].push(a[i] - origin, {false, static_cast<std::uint8_t>(i)});
  std::array<double, 2 * max_polygon_vertices> distances;
  for (std::size_t j = 0; j < b.size() && buffers[current].size > 0; ++j) {
    const Vec2 p = b[j] - origin;
    const Vec2 edge = b[j + 1 == b.size() ? 0 : j + 1] - b[j];
    if (!internal::is_cut(buffers[current], p, edge, distances)) continue;
    internal::clip_by_edge(buffers[current], distances, {true, static_cast<std::uint8_t>(j)},
                           buffers[1 - current]);
    current = 1 - current;
  }
  OverlapPolygon common;
  internal::copy_long_edges(buffers[current], tolerance, common);
  if (common.size < 3) common.size = 0;
  return common;
}

}  // namespace riprap
