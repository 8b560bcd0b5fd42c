// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near_relative;
using test::relative_difference;
using test::stress_of;

namespace {

constexpr double thickness = 0.016;
using Choice = TwoPinnedContacts::Choice;

InfluenceOperator operator_of(const Mesh& mesh, const Rock& rock = {}) {
  return {mesh, ConstantStrainTriangle{}, PlaneStress{}, rock, thickness, true};
}

// A regular hexagon, 16 mm from corner to corner.
Mesh hexagon(unsigned triangles) {
  return UniformMesher{triangles}(test::regular_polygon(6, 0.008).ring());
}

BoundaryLoad load_at(const Mesh& mesh, const Vec2& x, const Vec2& force, double normal_force) {
  return {nearest_boundary_point(mesh, x), force, normal_force};
}

double least_distance(const Mesh& mesh, std::span<const BoundaryLoad> loads) {
  double least = 1e300;
  for (std::size_t i = 0; i < loads.size(); ++i)
    for (std::size_t j = i + 1; j < loads.size(); ++j)
      least = std::min(least, (mesh.position(loads[i].at) - mesh.position(loads[j].at)).norm());
  return least;
}

// Contacts with 2 mm between them and more.
std::vector<BoundaryLoad> spread_loads(const Mesh& mesh, unsigned count, Random& random) {
  for (;;) {
    auto loads = test::random_loads(mesh, count, random);
    if (least_distance(mesh, loads) > 0.002) return loads;
  }
}

// Makes the contacts i and j the two with the largest normal forces.
void prefer(std::span<BoundaryLoad> loads, std::size_t i, std::size_t j) {
  for (std::size_t k = 0; k < loads.size(); ++k) loads[k].normal_force = k == i || k == j ? 2 : 1;
}

void check_balanced(const Mesh& mesh, std::span<const BoundaryLoad> loads) {
  double size = 0;
  for (const BoundaryLoad& load : loads) size += load.force_body.norm();
  CHECK(test::net_force(loads).norm() <= 1e-14 * size);  // round-off
  CHECK(std::abs(test::net_moment(loads, mesh, {0, 0})) <= 1e-14 * size * 0.016);
}

// Root of the mean square over area of all components, shear counted twice: a norm that does not
// turn with the axes.
double norm(const Mesh& mesh, const ElementStress& stress) {
  double sum = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Stress2 s = stress[e];
    sum += mesh.area(e) * (s.s11 * s.s11 + s.s22 * s.s22 + 2 * s.s12 * s.s12);
  }
  return std::sqrt(sum);
}

double energy(const Mesh& mesh, const Rock& rock, const ElementStress& stress) {
  double sum = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const Stress2 s = stress[e];
    sum += mesh.area(e) * (s.s11 * s.s11 + s.s22 * s.s22 - 2 * rock.poisson * s.s11 * s.s22 +
                           2 * (1 + rock.poisson) * s.s12 * s.s12);
  }
  return thickness / rock.young * sum / 2;
}

}  // namespace

TEST_CASE("pinned contacts give what assembling and solving with two fixed points gives") {
  Random random(401);
  for (int sample = 0; sample < 25; ++sample) {
    const Mesh mesh = test::random_mesh(random, random.uniform_integer(30, 120));
    const Rock rock{random.uniform(1e9, 1e11), random.uniform(0, 0.4), 2500};
    const unsigned count = random.uniform_integer(3, 6);
    auto loads = spread_loads(mesh, count, random);
    const std::size_t i = random.uniform_integer(0, count - 2);
    const std::size_t j = random.uniform_integer(static_cast<unsigned>(i) + 1, count - 1);
    prefer(loads, i, j);
    const auto compare = [&](const auto& plane) {
      AssembleAndSolve direct(mesh, ConstantStrainTriangle{}, plane, rock, thickness,
                              DeterminateSupport::on_opposite_sides(mesh));
      auto others = loads;
      others[i].force_body = others[j].force_body = Vec2{0, 0};
      ElementStress expected;
      const auto reactions = direct.solve_pinned(others, {loads[i].at, loads[j].at}, expected);

      const InfluenceOperator op(mesh, ConstantStrainTriangle{}, plane, rock, thickness, true);
      auto balanced = loads;
      TwoPinnedContacts{}.apply_reactions(balanced, op);
      CHECK(relative_difference(stress_of(op, balanced), expected) <= 1e-9);
      const double size = reactions[0].norm() + reactions[1].norm();
      CHECK((balanced[i].force_body - reactions[0]).norm() <= 1e-9 * size);
      CHECK((balanced[j].force_body - reactions[1]).norm() <= 1e-9 * size);
      for (std::size_t k = 0; k < loads.size(); ++k)
        if (k != i && k != j) CHECK(balanced[k].force_body == loads[k].force_body);
      check_balanced(mesh, balanced);
    };
    compare(PlaneStress{});
    compare(PlaneStrain{});
  }
}

