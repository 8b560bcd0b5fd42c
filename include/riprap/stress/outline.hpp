#pragma once
/// @file
/// The edges of a meshed particle, for finding places on its boundary without the mesh.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/stress/mesh/mesh.hpp>

namespace riprap {

/// The boundary point nearest to a place, and how long its edge remains the nearest one.
struct OutlinePoint {
  BoundaryPoint at{};
  /// While the place moves by less than this [m], its nearest boundary point stays on the edge.
  double hold = 0;
};

/// What `Mesh::nearest_boundary_point` looks at, in one run of memory. Nodes divide an edge evenly.
class Outline {
 public:
  Outline() = default;
  explicit Outline(const Mesh& mesh) : nodes_(mesh.boundary_nodes) {
    for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
      const std::uint32_t first = mesh.corners[k];
      const std::uint32_t end = k + 1 < mesh.corners.size() ? mesh.corners[k + 1] : nodes_;
      const Vec2 along = mesh.nodes[end % nodes_] - mesh.nodes[first];
      edges_.push_back({mesh.nodes[first], along, 1 / along.dot(along), first, end - first});
    }
  }

  [[nodiscard]] std::uint32_t nodes() const { return nodes_; }

  [[nodiscard]] OutlinePoint nearest(const Vec2& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    double second = nearest;
    double place = 0;
    const Edge* best = edges_.data();
    for (const Edge& edge : edges_) {
      const Vec2 from_start = x - edge.start;
      const double along = std::clamp(edge.along.dot(from_start) * edge.inverse_square, 0.0, 1.0);
      const Vec2 off = from_start - along * edge.along;
      const double square = off.dot(off);
      if (square < nearest) {
        second = nearest;
        nearest = square;
        place = along;
        best = &edge;
      } else if (square < second) {
        second = square;
      }
    }
    place *= best->parts;
    const auto part = std::min(static_cast<std::uint32_t>(place), best->parts - 1);
    return {{best->first + part, (best->first + part + 1) % nodes_, 1 - (place - part)},
            0.5 * (std::sqrt(second) - std::sqrt(nearest))};
  }

  [[nodiscard]] std::size_t bytes() const { return edges_.capacity() * sizeof(Edge); }

 private:
  struct Edge {
    Vec2 start;
    Vec2 along;
    double inverse_square;
    std::uint32_t first;  // boundary node at its start
    std::uint32_t parts;
  };

  std::vector<Edge> edges_;
  std::uint32_t nodes_ = 0;
};

}  // namespace riprap
