// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/boundary_locator.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/brazilian_disc.hpp>
#include <support/loaded_particle.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near_relative;
using test::relative_difference;

namespace {

constexpr double thickness = 0.016;

using Direct = AssembleAndSolve<ConstantStrainTriangle, PlaneStress>;

ElementStress free_stress(const Mesh& mesh, const DeterminateSupport& support,
                          std::span<const BoundaryLoad> loads) {
  Direct direct(mesh, {}, {}, Rock{}, thickness, support);
  ElementStress stress;
  direct.solve_free(loads, stress);
  return stress;
}

}  // namespace

TEST_CASE("stresses of a free particle do not depend on which three constraints hold it") {
  Random random(201);
  for (int sample = 0; sample < 10; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const auto loads = test::random_loads(mesh, 5, random);
    const ElementStress reference =
        free_stress(mesh, DeterminateSupport::on_opposite_sides(mesh), loads);
    const auto last = static_cast<std::uint32_t>(mesh.nodes.size() - 1);
    for (const DeterminateSupport& support :
         {DeterminateSupport{}, DeterminateSupport{last, 3}, DeterminateSupport{2, last},
          DeterminateSupport{mesh.boundary_nodes - 1, 1}})
      // Neighbours as constraints turn the particle by a lot: condition numbers near 1e6.
      CHECK(relative_difference(free_stress(mesh, support, loads), reference) <= 1e-9);
  }
}

TEST_CASE("the same solver serves one set of loads after another, and after factorising again") {
  Random random(202);
  const Mesh mesh = test::random_mesh(random, 100);
  Direct direct(mesh, {}, {}, Rock{}, thickness, DeterminateSupport::on_opposite_sides(mesh));
  const auto first = test::random_loads(mesh, 5, random);
  const auto second = test::random_loads(mesh, 2, random);
  ElementStress once;
  ElementStress other;
  ElementStress again;
  direct.solve_free(first, once);
  direct.solve_free(second, other);
  direct.factorise();
  direct.solve_free(first, again);
  CHECK(again.values() == once.values());
  CHECK(relative_difference(other, once) > 0.1);
}

TEST_CASE("where the particle lies does not matter") {
  Random random(203);
  const Mesh mesh = test::random_mesh(random, 100);
  const auto loads = test::random_loads(mesh, 4, random);
  Mesh far = mesh;
  for (Vec2& x : far.nodes) x += Vec2{8, -6};
  const DeterminateSupport support = DeterminateSupport::on_opposite_sides(mesh);
  // Coordinates lose three digits at six hundred diameters.
  CHECK(relative_difference(free_stress(far, support, loads), free_stress(mesh, support, loads)) <=
        1e-8);
}

// 2 P / (pi D t) of tension across and 6 P / (pi D t) of compression along the line of the loads.
// Within two spacings of the centre stress comes to this from below, with the square of the
// spacing; in single elements it errs with the first power.
TEST_CASE("refined from 625 to 10000 triangles, a disc comes up to the Brazilian closed form") {
  const test::BrazilianDisc disc;
  CHECK(disc.stress({0, 0}).s11 == near_relative(-8.48826e6, 1e-6));  // printed digits
  CHECK(disc.stress({0, 0}).s22 == near_relative(25.4648e6, 2e-6));
  std::vector<Vec2> errors;
  std::vector<double> field;
  for (const unsigned triangles : {625u, 2500u, 10000u}) {
    const Mesh mesh = disc.mesh(triangles);
    Direct direct(mesh, {}, {}, Rock{}, disc.thickness,
                  DeterminateSupport::on_opposite_sides(mesh));
    ElementStress stress;
    direct.solve_free(disc.loads(mesh), stress);
    const Stress2 middle = test::middle_stress(mesh, stress, 2 * disc.spacing(triangles));
    errors.push_back({1 + middle.s11 / 8.48826e6, 1 - middle.s22 / 25.4648e6});
    field.push_back(test::field_error(disc, mesh, stress));
  }
  for (int c = 0; c < 2; ++c) {
    CHECK(errors[2][c] > 0);
    // A quarter per halving of the spacing; 3 to leave room for the odd element at the rim.
    CHECK(errors[1][c] <= errors[0][c] / 3);
    CHECK(errors[2][c] <= errors[1][c] / 3);
    // Extrapolated to no spacing what is left is the polygon, 0.16 % smaller than the disc.
    CHECK(std::abs((4 * errors[2][c] - errors[1][c]) / 3) <= 0.0016);
  }
  for (std::size_t k = 0; k < 2; ++k) CHECK(field[k + 1] <= field[k] / 1.7);  // a half, likewise
}

