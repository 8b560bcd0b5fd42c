// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/influence_operator.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/brazilian_disc.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near_relative;
using test::relative_difference;
using test::stress_of;

namespace {

constexpr double thickness = 0.016;
constexpr ConstantStrainTriangle element{};

// Stiffness matrices of 100 triangles have condition numbers of 1e4 or so; times the unit round-off
// 1e-16, times some tens of operations on the way.
constexpr double round_off = 1e-10;

template <PlaneState P = PlaneStress>
InfluenceOperator operator_of(const Mesh& mesh, const Rock& rock = {}, double t = thickness,
                              bool with_flexibility = false) {
  return {mesh, element, P{}, rock, t, with_flexibility};
}

Mesh mesh_of(const ConvexPolygon& polygon, unsigned triangles) {
  return UniformMesher{triangles}(polygon.ring());
}

Rock random_rock(Random& random) {
  return {random.uniform(1e9, 1e11), random.uniform(0, 0.4), random.uniform(1000, 4000)};
}

// Second moments of area of a ring about the origin by Green's theorem: of x^2, y^2 and x y.
Eigen::Vector3d second_moments(Ring ring) {
  Eigen::Vector3d sum{0, 0, 0};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2& p = ring[k];
    const Vec2& q = ring[(k + 1) % ring.size()];
    const double x2 = p.x() * p.x() + p.x() * q.x() + q.x() * q.x();
    const double y2 = p.y() * p.y() + p.y() * q.y() + q.y() * q.y();
    const double xy = 0.5 * (p.x() * q.y() + q.x() * p.y()) + p.x() * p.y() + q.x() * q.y();
    sum += cross(p, q) / 12 * Eigen::Vector3d{x2, y2, xy};
  }
  return sum;
}

// Virtual work with a linear field of virtual displacements: the mean of tension times the volume
// is the sum of force times position, made symmetric, over the loads and over the inertia -M/J (-y,
// x) that balances the moment M; the inertia that balances the net force has no first moment.
Stress2 expected_mean(Ring ring, const Mesh& mesh, std::span<const BoundaryLoad> loads) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const BoundaryLoad& load : loads)
    sum += load.force_body * mesh.position(load.at).transpose();
  const Eigen::Vector3d second = second_moments(ring);
  const double spin = test::net_moment(loads, mesh, {0, 0}) / (second[0] + second[1]);
  Eigen::Matrix2d inertia;
  inertia << -second[2], -second[1], second[0], second[2];
  sum -= spin * inertia;
  const double volume = thickness * area_properties(ring).area;
  return {-sum(0, 0) / volume, -sum(1, 1) / volume, -0.5 * (sum(0, 1) + sum(1, 0)) / volume};
}

double difference(const Stress2& a, const Stress2& b) {
  return std::max({std::abs(a.s11 - b.s11), std::abs(a.s22 - b.s22), std::abs(a.s12 - b.s12)});
}

// Twice the energy that the second stress does on the strain of the first [J]; plane stress.
double mutual_energy(const Mesh& mesh, const Rock& rock, const ElementStress& a,
                     const ElementStress& b) {
  double sum = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Stress2 p = a[e];
    const Stress2 q = b[e];
    sum += mesh.area(e) *
           (p.s11 * q.s11 + p.s22 * q.s22 - rock.poisson * (p.s11 * q.s22 + p.s22 * q.s11) +
            2 * (1 + rock.poisson) * p.s12 * q.s12);
  }
  return thickness / rock.young * sum;
}

double work(const InfluenceOperator& op, std::span<const BoundaryLoad> of,
            std::span<const BoundaryLoad> on_way_of) {
  double sum = 0;
  for (const BoundaryLoad& p : of)
    for (const BoundaryLoad& q : on_way_of)
      sum += p.force_body.dot(op.displacement(p.at, q.at, q.force_body));
  return sum;
}

}  // namespace