TEST_CASE("with the reactions of the pins the mean stress is the sum of force times position") {
  Random random(402);
  for (int sample = 0; sample < 20; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const InfluenceOperator op = operator_of(mesh);
    auto loads = spread_loads(mesh, 4, random);
    TwoPinnedContacts{}.apply_reactions(loads, op);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    double area = 0;
    for (const BoundaryLoad& load : loads)
      sum -= load.force_body * mesh.position(load.at).transpose();
    for (std::size_t e = 0; e < mesh.size(); ++e) area += mesh.area(e);
    const ElementStress stress = stress_of(op, loads);
    const Stress2 mean = mean_stress(SamplingPoints(mesh), stress);
    // Condition numbers of 1e4 or so, times the unit round-off, times some tens of operations.
    const double tolerance = 1e-10 * stress.values().cwiseAbs().maxCoeff();
    CHECK(std::abs(mean.s11 - sum(0, 0) / (area * thickness)) <= tolerance);
    CHECK(std::abs(mean.s22 - sum(1, 1) / (area * thickness)) <= tolerance);
    CHECK(std::abs(mean.s12 - 0.5 * (sum(0, 1) + sum(1, 0)) / (area * thickness)) <= tolerance);
  }
}

TEST_CASE("a particle with exactly two contacts feels no load when both are pinned") {
  const Mesh mesh = hexagon(100);
  const InfluenceOperator op = operator_of(mesh);
  for (const Choice choice : {Choice::largest_normal_forces, Choice::farthest_apart}) {
    std::vector<BoundaryLoad> loads{load_at(mesh, {0.009, 0.001}, {-500, 30}, 500),
                                    load_at(mesh, {-0.009, 0.001}, {500, -30}, 500)};
    // Free, it is pressed together.
    CHECK(stress_of(op, loads).values().cwiseAbs().maxCoeff() > 1e5);
    TwoPinnedContacts{choice}.apply_reactions(loads, op);
    CHECK(loads[0].force_body.norm() == 0);
    CHECK(loads[1].force_body.norm() == 0);
  }
}

TEST_CASE("a particle that two pins cannot hold is left without stress") {
  const Mesh mesh = hexagon(100);
  const InfluenceOperator op = operator_of(mesh);
  TwoPinnedContacts{}.apply_reactions({}, op);

  std::vector<BoundaryLoad> one{load_at(mesh, {0.009, 0.001}, {-500, 30}, 500)};
  TwoPinnedContacts{}.apply_reactions(one, op);
  CHECK(one[0].force_body == Vec2{0, 0});

  // Three contacts on one and the same place.
  std::vector<BoundaryLoad> same(3, load_at(mesh, {0, 0.009}, {-500, -30}, 500));
  TwoPinnedContacts{}.apply_reactions(same, op);
  for (const BoundaryLoad& load : same) CHECK(load.force_body == Vec2{0, 0});
}

TEST_CASE("of contacts that coincide only one is pinned") {
  const Mesh mesh = hexagon(100);
  const InfluenceOperator op = operator_of(mesh);
  std::vector<BoundaryLoad> loads{
      load_at(mesh, {0, 0.009}, {10, -900}, 900), load_at(mesh, {1e-6, 0.009}, {20, -800}, 800),
      load_at(mesh, {0.009, 0.001}, {-300, 5}, 300), load_at(mesh, {-0.009, 0.001}, {200, 5}, 200)};
  TwoPinnedContacts{}.apply_reactions(loads, op);
  CHECK(loads[1].force_body == Vec2{20, -800});
  CHECK(loads[3].force_body == Vec2{200, 5});
  check_balanced(mesh, loads);
  // Next to a pin, the force of the second contact goes into it.
  CHECK((loads[0].force_body + loads[1].force_body).norm() < 0.5 * loads[1].force_body.norm());
}

TEST_CASE("the two largest normal forces are pinned, or the two contacts farthest apart") {
  const Mesh mesh = hexagon(100);
  const InfluenceOperator op = operator_of(mesh);
  const std::vector<BoundaryLoad> loads{
      load_at(mesh, {0.009, 0}, {-100, 1}, 100), load_at(mesh, {0, 0.009}, {2, -400}, 400),
      load_at(mesh, {-0.009, 0}, {200, 3}, 200), load_at(mesh, {0.001, -0.009}, {4, 500}, 500)};
  const auto pinned = [&](Choice choice) {
    auto balanced = loads;
    TwoPinnedContacts{choice}.apply_reactions(balanced, op);
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < 4; ++k)
      if (balanced[k].force_body != loads[k].force_body) changed.push_back(k);
    return changed;
  };
  CHECK(TwoPinnedContacts{}.choice == Choice::largest_normal_forces);
  CHECK(pinned(Choice::largest_normal_forces) == std::vector<std::size_t>{1, 3});
  CHECK(pinned(Choice::farthest_apart) == std::vector<std::size_t>{0, 2});
}

