// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/element/linear_strain_triangle.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/prescribed_displacement.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <support/brazilian_disc.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near;
using test::near_relative;
using test::relative_difference;
using test::stress_of;

namespace {

constexpr LinearStrainTriangle element{};
constexpr double thickness = 0.016;

// Condition numbers of some 1e5 times the unit round-off, times some tens of operations.
constexpr double round_off = 1e-9;

InfluenceOperator operator_of(const Mesh& mesh, double t = thickness, const Rock& rock = {}) {
  return {mesh, element, PlaneStress{}, rock, t, false};
}

double largest(const ElementStress& stress) { return stress.values().cwiseAbs().maxCoeff(); }

double difference(const Stress2& a, const Stress2& b) {
  return std::max({std::abs(a.s11 - b.s11), std::abs(a.s22 - b.s22), std::abs(a.s12 - b.s12)});
}

// A polynomial in the barycentric coordinates.
struct Term {
  double factor;
  std::array<int, 3> powers;
};
using Polynomial = std::vector<Term>;

// L_k (2 L_k - 1) of the corners, 4 L_k L_k+1 of the middles.
Polynomial shape_function(std::size_t node) {
  const std::size_t k = node % 3;
  std::array<int, 3> first{};
  first[k] = 1;
  std::array<int, 3> second = first;
  second[node < 3 ? k : (k + 1) % 3] += 1;
  if (node < 3) return {{2, second}, {-1, first}};
  return {{4, second}};
}

// Over the area A: the integral of L1^a L2^b L3^c is 2 A a! b! c! / (a + b + c + 2)!.
double integral(const Polynomial& p, const Polynomial& q) {
  double sum = 0;
  for (const Term& s : p)
    for (const Term& t : q) {
      double numerator = 2 * s.factor * t.factor;
      int degree = 2;
      for (std::size_t k = 0; k < 3; ++k) {
        const int power = s.powers[k] + t.powers[k];
        numerator *= std::tgamma(power + 1);
        degree += power;
      }
      sum += numerator / std::tgamma(degree + 1);
    }
  return sum;
}

// Pure bending: s11 = k y, all else 0. With u = (k x y, -k (x^2 + nu y^2) / 2) / E it is exact.
struct Bending {
  double slope = 2e9;  // [Pa/m], compression positive
  double length = 0.03;
  double height = 0.01;

  [[nodiscard]] Mesh corners(unsigned triangles) const {
    return UniformMesher{triangles}(test::rectangle(length, height).ring());
  }
  [[nodiscard]] Mesh mesh(unsigned triangles) const {
    return with_mid_side_nodes(corners(triangles));
  }
  // Of both ends, at the nodes of each side, whose shape functions times a linear traction
  // Simpson's rule integrates exactly: 1/6, 4/6 and 1/6 of the traction at the node.
  [[nodiscard]] std::vector<BoundaryLoad> loads(const Mesh& mesh) const {
    std::vector<BoundaryLoad> all;
    for (std::uint32_t p = 0; p < mesh.boundary_nodes; p += 2) {
      const std::array<std::uint32_t, 3> side{p, p + 1, (p + 2) % mesh.boundary_nodes};
      const Vec2 along = mesh.nodes[side[2]] - mesh.nodes[p];
      if (std::abs(along.x()) > 1e-9) continue;
      const double inwards = mesh.nodes[p].x() > 0 ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const double part = (k == 1 ? 4.0 : 1.0) / 6 * along.norm() * thickness;
        const double force = part * inwards * slope * mesh.nodes[side[k]].y();
        all.push_back({{side[k], (side[k] + 1) % mesh.boundary_nodes, 1}, {force, 0}, 0});
      }
    }
    return all;
  }
  template <class Points>
  [[nodiscard]] double error(const Points& points, const ElementStress& stress) const {
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      worst = std::max(worst, difference(stress[i], {slope * points.position(i).y(), 0, 0}));
    return worst / (0.5 * slope * height);
  }
};

// All boundary nodes held as a field has it.
template <class E, class Field>
Deformation held(const Mesh& mesh, const E& of, const Rock& rock, Field&& field) {
  std::vector<NodeComponent> components;
  std::vector<double> values;
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i)
    for (const std::uint32_t axis : {0u, 1u}) {
      components.push_back({i, axis});
      values.push_back(field(mesh.nodes[i])[axis]);
    }
  return PrescribedDisplacement(mesh, of, PlaneStress{}, rock, thickness, components).solve(values);
}

}  // namespace