TEST_CASE("the operator gives what assembling and solving gives, for any particle, rock and load") {
  Random random(101);
  for (int sample = 0; sample < 40; ++sample) {
    const Mesh mesh = test::random_mesh(random, random.uniform_integer(10, 150));
    const Rock rock = random_rock(random);
    const double t = random.uniform(0.001, 1);
    const auto loads = test::random_loads(mesh, random.uniform_integer(1, 7), random);
    const auto compare = [&](const auto& plane) {
      AssembleAndSolve direct(mesh, element, plane, rock, t,
                              DeterminateSupport::on_opposite_sides(mesh));
      ElementStress expected;
      direct.solve_free(loads, expected);
      const InfluenceOperator op(mesh, element, plane, rock, t, false);
      CHECK(relative_difference(stress_of(op, loads), expected) <= 1e-9);
    };
    compare(PlaneStress{});
    compare(PlaneStrain{});
  }
}

TEST_CASE("the mean stress of a particle in equilibrium is the sum of force times position") {
  Random random(102);
  for (int sample = 0; sample < 40; ++sample) {
    const ConvexPolygon polygon = random_polygon(test::blunt_shape, 0.016, random);
    const Mesh mesh = mesh_of(polygon, 100);
    auto loads = test::random_loads(mesh, random.uniform_integer(2, 6), random);
    test::balance(loads, mesh);
    const ElementStress stress = stress_of(operator_of(mesh), loads);
    const double largest = stress.values().cwiseAbs().maxCoeff();
    const Stress2 mean = mean_stress(SamplingPoints(mesh), stress);
    CHECK(difference(mean, expected_mean(polygon.ring(), mesh, loads)) <= round_off * largest);
  }
}

TEST_CASE("with a net force and moment the inertia of the particle joins in the mean stress") {
  Random random(103);
  for (int sample = 0; sample < 40; ++sample) {
    const ConvexPolygon polygon = random_polygon({}, 0.016, random);
    const Mesh mesh = mesh_of(polygon, 100);
    const auto loads = test::random_loads(mesh, random.uniform_integer(1, 6), random);
    const ElementStress stress = stress_of(operator_of<PlaneStrain>(mesh), loads);
    const double largest = stress.values().cwiseAbs().maxCoeff();
    const Stress2 mean = mean_stress(SamplingPoints(mesh), stress);
    CHECK(difference(mean, expected_mean(polygon.ring(), mesh, loads)) <= round_off * largest);
  }
}

TEST_CASE("a square pressed between two faces is under that pressure, compression positive") {
  const ConvexPolygon square = test::rectangle(0.02, 0.02);
  const Mesh mesh = mesh_of(square, 200);
  // 1 MPa on the lower and the upper face, as half of the force on either node of each piece.
  std::vector<BoundaryLoad> loads;
  for (const std::size_t face : {0u, 2u})
    for (std::uint32_t i = mesh.corners[face]; i < mesh.corners[face + 1]; ++i) {
      const double force = 1e6 * thickness * (mesh.nodes[i + 1] - mesh.nodes[i]).norm();
      loads.push_back({{i, i + 1, 0.5}, {0, face == 0 ? force : -force}, force});
    }
  const ElementStress stress = stress_of(operator_of(mesh), loads);
  for (std::size_t e = 0; e < mesh.size(); ++e)
    CHECK(difference(stress[e], {0, 1e6, 0}) <= round_off * 1e6);
}

// 2 P / (pi D t) of tension across and 6 P / (pi D t) of compression along the line of the loads:
// 8.48826 and 25.4648 MPa. In the elements within two spacings of the centre stress comes to this
// from below, with the square of the spacing: so do linear triangles away from the loads, and the
// mean over a small circle. In single elements stress errs with the first power.
TEST_CASE("the middle of a disc between two loads converges to the closed form") {
  const test::BrazilianDisc disc;
  std::vector<Vec2> errors;
  std::vector<double> field;
  for (const unsigned triangles : {360u, 1440u}) {
    const Mesh mesh = disc.mesh(triangles);
    const ElementStress stress = stress_of(operator_of(mesh, {}, disc.thickness), disc.loads(mesh));
    const Stress2 middle = test::middle_stress(mesh, stress, 2 * disc.spacing(triangles));
    errors.push_back({1 + middle.s11 / 8.48826e6, 1 - middle.s22 / 25.4648e6});
    field.push_back(test::field_error(disc, mesh, stress));
  }
  for (int c = 0; c < 2; ++c) {
    CHECK(errors[1][c] > 0);
    // A quarter per halving of the spacing; 3 to leave room for the odd element at the rim.
    CHECK(errors[1][c] <= errors[0][c] / 3);
  }
  // A half; 1.7 likewise.
  CHECK(field[1] <= field[0] / 1.7);
}

