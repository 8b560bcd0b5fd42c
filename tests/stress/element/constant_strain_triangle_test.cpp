// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/element/constant_strain_triangle.hpp>

#include <Eigen/LU>
#include <doctest/doctest.h>

#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

using Nodal = Eigen::Matrix<double, 6, 1>;

constexpr double thickness = 0.016;

std::vector<std::array<Vec2, 3>> triangles() {
  std::vector<std::array<Vec2, 3>> all{{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}};
  Random random(3);
  while (all.size() < 40) {
    const auto place = [&] { return Vec2{random.uniform(-1, 1), random.uniform(-1, 1)}; };
    const std::array<Vec2, 3> t{place(), place(), place()};
    if (cross(t[1] - t[0], t[2] - t[0]) > 0.1) all.push_back(t);
  }
  return all;
}

// Any mesh: inner nodes are moved at random, by too little to turn a triangle over.
Mesh shaken_mesh(Random& random) {
  Mesh mesh = test::random_mesh(random, 60);
  double edge = 1e300;
  for (std::size_t e = 0; e < mesh.size(); ++e) edge = std::min(edge, std::sqrt(mesh.area(e)));
  for (std::size_t i = mesh.boundary_nodes; i < mesh.nodes.size(); ++i)
    mesh.nodes[i] += 0.3 * edge * Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
  for (std::size_t e = 0; e < mesh.size(); ++e) REQUIRE(mesh.area(e) > 0);
  return mesh;
}

Eigen::Index unknown(std::size_t node, int axis) {
  return 2 * static_cast<Eigen::Index>(node) + axis;
}

// Nodal forces that are consistent with the tractions of a uniform stress (tension positive): each
// node has half of the traction on either side.
Eigen::VectorXd traction_forces(const Mesh& mesh, const Eigen::Vector3d& stress) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(unknown(mesh.nodes.size(), 0));
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) {
    const std::uint32_t next = (i + 1) % mesh.boundary_nodes;
    const Vec2 area = -thickness * perpendicular(mesh.nodes[next] - mesh.nodes[i]);
    const Vec2 force{stress[0] * area.x() + stress[2] * area.y(),
                     stress[2] * area.x() + stress[1] * area.y()};
    for (const std::uint32_t node : {i, next}) forces.segment<2>(unknown(node, 0)) += 0.5 * force;
  }
  return forces;
}

// Displacements of all nodes, with three constraints at the first and the last boundary node.
Eigen::VectorXd displacements(const Mesh& mesh, const Eigen::Matrix3d& elasticity,
                              Eigen::VectorXd forces) {
  const Eigen::Index n = forces.size();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const StrainDisplacement<3> b = ConstantStrainTriangle{}.strain_displacement(mesh.triangle(e));
    const Eigen::Matrix<double, 6, 6> k = thickness * mesh.area(e) * b.transpose() * elasticity * b;
    for (int p = 0; p < 6; ++p)
      for (int q = 0; q < 6; ++q)
        stiffness(unknown(mesh.triangles[e][static_cast<std::size_t>(p / 2)], p % 2),
                  unknown(mesh.triangles[e][static_cast<std::size_t>(q / 2)], q % 2)) += k(p, q);
  }
  const double unit = stiffness(0, 0);
  const std::size_t guided = mesh.boundary_nodes / 2;
  const Vec2 line = mesh.nodes[guided] - mesh.nodes[0];
  const int across = std::abs(line.x()) > std::abs(line.y()) ? 1 : 0;
  for (const Eigen::Index held : {unknown(0, 0), unknown(0, 1), unknown(guided, across)}) {
    stiffness.row(held).setZero();
    stiffness.col(held).setZero();
    stiffness(held, held) = unit;
    forces[held] = 0;
  }
  return stiffness.partialPivLu().solve(forces);
}

Eigen::Vector3d strain(const Mesh& mesh, std::size_t e, const Eigen::VectorXd& displacement) {
  Nodal nodal;
  for (int k = 0; k < 6; ++k)
    nodal[k] = displacement[unknown(mesh.triangles[e][static_cast<std::size_t>(k / 2)], k % 2)];
  return ConstantStrainTriangle{}.strain_displacement(mesh.triangle(e)) * nodal;
}

}  // namespace