TEST_CASE("its mass is the integral of the products of its shape functions") {
  const std::array<Vec2, 3> corners{Vec2{0, 0}, Vec2{3, 1}, Vec2{1, 4}};
  const double area = 5.5;
  const NodalMass<6> mass = element.mass(corners);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      CHECK(mass(static_cast<int>(i), static_cast<int>(j)) ==
            near(area * integral(shape_function(i), shape_function(j)), 1e-15 * area));
}

TEST_CASE("a quadratic field of displacements has its own gradient as strain, at any point") {
  Random random(1);
  const auto number = [&random] { return random.uniform(-1, 1); };
  for (int sample = 0; sample < 100; ++sample) {
    const std::array<Vec2, 3> corners{Vec2{number() - 2, number()}, Vec2{number() + 2, number()},
                                      Vec2{number(), number() + 4}};
    // u_i = g_i x + x H_i x.
    std::array<Eigen::Vector2d, 2> g{Eigen::Vector2d{number(), number()},
                                     Eigen::Vector2d{number(), number()}};
    std::array<Eigen::Matrix2d, 2> h;
    for (auto& m : h) {
      const double off = number();
      m << number(), off, off, number();
    }
    Eigen::Matrix<double, 12, 1> nodal;
    for (int k = 0; k < 6; ++k) {
      const auto c = static_cast<std::size_t>(k % 3);
      const Eigen::Vector2d x = k < 3 ? Eigen::Vector2d(corners[c])
                                      : Eigen::Vector2d(0.5 * (corners[c] + corners[(c + 1) % 3]));
      for (int axis = 0; axis < 2; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        nodal[2 * k + axis] = g[a].dot(x) + x.dot(h[a] * x);
      }
    }
    const double p = random.uniform(0, 1);
    const double q = random.uniform(0, 1 - p);
    const TrianglePoint point{{p, q, 1 - p - q}, 1};
    const Eigen::Vector2d x = point.position(corners);
    const Eigen::Vector2d du = g[0] + 2 * h[0] * x;
    const Eigen::Vector2d dv = g[1] + 2 * h[1] * x;
    const Eigen::Vector3d strain = element.strain_displacement(corners, point.at) * nodal;
    // Round-off of displacements of up to 60 m over heights of 2 m and more.
    CHECK((strain - Eigen::Vector3d{du.x(), dv.y(), du.y() + dv.x()}).norm() <= 1e-12);
  }
}

TEST_CASE("patch test: boundary displacements that are linear give a uniform stress") {
  Random random(2);
  const Rock rock{70e9, 0.17, 2500};
  const Eigen::Vector3d strain{1e-3, -2e-3, 5e-4};
  const Eigen::Vector3d tension = PlaneStress{}.elasticity(rock) * strain;
  for (int sample = 0; sample < 5; ++sample) {
    const Mesh mesh = with_mid_side_nodes(test::random_mesh(random, 40));
    const Deformation d = held(mesh, element, rock, [&](const Vec2& x) {
      return Vec2{strain[0] * x.x() + strain[2] * x.y(), strain[1] * x.y()};
    });
    REQUIRE(d.stress.size() == 4 * mesh.size());
    for (std::size_t i = 0; i < d.stress.size(); ++i)
      CHECK(difference(d.stress[i], {-tension[0], -tension[1], -tension[2]}) <=
            round_off * tension.norm());
  }
}

TEST_CASE("pure bending is exact, for prescribed displacements and for forces on the ends") {
  const Bending bending;
  const Rock rock{70e9, 0.25, 2500};
  const auto field = [&](const Vec2& x) {
    return Vec2(-bending.slope / rock.young *
                Vec2{x.x() * x.y(), -0.5 * (x.x() * x.x() + 0.25 * x.y() * x.y())});
  };
  for (const unsigned triangles : {10u, 60u}) {
    const Mesh mesh = bending.mesh(triangles);
    const SamplingPoints points(mesh, LinearStrainTriangle::sampling_points);
    CHECK(bending.error(points, held(mesh, element, rock, field).stress) <= round_off);
    const InfluenceOperator op = operator_of(mesh, thickness, rock);
    CHECK(bending.error(op.sampling_points(), stress_of(op, bending.loads(mesh))) <= round_off);
  }
  // Constant strain is far off in some element, on four times as many.
  const Mesh fine = bending.corners(240);
  CHECK(bending.error(SamplingPoints(fine),
                      held(fine, ConstantStrainTriangle{}, rock, field).stress) >= 0.05);
}

