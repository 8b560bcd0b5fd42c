// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Vertices and edges of cells that are to fill a polygon.

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap::test {

/// What cells have in common, by the bits of their vertices.
class CellComplex {
 public:
  using Point = std::pair<double, double>;
  using Edge = std::pair<Point, Point>;

  explicit CellComplex(const std::vector<ConvexPolygon>& cells) : cells_(cells.size()) {
    for (const ConvexPolygon& cell : cells) {
      area_ += polygon_area(cell.ring());
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const Point p = point(cell[k]);
        vertices_.insert(p);
        ++times_[{p, point(cell[(k + 1) % cell.size()])}];
      }
    }
  }

  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }
  /// Every edge that one cell or two have.
  [[nodiscard]] std::size_t edges() const {
    return times_.size() - (times_.size() - boundary().size()) / 2;
  }
  /// Edges of one cell alone, each with that cell to its left.
  [[nodiscard]] std::vector<Edge> boundary() const {
    std::vector<Edge> out;
    for (const auto& entry : times_)
      if (!times_.contains({entry.first.second, entry.first.first})) out.push_back(entry.first);
    return out;
  }
  [[nodiscard]] double boundary_length() const {
    double sum = 0;
    for (const Edge& e : boundary())
      sum += (Vec2{e.second.first, e.second.second} - Vec2{e.first.first, e.first.second}).norm();
    return sum;
  }
  /// No edge twice in one direction.
  [[nodiscard]] bool edges_are_once() const {
    for (const auto& entry : times_)
      if (entry.second != 1) return false;
    return true;
  }
  /// Euler's number of vertices less edges plus cells: 1 of a disc without holes.
  [[nodiscard]] long euler() const {
    return static_cast<long>(vertices()) - static_cast<long>(edges()) + static_cast<long>(cells());
  }

 private:
  [[nodiscard]] static Point point(const Vec2& v) { return {v.x(), v.y()}; }

  std::size_t cells_;
  double area_ = 0;
  std::set<Point> vertices_{};
  std::map<Edge, int> times_{};
};

}  // namespace riprap::test
