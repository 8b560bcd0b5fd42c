// SPDX-License-Identifier: BSL-1.0
// Meshes of any polygon, and the influence operators made from them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>

#include "check.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

void check_mesh(Ring ring, const Mesh& mesh) {
  mesh.validate();
  const double size = diameter(ring);
  const double area = polygon_area(ring);
  double sum = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) sum += mesh.area(e);
  check(std::abs(sum - area) <= 1e-13 * size * size, "the triangles have the area of the polygon",
        {sum, area});
  check(mesh.corners.size() == ring.size() && mesh.corners[0] == 0,
        "every vertex of the polygon is a corner of the mesh");
  for (std::size_t k = 0; k < ring.size(); ++k)
    check(mesh.nodes[mesh.corners[k]] == ring[k],
          "a corner of the mesh is a vertex of the polygon");
}

/// Longest edge squared over twice the area, at its largest: loses digits.
double worst_shape(const Mesh& mesh) {
  double worst = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const auto [p, q, r] = mesh.triangle(e);
    const double squared =
        std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    worst = std::max(worst, squared / (2 * mesh.area(e)));
  }
  return worst;
}

/// The tractions of a constant stress make that stress in every triangle.
void check_constant_stress(const InfluenceOperator& op, const Stress2& applied, double error) {
  const Mesh& mesh = op.mesh();
  ElementStress found;
  found.reset(mesh.size());
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) {
    const std::uint32_t next = (i + 1) % mesh.boundary_nodes;
    const Vec2 edge = mesh.nodes[next] - mesh.nodes[i];
    const Vec2 inwards = perpendicular(edge);  // times its length; thickness 1
    const Vec2 force{applied.s11 * inwards.x() + applied.s12 * inwards.y(),
                     applied.s12 * inwards.x() + applied.s22 * inwards.y()};
    op.add_stress({i, next, 0.5}, force, found);
  }
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Stress2 s = found[e];
    const double miss = std::max({std::abs(s.s11 - applied.s11), std::abs(s.s22 - applied.s22),
                                  std::abs(s.s12 - applied.s12)});
    check(miss <= error, "a constant stress is found in every triangle", {miss, error});
  }
}

template <class Mesher>
void check_operator(const Mesher& mesher, Ring ring, Input& input) {
  mesher.validate();
  Mesh mesh = mesher(ring);
  check_mesh(ring, mesh);
  if (mesh.nodes.size() > 200) return;  // slow
  Rock rock;
  rock.poisson = 0.49 * input.share();
  const bool with_flexibility = input.yes();
  const double shape = std::max(worst_shape(mesh), aspect(ring));
  const auto nodes = static_cast<double>(mesh.nodes.size());
  const InfluenceOperator op = input.yes()
                                   ? InfluenceOperator(std::move(mesh), ConstantStrainTriangle{},
                                                       PlaneStrain{}, rock, 1, with_flexibility)
                                   : InfluenceOperator(std::move(mesh), ConstantStrainTriangle{},
                                                       PlaneStress{}, rock, 1, with_flexibility);
  check(op.columns().allFinite(), "stresses of unit loads are finite");
  if (with_flexibility) {
    const Vec2 moved = op.displacement({0, 1, 0.25}, {1, 2, 0.5}, {1, -2});
    check(is_finite(moved), "displacements are finite", {moved.x(), moved.y()});
  }
  const double error = 1e-13 * nodes * shape * shape;
  if (error > 1e-2) return;
  const Stress2 applied{input.share(), input.share(), input.share() - 0.5};
  check_constant_stress(op, applied, error);
}

}  // namespace

void mesh(Bytes bytes) {
  Input input(bytes);
  const std::optional<ConvexPolygon> polygon = polygon_from(input);
  if (!polygon) return;
  std::vector<Vec2> vertices(polygon->begin(), polygon->end());
  const Vec2 centroid = area_properties(vertices).centroid;
  for (Vec2& v : vertices) v -= centroid;
  const std::optional<ConvexPolygon> centred = try_convex_polygon(vertices);
  if (!centred) return;
  const unsigned kind = input.byte();
  if ((kind & 1U) != 0)
    check_operator(FanMesher{.edge_divisions = 1 + kind / 2 % 3}, centred->ring(), input);
  else if (aspect(centred->ring()) <= 1e5)
    check_operator(UniformMesher{.triangles = 4 + kind / 2 % 37}, centred->ring(), input);
}

}  // namespace riprap::fuzz
