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
  bool of_b = false;
  std::uint8_t edge = 0;
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

/// Keeps what lies to the left of the line from p along `edge`; the new edge is labelled `cutter`.
/// Sutherland and Hodgman (1974); for convex input at most one edge is new.
inline void clip_by_edge(const OverlapPolygon& in, const Vec2& p, const Vec2& edge,
                         EdgeSource cutter, OverlapPolygon& out) {
  out.size = 0;
  double d = cross(edge, in.vertices[0] - p);
  const double d_first = d;
  for (std::size_t i = 0; i < in.size; ++i) {
    const std::size_t next = i + 1 == in.size ? 0 : i + 1;
    const double d_next = next == 0 ? d_first : cross(edge, in.vertices[next] - p);
    const bool inside = d >= 0;
    if (inside) out.push(in.vertices[i], in.sources[i]);
    if (inside != (d_next >= 0)) {
      const Vec2 x = in.vertices[i] + (d / (d - d_next)) * (in.vertices[next] - in.vertices[i]);
      out.push(x, inside ? cutter : in.sources[i]);
    }
    d = d_next;
  }
}

/// Drops edges shorter than `tolerance`: vertices that fall together carry no information.
inline void drop_short_edges(OverlapPolygon& polygon, double tolerance) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const std::size_t next = i + 1 == polygon.size ? 0 : i + 1;
    const Vec2 edge = polygon.vertices[next] - polygon.vertices[i];
    if (edge.dot(edge) <= tolerance * tolerance) continue;
    polygon.vertices[kept] = polygon.vertices[i];
    polygon.sources[kept] = polygon.sources[i];
    ++kept;
  }
  polygon.size = kept;
}

}  // namespace internal

/// Common part of two convex rings, in coordinates relative to `origin`; empty (size 0) where they
/// do not overlap in an area. Edges shorter than `tolerance` [m] are dropped.
[[nodiscard]] inline OverlapPolygon overlap(Ring a, Ring b, const Vec2& origin, double tolerance) {
  OverlapPolygon buffers[2];
  std::size_t current = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    buffers[0].push(a[i] - origin, {false, static_cast<std::uint8_t>(i)});
  for (std::size_t j = 0; j < b.size() && buffers[current].size > 0; ++j) {
    const Vec2 p = b[j] - origin;
    const Vec2 edge = b[j + 1 == b.size() ? 0 : j + 1] - b[j];
    internal::clip_by_edge(buffers[current], p, edge, {true, static_cast<std::uint8_t>(j)},
                           buffers[1 - current]);
    current = 1 - current;
  }
  internal::drop_short_edges(buffers[current], tolerance);
  if (buffers[current].size < 3) buffers[current].size = 0;
  return buffers[current];
}

}  // namespace riprap