TEST_CASE("the unit right triangle has the strain-displacement matrix of the textbook") {
  StrainDisplacement<3> expected;
  expected << -1, 0, 1, 0, 0, 0,  //
      0, -1, 0, 0, 0, 1,          //
      -1, -1, 0, 1, 1, 0;
  CHECK(ConstantStrainTriangle{}.strain_displacement({Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) ==
        expected);
}

TEST_CASE("a linear field of displacements has its own gradient as strain, in any triangle") {
  Eigen::Matrix2d gradient;
  gradient << 1e-3, -4e-3, 2e-3, 5e-3;
  for (const auto& t : triangles()) {
    Nodal nodal;
    for (int k = 0; k < 3; ++k)
      nodal.segment<2>(2 * k) = Vec2{0.3, -0.2} + gradient * t[static_cast<std::size_t>(k)];
    const Eigen::Vector3d found = ConstantStrainTriangle{}.strain_displacement(t) * nodal;
    // Round-off of displacements of 0.3 m over heights of 0.05 m and more.
    CHECK((found - Eigen::Vector3d{1e-3, 5e-3, -2e-3}).norm() <= 1e-14);
  }
}

TEST_CASE("rigid motions cause no strain") {
  for (const auto& t : triangles()) {
    Nodal shift;
    Nodal turn;
    for (int k = 0; k < 3; ++k) {
      shift.segment<2>(2 * k) = Vec2{2, -3};
      turn.segment<2>(2 * k) = perpendicular(t[static_cast<std::size_t>(k)]);
    }
    const StrainDisplacement<3> b = ConstantStrainTriangle{}.strain_displacement(t);
    CHECK((b * shift).norm() <= 1e-14 * b.norm());
    CHECK((b * turn).norm() <= 1e-14 * b.norm());
  }
}

TEST_CASE("the mass matrix integrates products of shape functions") {
  // In the middle of an edge the functions of its ends are 1/2 and the third is 0; the mean of the
  // three middles integrates quadratics exactly.
  Eigen::Matrix3d integral = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& middle :
       {Eigen::Vector3d{0.5, 0.5, 0}, Eigen::Vector3d{0, 0.5, 0.5}, Eigen::Vector3d{0.5, 0, 0.5}})
    integral += middle * middle.transpose() / 3;
  for (const auto& t : triangles()) {
    const double area = 0.5 * cross(t[1] - t[0], t[2] - t[0]);
    const NodalMass<3> mass = ConstantStrainTriangle{}.mass(t);
    CHECK((mass - area * integral).norm() <= 1e-15 * area);
    CHECK(mass.sum() == near_relative(area, 1e-15));
  }
}

// Table 1 of Bagherzadeh-Khalkhali et al. (2008): 70 GPa, 0.17; strains by Hooke's law.
TEST_CASE("patch test: 100 MPa of pressure along axis 2 strain all elements of any mesh alike") {
  const Eigen::Vector3d stress{0, -100e6, 0};
  Random random(21);
  for (int sample = 0; sample < 10; ++sample) {
    const Mesh mesh = shaken_mesh(random);
    const Eigen::VectorXd forces = traction_forces(mesh, stress);

    const Eigen::Matrix3d thin = PlaneStress{}.elasticity(Rock{});
    const Eigen::VectorXd in_plane_stress = displacements(mesh, thin, forces);
    const Eigen::Matrix3d thick = PlaneStrain{}.elasticity(Rock{});
    const Eigen::VectorXd in_plane_strain = displacements(mesh, thick, forces);
    for (std::size_t e = 0; e < mesh.size(); ++e) {
      const Eigen::Vector3d a = strain(mesh, e, in_plane_stress);
      CHECK((a - Eigen::Vector3d{0.17 / 700, -1.0 / 700, 0}).norm() <= 1e-12 / 700);
      CHECK(a[1] == near_relative(-1.4285714e-3, 1e-7));  // printed digits
      CHECK(a[0] == near_relative(2.4285714e-4, 1e-7));
      CHECK((thin * a - stress).norm() <= 1e-12 * stress.norm());

      const Eigen::Vector3d b = strain(mesh, e, in_plane_strain);
      CHECK(b[1] == near_relative(-1.3872857e-3, 1e-7));
      CHECK(b[0] == near_relative(2.8414286e-4, 1e-7));
      const Eigen::Vector3d c = thick * b;
      CHECK((c - stress).norm() <= 1e-12 * stress.norm());
      // 17 MPa of pressure out of plane: compression positive as everywhere outside the element.
      CHECK(PlaneStrain{}.out_of_plane_stress(Rock{}, {-c[0], -c[1], -c[2]}) ==
            near_relative(17e6, 1e-12));
    }
  }
}

TEST_CASE("patch test: any uniform stress comes out uniform") {
  Random random(22);
  for (int sample = 0; sample < 10; ++sample) {
    const Mesh mesh = shaken_mesh(random);
    const Eigen::Vector3d stress{random.uniform(-1e8, 1e8), random.uniform(-1e8, 1e8),
                                 random.uniform(-1e8, 1e8)};
    const Rock rock{random.uniform(1e9, 1e11), random.uniform(0, 0.45), 2500};
    const Eigen::Matrix3d elasticity = PlaneStrain{}.elasticity(rock);
    const Eigen::VectorXd found = displacements(mesh, elasticity, traction_forces(mesh, stress));
    for (std::size_t e = 0; e < mesh.size(); ++e)
      // Ten times more than above: near nu = 1/2 the matrix is worse conditioned.
      CHECK((elasticity * strain(mesh, e, found) - stress).norm() <= 1e-11 * stress.norm());
  }
}