TEST_CASE("stresses do not depend on Young's modulus nor on density") {
  Random random(104);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto loads = test::random_loads(mesh, 4, random);
  const ElementStress stress = stress_of(operator_of(mesh, {70e9, 0.17, 2500}), loads);
  const ElementStress soft = stress_of(operator_of(mesh, {3e6, 0.17, 2500}), loads);
  const ElementStress heavy = stress_of(operator_of(mesh, {70e9, 0.17, 7800}), loads);
  CHECK(relative_difference(soft, stress) <= round_off);
  CHECK(relative_difference(heavy, stress) <= round_off);
}

TEST_CASE("plane strain differs from plane stress through Poisson's ratio only") {
  Random random(105);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto loads = test::random_loads(mesh, 4, random);
  for (const double poisson : {0.0, 0.17, 0.3}) {
    const ElementStress strain =
        stress_of(operator_of<PlaneStrain>(mesh, {7e10, poisson, 1}), loads);
    const double substitute = poisson / (1 - poisson);
    const ElementStress stress = stress_of(operator_of(mesh, {7e10, substitute, 1}), loads);
    CHECK(relative_difference(strain, stress) <= round_off);
  }
  // Elements deform in another way, so there is a difference to be seen.
  const ElementStress strain = stress_of(operator_of<PlaneStrain>(mesh, {7e10, 0.3, 1}), loads);
  const ElementStress stress = stress_of(operator_of(mesh, {7e10, 0.3, 1}), loads);
  CHECK(relative_difference(strain, stress) > 1e-4);
}

TEST_CASE("half the thickness, twice the stress") {
  Random random(106);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto loads = test::random_loads(mesh, 4, random);
  const ElementStress thick = stress_of(operator_of(mesh, {}, 0.016), loads);
  ElementStress thin = stress_of(operator_of(mesh, {}, 0.008), loads);
  thin.values() *= 0.5;
  CHECK(relative_difference(thin, thick) <= round_off);
}

TEST_CASE("stress is force over length times thickness, in any unit of length") {
  Random random(107);
  const Mesh mesh = test::random_mesh(random, 100);
  auto loads = test::random_loads(mesh, 4, random);
  const ElementStress metres = stress_of(operator_of(mesh), loads);
  for (BoundaryLoad& load : loads) load.force_body *= 1e6;
  const ElementStress millimetres =
      stress_of(operator_of(test::scaled(mesh, 1000), {}, 1000 * thickness), loads);
  CHECK(relative_difference(millimetres, metres) <= round_off);
}

TEST_CASE("stresses of several loads add up") {
  Random random(108);
  const Mesh mesh = test::random_mesh(random, 100);
  const InfluenceOperator op = operator_of(mesh);
  const auto loads = test::random_loads(mesh, 5, random);
  ElementStress sum;
  sum.reset(mesh.size());
  for (const BoundaryLoad& load : loads) {
    ElementStress alone = stress_of(op, std::span(&load, 1));
    sum.values() += alone.values();
    ElementStress triple;
    triple.reset(mesh.size());
    op.add_stress(load.at, -3 * load.force_body, triple);
    alone.values() *= -3;
    CHECK(relative_difference(triple, alone) <= 1e-14);  // round-off of four products
  }
  CHECK(relative_difference(sum, stress_of(op, loads)) <= 1e-14);
}

TEST_CASE("a turned particle under turned loads has turned stresses") {
  Random random(109);
  const Mesh mesh = test::random_mesh(random, 100);
  auto loads = test::random_loads(mesh, 4, random);
  const ElementStress stress = stress_of(operator_of(mesh), loads);
  const double largest = stress.values().cwiseAbs().maxCoeff();
  for (const double angle : {0.7345, 2.2, -1.0}) {
    const Rotation turn = Rotation::from_angle(angle);
    auto turned_loads = loads;
    for (BoundaryLoad& load : turned_loads) load.force_body = turn * load.force_body;
    const ElementStress turned = stress_of(operator_of(test::turned(mesh, turn)), turned_loads);
    for (std::size_t e = 0; e < mesh.size(); ++e)
      CHECK(difference(turned[e], stress[e].rotated(turn)) <= round_off * largest);
  }
}

