// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A disc between two opposite point loads: stresses in closed form, to converge to.

#include <cmath>
#include <vector>

#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <support/polygons.hpp>

namespace riprap::test {

/// 2 kN along axis 2 on a disc of 150 mm, 1 mm thick; 64 straight sides stand for the circle and
/// leave 0.16 % of its area out.
struct BrazilianDisc {
  double force = 2000;
  double radius = 0.075;
  double thickness = 0.001;

  [[nodiscard]] Mesh mesh(unsigned triangles) const {
    return UniformMesher{triangles}(regular_polygon(64, radius).ring());
  }
  [[nodiscard]] std::vector<BoundaryLoad> loads(const Mesh& mesh) const {
    return {{nearest_boundary_point(mesh, {0, radius}), {0, -force}, force},
            {nearest_boundary_point(mesh, {0, -radius}), {0, force}, force}};
  }
  /// Of equilateral triangles that fill the disc.
  [[nodiscard]] double spacing(unsigned triangles) const {
    return radius * std::sqrt(4 * pi / std::sqrt(3.0) / triangles);
  }
  /// 2 P / (pi D t), the tension in the middle.
  [[nodiscard]] double unit() const { return force / (pi * radius * thickness); }

  /// Two radial fields of Flamant, one from each load, and a uniform tension that frees the rim:
  /// Timoshenko and Goodier, Theory of Elasticity.
  [[nodiscard]] Stress2 stress(const Vec2& x) const {
    Stress2 sum{-unit(), -unit(), 0};
    for (const double side : {1.0, -1.0}) {
      const Vec2 d = x - Vec2{0, side * radius};
      const double r2 = d.squaredNorm();
      const double f = 2 * force / (pi * thickness) * (-side * d.y()) / (r2 * r2);
      sum += f * Stress2{d.x() * d.x(), d.y() * d.y(), d.x() * d.y()};
    }
    return sum;
  }
};

/// Mean stress of the elements within `reach` of the origin.
[[nodiscard]] inline Stress2 middle_stress(const Mesh& mesh, const ElementStress& stress,
                                           double reach) {
  double area = 0;
  Stress2 sum;
  for (std::size_t e = 0; e < mesh.size(); ++e)
    if (mesh.centroid(e).norm() < reach) {
      area += mesh.area(e);
      sum += mesh.area(e) * stress[e];
    }
  return (1 / area) * sum;
}

/// Root of the mean square difference to the closed form within half the radius, over 2 P/(pi D t).
[[nodiscard]] inline double field_error(const BrazilianDisc& disc, const Mesh& mesh,
                                        const ElementStress& stress) {
  double area = 0;
  double sum = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    if (mesh.centroid(e).norm() > 0.5 * disc.radius) continue;
    Stress2 off = stress[e];
    off += -1.0 * disc.stress(mesh.centroid(e));
    area += mesh.area(e);
    sum += mesh.area(e) * (off.s11 * off.s11 + off.s22 * off.s22 + 2 * off.s12 * off.s12);
  }
  return std::sqrt(sum / area) / disc.unit();
}

}  // namespace riprap::test