TEST_CASE("the operator gives what assembling and solving gives, balanced or not") {
  Random random(3);
  for (int sample = 0; sample < 10; ++sample) {
    const Mesh mesh =
        with_mid_side_nodes(test::random_mesh(random, random.uniform_integer(10, 60)));
    const Rock rock{random.uniform(1e9, 1e11), random.uniform(0, 0.4), random.uniform(1e3, 4e3)};
    const auto loads = test::random_loads(mesh, random.uniform_integer(1, 7), random);
    const auto compare = [&](const auto& plane) {
      AssembleAndSolve direct(mesh, element, plane, rock, thickness,
                              DeterminateSupport::on_opposite_sides(mesh));
      ElementStress expected;
      direct.solve_free(loads, expected);
      const InfluenceOperator op(mesh, element, plane, rock, thickness, false);
      CHECK(relative_difference(stress_of(op, loads), expected) <= round_off);
    };
    compare(PlaneStress{});
    compare(PlaneStrain{});
  }
}

TEST_CASE(
    "without a support a particle is held by opposite nodes of the mesh with mid-side nodes") {
  Random random(31);
  const Mesh coarse = test::random_mesh(random, 30);
  const Mesh mesh = with_mid_side_nodes(coarse);
  const auto loads = test::random_loads(mesh, 4, random);
  const auto stress_of_direct = [&](AssembleAndSolve<LinearStrainTriangle, PlaneStress>&& direct) {
    ElementStress stress;
    direct.solve_free(loads, stress);
    return stress;
  };
  const PlaneStress plane;
  const ElementStress stress = stress_of_direct({coarse, element, plane, Rock{}, thickness});
  const auto held = [&](const DeterminateSupport& support) {
    return stress_of_direct({coarse, element, plane, Rock{}, thickness, support});
  };
  // The same bytes; other nodes change the round-off, those of the coarse mesh by their numbers.
  CHECK(stress.values() == held(DeterminateSupport::on_opposite_sides(mesh)).values());
  CHECK(stress.values() != held(DeterminateSupport::on_opposite_sides(coarse)).values());
}

TEST_CASE("pinned contacts take the forces that Lagrange multipliers give them") {
  Random random(4);
  for (int sample = 0; sample < 5; ++sample) {
    const Mesh mesh = with_mid_side_nodes(test::random_mesh(random, 30));
    const InfluenceOperator op(mesh, element, PlaneStress{}, Rock{}, thickness, true);
    std::vector<BoundaryLoad> loads = test::random_loads(mesh, 5, random);
    const TwoPinnedContacts support{TwoPinnedContacts::Choice::largest_normal_forces};
    loads[1].normal_force = loads[3].normal_force = 1e4;
    if ((mesh.position(loads[1].at) - mesh.position(loads[3].at)).norm() < 2e-3) continue;
    AssembleAndSolve direct(mesh, element, PlaneStress{}, Rock{}, thickness,
                            DeterminateSupport::on_opposite_sides(mesh));
    ElementStress expected;
    std::vector<BoundaryLoad> others{loads[0], loads[2], loads[4]};
    const auto forces = direct.solve_pinned(others, {loads[1].at, loads[3].at}, expected);
    support.apply_reactions(loads, op);
    CHECK((loads[1].force_body - forces[0]).norm() <= 1e-8 * forces[0].norm());
    CHECK((loads[3].force_body - forces[1]).norm() <= 1e-8 * forces[1].norm());
    CHECK(relative_difference(stress_of(op, loads), expected) <= 1e-8);
  }
}

TEST_CASE("the mean stress of a particle in equilibrium is the sum of force times position") {
  Random random(5);
  for (int sample = 0; sample < 10; ++sample) {
    const InfluenceOperator op = operator_of(test::random_mesh(random, 40));
    auto loads = test::random_loads(op.mesh(), 4, random);
    test::balance(loads, op.mesh());
    const ElementStress stress = stress_of(op, loads);
    Eigen::Matrix2d expected = Eigen::Matrix2d::Zero();
    for (const BoundaryLoad& load : loads)
      expected -= load.force_body * op.mesh().position(load.at).transpose() / thickness;
    Stress2 sum;
    const SamplingPoints points = op.sampling_points();
    for (std::size_t i = 0; i < points.size(); ++i) sum += points.area(i) * stress[i];
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) area += points.area(i);
    CHECK(difference(sum,
                     {expected(0, 0), expected(1, 1), 0.5 * (expected(0, 1) + expected(1, 0))}) <=
          round_off * area * largest(stress));
  }
}