TEST_CASE("the mirror image of a loaded particle has the mirror image of its stresses") {
  Random random(110);
  const Mesh mesh = test::random_mesh(random, 100);
  auto loads = test::random_loads(mesh, 4, random);
  const ElementStress stress = stress_of(operator_of(mesh), loads);
  for (BoundaryLoad& load : loads) load.force_body.x() *= -1;
  const ElementStress mirrored = stress_of(operator_of(test::mirror_image(mesh)), loads);
  const double largest = stress.values().cwiseAbs().maxCoeff();
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Stress2 s = stress[e];
    CHECK(difference(mirrored[e], {s.s11, s.s22, -s.s12}) <= 1e-12 * largest);
  }
}

TEST_CASE("a load that is spread like the particle's own mass moves it and does not stress it") {
  // On a mesh whose nodes all lie on the boundary, loads can follow the mass of the nodes.
  Mesh mesh;
  mesh.nodes = {{-0.01, -0.005}, {0.012, -0.006}, {0.009, 0.006}, {-0.008, 0.01}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.corners = {0, 1, 2, 3};
  mesh.boundary_nodes = 4;
  const Vec2 centre = area_properties(mesh.nodes).centroid;
  for (Vec2& x : mesh.nodes) x -= centre;
  // Consistent nodal shares of a rigid acceleration, by the middles of the edges.
  std::vector<BoundaryLoad> loads(4);
  for (std::uint32_t i = 0; i < 4; ++i) loads[i].at = {i, (i + 1) % 4, 1};
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = mesh.triangles[e][k];
      const std::uint32_t q = mesh.triangles[e][(k + 1) % 3];
      const Vec2 middle = 0.5 * (mesh.nodes[p] + mesh.nodes[q]);
      const Vec2 force = 1e7 * mesh.area(e) * (Vec2{2, -1} + 500 * perpendicular(middle));
      loads[p].force_body += force;
      loads[q].force_body += force;
    }
  const InfluenceOperator op = operator_of(mesh);
  double largest = 0;
  for (const BoundaryLoad& load : loads)
    largest = std::max(largest, stress_of(op, std::span(&load, 1)).values().cwiseAbs().maxCoeff());
  CHECK(stress_of(op, loads).values().cwiseAbs().maxCoeff() <= 1e-12 * largest);
}

// Clapeyron: the work of balanced forces is twice the strain energy. Betti: it is mutual.
TEST_CASE("displacements of the boundary do the work that the stresses store") {
  Random random(111);
  for (int sample = 0; sample < 10; ++sample) {
    const Rock rock = random_rock(random);
    const Mesh mesh = test::random_mesh(random, 80);
    const InfluenceOperator op = operator_of(mesh, rock, thickness, true);
    auto one = test::random_loads(mesh, 4, random);
    auto two = test::random_loads(mesh, 3, random);
    test::balance(one, mesh);
    test::balance(two, mesh);
    const ElementStress s1 = stress_of(op, one);
    const ElementStress s2 = stress_of(op, two);
    const double energy = mutual_energy(mesh, rock, s1, s1);
    const double scale = energy + mutual_energy(mesh, rock, s2, s2);
    CHECK(work(op, one, one) == near_relative(energy, round_off));
    const double mutual = mutual_energy(mesh, rock, s1, s2);
    CHECK(std::abs(work(op, one, two) - mutual) <= round_off * scale);
    CHECK(std::abs(work(op, two, one) - mutual) <= round_off * scale);
  }
}

TEST_CASE("an operator has its mesh and its size in memory") {
  CHECK(InfluenceOperator{}.empty());
  CHECK(InfluenceOperator{}.bytes() == 0);
  const Mesh mesh = mesh_of(test::regular_polygon(5, 0.01), 50);
  const InfluenceOperator op = operator_of(mesh);
  CHECK_FALSE(op.empty());
  CHECK(op.mesh().triangles == mesh.triangles);
  const std::size_t columns = 2 * mesh.boundary_nodes;
  CHECK(op.bytes() == 8 * 3 * mesh.size() * columns);
  CHECK(operator_of(mesh, {}, thickness, true).bytes() ==
        8 * (3 * mesh.size() * columns + columns * columns));
}
