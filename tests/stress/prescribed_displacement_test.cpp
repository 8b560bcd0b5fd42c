// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/prescribed_displacement.hpp>

#include <doctest/doctest.h>

#include <numeric>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;
using test::relative_difference;

namespace {

constexpr double thickness = 0.016;

template <PlaneState P = PlaneStress>
using Prescribed = PrescribedDisplacement<ConstantStrainTriangle, P>;

// Both components of the nodes.
std::vector<NodeComponent> fixed(const std::vector<std::uint32_t>& nodes) {
  std::vector<NodeComponent> held;
  for (const std::uint32_t node : nodes) {
    held.push_back({node, 0});
    held.push_back({node, 1});
  }
  return held;
}

std::vector<double> random_values(std::size_t count, Random& random) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(random.uniform(-1e-5, 1e-5));
  return values;
}

// Stress, compression positive, of the strain (0.001, -0.002, 2 x 0.0005), by hand.
template <PlaneState P>
void check_uniform(const Mesh& mesh, const Stress2& expected) {
  std::vector<std::uint32_t> rim;
  for (std::uint32_t n = 0; n < mesh.boundary_nodes; ++n) rim.push_back(n);
  const Prescribed<P> solver(mesh, {}, {}, Rock{.young = 70e9, .poisson = 0.25}, thickness,
                             fixed(rim));
  std::vector<double> values;
  for (const std::uint32_t n : rim) {
    const Vec2 x = mesh.nodes[n];
    values.push_back(0.001 * x.x() + 0.0007 * x.y());
    values.push_back(0.0003 * x.x() - 0.002 * x.y());
  }
  const Deformation d = solver.solve(values);
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    // Round-off of stresses of 1e8 Pa.
    CHECK(d.stress[e].s11 == near(expected.s11, 1e-4));
    CHECK(d.stress[e].s22 == near(expected.s22, 1e-4));
    CHECK(d.stress[e].s12 == near(expected.s12, 1e-4));
  }
}

}  // namespace

TEST_CASE("a linear field on the boundary gives the uniform stress of Hooke's law inside") {
  Random random(301);
  const Mesh mesh = test::random_mesh(random, 200);
  // E / (1 - nu^2) (e1 + nu e2), 2 G e12; and with lambda and 2 G = 56 GPa in plane strain, where
  // lambda = 28 GPa.
  const double factor = 70e9 / (1 - 0.0625);
  check_uniform<PlaneStress>(mesh, {-factor * 0.0005, factor * 0.00175, -28e6});
  check_uniform<PlaneStrain>(mesh, {-28e6, 140e6, -28e6});
}

TEST_CASE("the forces that hold it, put on a free particle as loads, give the same stress") {
  Random random(302);
  for (int sample = 0; sample < 10; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const auto held = fixed({0, 3, mesh.boundary_nodes / 2});
    const Prescribed<> solver(mesh, {}, {}, Rock{}, thickness, held);
    const Deformation d = solver.solve(random_values(held.size(), random));
    std::vector<BoundaryLoad> loads;
    Vec2 sum{0, 0};
    double largest = 0;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
      const Vec2 force = d.force(n);
      sum += force;
      largest = std::max(largest, force.norm());
      if (force.norm() > 0) loads.push_back({{n, (n + 1) % mesh.boundary_nodes, 1}, force});
    }
    CHECK(loads.size() == 3);
    CHECK(sum.norm() <= 1e-11 * largest);  // round-off through a condition number of some 1e4
    AssembleAndSolve<ConstantStrainTriangle, PlaneStress> direct(
        mesh, {}, {}, Rock{}, thickness, DeterminateSupport::on_opposite_sides(mesh));
    ElementStress free;
    direct.solve_free(loads, free);
    CHECK(relative_difference(d.stress, free) <= 1e-9);
  }
}

TEST_CASE("what is prescribed is kept, and the forces are those of a potential") {
  Random random(303);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto held = fixed({1, 5, 9, 12});
  const Prescribed<> solver(mesh, {}, {}, Rock{}, thickness, held);
  const auto first = random_values(held.size(), random);
  const auto second = random_values(held.size(), random);
  const Deformation a = solver.solve(first);
  const Deformation b = solver.solve(second);
  double forth = 0;
  double back = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    CHECK(a.displacement(held[i].node)[held[i].axis] == first[i]);
    forth += first[i] * b.force(held[i].node)[held[i].axis];
    back += second[i] * a.force(held[i].node)[held[i].axis];
  }
  CHECK(forth == test::near_relative(back, 1e-9));  // Betti; the terms are of both signs
  Deformation twice = a;
  twice.scale(2);
  CHECK(twice.stress.values() == 2 * a.stress.values());
  CHECK(twice.force(5) == 2 * a.force(5));
}

TEST_CASE("where every node is held there is nothing to solve") {
  Random random(305);
  const Mesh mesh = test::random_mesh(random, 20);
  std::vector<std::uint32_t> all(mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto held = fixed(all);
  const Prescribed<> solver(mesh, {}, {}, Rock{}, thickness, held);
  const auto values = random_values(held.size(), random);
  const Deformation d = solver.solve(values);
  for (std::size_t i = 0; i < held.size(); ++i)
    CHECK(d.displacement(held[i].node)[held[i].axis] == values[i]);
}

TEST_CASE("bad input is named") {
  Random random(304);
  const Mesh mesh = test::random_mesh(random, 50);
  const auto make = [&](std::vector<NodeComponent> held, double t = thickness) {
    return test::message_of([&] { Prescribed<>(mesh, {}, {}, Rock{}, t, held); });
  };
  CHECK(test::contains(make(fixed({0, 2}), 0), "PrescribedDisplacement.thickness = 0"));
  CHECK(test::contains(make({{9999, 0}}), "NodeComponent.node = 9999"));
  CHECK(test::contains(make({{0, 2}}), "NodeComponent.axis = 2"));
  CHECK(test::contains(make({{4, 1}, {4, 1}}), "NodeComponent.node = 4: must not be held twice"));
  // Free to turn about a node, or to move along axis 1.
  CHECK_THROWS_AS(Prescribed<>(mesh, {}, {}, Rock{}, thickness, fixed({0})), SimulationError);
  CHECK_THROWS_AS(Prescribed<>(mesh, {}, {}, Rock{}, thickness, {{0, 1}, {5, 1}, {9, 1}}),
                  SimulationError);
  const Prescribed<> solver(mesh, {}, {}, Rock{}, thickness, fixed({0, 2}));
  CHECK(test::contains(test::message_of([&] { (void)solver.solve(std::vector<double>(3)); }),
                       "count of values = 3"));
}
