// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Meshed particles, loads on them, and the stresses that come out.

#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

namespace riprap::test {

/// Blunter and with more vertices than the default.
inline constexpr PolygonShape blunt_shape{5, 9, 0.5, 1, 0.5};

/// Mesh of a random polygon with the area of a circle of 16 mm.
[[nodiscard]] inline Mesh random_mesh(Random& random, unsigned triangles) {
  const PolygonShape shape = random.uniform_integer(0, 1) == 0 ? PolygonShape{} : blunt_shape;
  return UniformMesher{triangles}(random_polygon(shape, 0.016, random).ring());
}

/// Forces up to 1 kN at random places between boundary nodes; nothing is balanced.
[[nodiscard]] inline std::vector<BoundaryLoad> random_loads(const Mesh& mesh, unsigned count,
                                                            Random& random) {
  std::vector<BoundaryLoad> loads;
  for (unsigned i = 0; i < count; ++i) {
    const std::uint32_t node = random.uniform_integer(0, mesh.boundary_nodes - 1);
    const Vec2 force{random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)};
    loads.push_back({{node, (node + 1) % mesh.boundary_nodes, random.uniform(0, 1)},
                     force,
                     random.uniform(0, 1e3)});
  }
  return loads;
}

[[nodiscard]] inline Vec2 net_force(std::span<const BoundaryLoad> loads) {
  Vec2 sum{0, 0};
  for (const BoundaryLoad& load : loads) sum += load.force_body;
  return sum;
}

[[nodiscard]] inline double net_moment(std::span<const BoundaryLoad> loads, const Mesh& mesh,
                                       const Vec2& about) {
  double sum = 0;
  for (const BoundaryLoad& load : loads)
    sum += cross(mesh.position(load.at) - about, load.force_body);
  return sum;
}

/// Changes the forces by a common force and a common turn so that nothing is left over.
inline void balance(std::span<BoundaryLoad> loads, const Mesh& mesh) {
  const auto count = static_cast<double>(loads.size());
  Vec2 centre{0, 0};
  for (const BoundaryLoad& load : loads) centre += mesh.position(load.at) / count;
  double spread = 0;
  for (const BoundaryLoad& load : loads) spread += (mesh.position(load.at) - centre).squaredNorm();
  const Vec2 push = -net_force(loads) / count;
  const double turn = -net_moment(loads, mesh, centre) / spread;
  for (BoundaryLoad& load : loads)
    load.force_body += push + turn * perpendicular(mesh.position(load.at) - centre);
}

[[nodiscard]] inline ElementStress stress_of(const InfluenceOperator& op,
                                             std::span<const BoundaryLoad> loads) {
  ElementStress stress;
  stress.reset(op.sampling_points().size());
  for (const BoundaryLoad& load : loads) op.add_stress(load.at, load.force_body, stress);
  return stress;
}

/// Largest difference of a component over the largest component of `expected`.
[[nodiscard]] inline double relative_difference(const ElementStress& stress,
                                                const ElementStress& expected) {
  if (stress.size() != expected.size()) return 1;
  return (stress.values() - expected.values()).cwiseAbs().maxCoeff() /
         expected.values().cwiseAbs().maxCoeff();
}

/// Nodes turned about the origin; the triangles keep their numbers.
[[nodiscard]] inline Mesh turned(Mesh mesh, const Rotation& rotation) {
  for (Vec2& x : mesh.nodes) x = rotation * x;
  return mesh;
}

/// Nodes drawn apart from the origin: the same body in other units of length.
[[nodiscard]] inline Mesh scaled(Mesh mesh, double factor) {
  for (Vec2& x : mesh.nodes) x *= factor;
  return mesh;
}

/// The material of `mesh`, element by element, mirrored in axis 2. The boundary nodes now run
/// clockwise, on which neither elements nor loads depend.
[[nodiscard]] inline Mesh mirror_image(Mesh mesh) {
  for (Vec2& x : mesh.nodes) x.x() = -x.x();
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace riprap::test
