// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Where in a particle its stress is sampled.

#include <cstddef>
#include <span>

#include <riprap/stress/element/triangle_point.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// A point at which stress is evaluated, and the area that it stands for.
struct SamplingPoint {
  Vec2 position{0, 0};  ///< in the body's own frame [m]
  double area = 0;      ///< [m^2]
};

/// The sampling points of all triangles of a mesh, in the order of ElementStress: those of the
/// first triangle, then those of the second. Refers to the mesh.
class SamplingPoints {
 public:
  /// @param rule of every triangle, in static memory; by default its centroid
  explicit SamplingPoints(const Mesh& mesh, std::span<const TrianglePoint> rule = centroid_rule)
      : mesh_(&mesh), rule_(rule) {}
  explicit SamplingPoints(const Mesh&&,
                          std::span<const TrianglePoint> = {}) = delete;  // would outlive it

  [[nodiscard]] std::size_t size() const { return mesh_->size() * rule_.size(); }
  [[nodiscard]] std::size_t triangle(std::size_t i) const { return i / rule_.size(); }
  [[nodiscard]] Vec2 position(std::size_t i) const {
    return rule_[i % rule_.size()].position(mesh_->triangle(triangle(i)));
  }
  [[nodiscard]] double area(std::size_t i) const {
    return rule_[i % rule_.size()].share * mesh_->area(triangle(i));
  }
  [[nodiscard]] SamplingPoint operator[](std::size_t i) const { return {position(i), area(i)}; }

 private:
  const Mesh* mesh_;
  std::span<const TrianglePoint> rule_;
};

}  // namespace riprap