namespace {

// Mean over the sampling points within half the radius, of the difference to the closed form.
template <Element E>
double disc_error(const E& of, unsigned triangles) {
  const test::BrazilianDisc disc;
  AssembleAndSolve body(disc.mesh(triangles), of, PlaneStress{}, Rock{}, disc.thickness);
  ElementStress stress;
  body.solve_free(disc.loads(body.mesh()), stress);
  const SamplingPoints points(body.mesh(), E::sampling_points);
  double area = 0;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.position(i).norm() > 0.5 * disc.radius) continue;
    Stress2 off = stress[i];
    off += -1.0 * disc.stress(points.position(i));
    area += points.area(i);
    sum += points.area(i) * (off.s11 * off.s11 + off.s22 * off.s22 + 2 * off.s12 * off.s12);
  }
  return std::sqrt(sum / area) / disc.unit();
}

}  // namespace

// In units of 2 P / (pi D t); the stress in the middle is (-1, 3).
TEST_CASE("in a disc between two loads stress converges faster than with constant strain") {
  std::vector<double> constant;
  std::vector<double> linear;
  for (const unsigned points : {400u, 1600u, 6400u}) {
    constant.push_back(disc_error(ConstantStrainTriangle{}, points));
    linear.push_back(disc_error(element, points / 4));
  }
  for (std::size_t k = 0; k + 1 < linear.size(); ++k) {
    // Spacings are halved: the first power is left of constant strain, the second of linear strain.
    CHECK(constant[k + 1] >= constant[k] / 3);
    CHECK(linear[k + 1] <= linear[k] / 3);
  }
  // Of as many sampling points. 100 triangles, two for each side of the disc at its rim, are few.
  CHECK(linear[0] <= constant[0]);
  for (const std::size_t k : {1u, 2u}) CHECK(linear[k] <= constant[k] / 5);
}

TEST_CASE("in the middle of the disc there are 2 P/(pi D t) of tension and three times that of "
          "compression") {
  const test::BrazilianDisc disc;
  const InfluenceOperator op = operator_of(disc.mesh(200), disc.thickness);
  const ElementStress stress = stress_of(op, disc.loads(op.mesh()));
  const SamplingPoints points = op.sampling_points();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.position(i).norm() < points.position(nearest).norm()) nearest = i;
  CHECK(stress[nearest].s11 == near_relative(-disc.unit(), 0.02));
  CHECK(stress[nearest].s22 == near_relative(3 * disc.unit(), 0.02));
}

// A quarter along a side the shares of its nodes are 3/8, 3/4 and -1/8; linear weights between the
// two nearest nodes would be 1/2 and 1/2.
TEST_CASE("quadratic shares of a force differ from linear ones near it, and not far away") {
  const test::BrazilianDisc disc;
  const InfluenceOperator op = operator_of(disc.mesh(100), disc.thickness);
  const std::uint32_t top = op.mesh().boundary_nodes / 4 / 2 * 2;
  const std::vector<BoundaryLoad> quadratic{{{top, top + 1, 0.5}, {0, -disc.force}, 0}};
  std::vector<BoundaryLoad> linear;
  for (const double weight : {0.0, 1.0})
    linear.push_back({{top, top + 1, weight}, {0, -0.5 * disc.force}, 0});
  const ElementStress one = stress_of(op, quadratic);
  const ElementStress two = stress_of(op, linear);
  double far = 0;
  double near_by = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double off = difference(one[i], two[i]);
    const bool is_far = op.sampling_points().position(i).norm() < 0.5 * disc.radius;
    (is_far ? far : near_by) = std::max(is_far ? far : near_by, off);
  }
  // Their difference is in equilibrium and falls with the square of the distance over the side, a
  // tenth of the radius long: 0.04 within half the radius, 0.13 of the largest stress near by.
  CHECK(far <= 0.05 * disc.unit());
  CHECK(near_by >= 0.1 * largest(one));
}