TEST_CASE("among equal contacts the first are pinned") {
  const Mesh mesh = hexagon(100);
  const InfluenceOperator op = operator_of(mesh);
  std::vector<BoundaryLoad> loads;
  for (const Vec2& x : {Vec2{0.009, 0}, Vec2{0, 0.009}, Vec2{-0.009, 0}, Vec2{0, -0.009}})
    loads.push_back(load_at(mesh, x, -1e4 * x + Vec2{5, 3}, 100));
  const auto before = loads;
  TwoPinnedContacts{}.apply_reactions(loads, op);
  CHECK(loads[0].force_body != before[0].force_body);
  CHECK(loads[1].force_body != before[1].force_body);
  CHECK(loads[2].force_body == before[2].force_body);
  CHECK(loads[3].force_body == before[3].force_body);
}

// The force along the line of the pins is statically indeterminate and follows from the elasticity
// of the particle, not from the contact law. By Castigliano the pins find the force of least strain
// energy, so the field that they take away is a projection of the true one: in the norm of energy
// it changes by cos of an angle, below 100 %, and by Pythagoras that much of the energy is lost.
// Stress and energy differ by 1 - nu (mean stress) to 1 + nu (shear), so in the norm of stress the
// bound is sqrt((1 + nu) / (1 - nu)) = 1.19. That the change is tens of per cent, and not a nuance,
// for every choice of pins, is why pins are not the default.
TEST_CASE("the six choices of two pins among four contacts change stresses by tens of per cent") {
  const Rock rock;
  const Mesh mesh = hexagon(384);
  const InfluenceOperator op = operator_of(mesh, rock);
  std::vector<BoundaryLoad> loads{load_at(mesh, {0.009, 0.003}, {-800, -150}, 0),
                                  load_at(mesh, {-0.001, 0.009}, {100, -1000}, 0),
                                  load_at(mesh, {-0.009, -0.002}, {700, 100}, 0),
                                  load_at(mesh, {0.002, -0.009}, {50, 900}, 0)};
  test::balance(loads, mesh);
  const ElementStress free = stress_of(op, loads);
  const double free_energy = energy(mesh, rock, free);
  std::vector<ElementStress> fields;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      CAPTURE(i);
      CAPTURE(j);
      prefer(loads, i, j);
      auto balanced = loads;
      TwoPinnedContacts{}.apply_reactions(balanced, op);
      const ElementStress pinned = stress_of(op, balanced);
      ElementStress change = free;
      change.values() -= pinned.values();
      const double share = norm(mesh, change) / norm(mesh, free);
      CHECK(share >= 0.1);
      CHECK(share <= std::sqrt((1 + rock.poisson) / (1 - rock.poisson)));
      CHECK(energy(mesh, rock, pinned) + energy(mesh, rock, change) ==
            near_relative(free_energy, 1e-9));
      // The loads were in equilibrium: all that changes is the force along the line of the pins.
      const Vec2 line = mesh.position(loads[j].at) - mesh.position(loads[i].at);
      const Vec2 push = balanced[j].force_body - loads[j].force_body;
      CHECK(std::abs(cross(line.normalized(), push)) <= 1e-9 * push.norm());
      fields.push_back(pinned);
    }
  for (std::size_t a = 0; a < fields.size(); ++a)
    for (std::size_t b = a + 1; b < fields.size(); ++b)
      CHECK(relative_difference(fields[a], fields[b]) > 0.1);
}

TEST_CASE("pins and loads turned together give turned reactions") {
  Random random(403);
  const Mesh mesh = test::random_mesh(random, 100);
  auto loads = spread_loads(mesh, 4, random);
  auto turned_loads = loads;
  const Rotation turn = Rotation::from_angle(0.7345);
  for (BoundaryLoad& load : turned_loads) load.force_body = turn * load.force_body;
  TwoPinnedContacts{}.apply_reactions(loads, operator_of(mesh));
  TwoPinnedContacts{}.apply_reactions(turned_loads, operator_of(test::turned(mesh, turn)));
  for (std::size_t k = 0; k < loads.size(); ++k)
    CHECK((turned_loads[k].force_body - turn * loads[k].force_body).norm() <= 1e-9 * 1e3);
}

TEST_CASE("reactions do not depend on Young's modulus, and grow with the loads") {
  Random random(404);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto loads = spread_loads(mesh, 5, random);
  auto stiff = loads;
  auto soft = loads;
  auto large = loads;
  for (BoundaryLoad& load : large) load.force_body *= 7;
  TwoPinnedContacts{}.apply_reactions(stiff, operator_of(mesh, {70e9, 0.17, 2500}));
  TwoPinnedContacts{}.apply_reactions(soft, operator_of(mesh, {1e7, 0.17, 2500}));
  TwoPinnedContacts{}.apply_reactions(large, operator_of(mesh, {70e9, 0.17, 2500}));
  for (std::size_t k = 0; k < loads.size(); ++k) {
    CHECK((soft[k].force_body - stiff[k].force_body).norm() <= 1e-9 * 1e3);
    CHECK((large[k].force_body - 7 * stiff[k].force_body).norm() <= 1e-9 * 7e3);
  }
}