TEST_CASE("pins that hold a particle balance its loads") {
  Random random(204);
  for (int sample = 0; sample < 20; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const auto loads = test::random_loads(mesh, 4, random);
    const Direct direct(mesh, {}, {}, Rock{}, thickness,
                        DeterminateSupport::on_opposite_sides(mesh));
    const std::array<BoundaryPoint, 2> pins{
        BoundaryPoint{0, 1, 0.3},
        BoundaryPoint{mesh.boundary_nodes / 2, mesh.boundary_nodes / 2 + 1, 0.8}};
    ElementStress stress;
    const auto reactions = direct.solve_pinned(loads, pins, stress);
    std::vector<BoundaryLoad> all = loads;
    for (std::size_t k = 0; k < 2; ++k) all.push_back({pins[k], reactions[k], 0});
    double size = 0;
    for (const BoundaryLoad& load : all) size += load.force_body.norm();
    CHECK(test::net_force(all).norm() <= 1e-11 * size);
    CHECK(std::abs(test::net_moment(all, mesh, {0, 0})) <= 1e-11 * size * 0.016);
    // With the reactions as loads the particle is in equilibrium, free, and stressed in the same
    // way.
    CHECK(relative_difference(free_stress(mesh, {0, mesh.boundary_nodes / 2}, all), stress) <=
          1e-9);

    // A load on a pin goes into the pin.
    auto more = loads;
    more.push_back({pins[1], {700, 200}, 0});
    ElementStress same;
    const auto changed = direct.solve_pinned(more, pins, same);
    CHECK(relative_difference(same, stress) <= 1e-9);
    CHECK((changed[1] - reactions[1] - Vec2{-700, -200}).norm() <= 1e-9 * size);
    CHECK((changed[0] - reactions[0]).norm() <= 1e-9 * size);
  }
}

TEST_CASE("a bar pinned at both ends carries an axial force half in either half") {
  // A force in the middle of a slender bar along it: one half in tension, the other compressed.
  const double length = 0.1;
  const Mesh mesh = UniformMesher{800}(test::rectangle(length, 0.01).ring());
  const Direct direct(mesh, {}, {}, Rock{}, thickness, DeterminateSupport::on_opposite_sides(mesh));
  const auto at = [&](double x, double y) { return nearest_boundary_point(mesh, {x, y}); };
  const std::vector<BoundaryLoad> loads{{at(0, 0.005), {500, 0}, 0}, {at(0, -0.005), {500, 0}, 0}};
  ElementStress stress;
  const auto reactions = direct.solve_pinned(loads, {at(-0.05, 0), at(0.05, 0)}, stress);
  // By symmetry, to what the mesh lacks of it: half a spacing in the length.
  CHECK(reactions[0].x() == near_relative(-500, 0.02));
  CHECK(reactions[1].x() == near_relative(-500, 0.02));
  double left = 0;
  double right = 0;
  double area = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const double x = mesh.centroid(e).x();
    if (std::abs(x) < 0.015 || std::abs(x) > 0.035) continue;
    area += 0.5 * mesh.area(e);
    (x < 0 ? left : right) += mesh.area(e) * stress[e].s11;
  }
  const double nominal = 500 / (0.01 * thickness);
  CHECK(left / area == near_relative(-nominal, 0.05));
  CHECK(right / area == near_relative(nominal, 0.05));
}

TEST_CASE("supports that cannot hold a particle are refused") {
  const Mesh mesh = UniformMesher{20}(test::rectangle(1, 1).ring());
  CHECK(test::message_of([&] {
          Direct(mesh, {}, {}, Rock{}, 0, {0, 1});
        }) == "AssembleAndSolve.thickness = 0: must be a finite number above 0");
  CHECK(test::message_of([&] {
          Direct(mesh, {}, {}, Rock{}, 1, {2, 2});
        }) == "DeterminateSupport.guided = 2: must be another node than `fixed`");
  CHECK(test::message_of([&] {
          Direct(mesh, {}, {}, Rock{}, 1, {0, 999});
        }) == "DeterminateSupport node = 999: must be in the mesh");
  const Direct direct(mesh, {}, {}, Rock{}, 1, {0, 1});
  ElementStress stress;
  CHECK(test::message_of([&] {
          (void)direct.solve_pinned({}, {BoundaryPoint{0, 1, 1}, BoundaryPoint{0, 1, 1}}, stress);
        }) == "AssembleAndSolve distance of the pins = 0: must be a finite number above 0");
}
