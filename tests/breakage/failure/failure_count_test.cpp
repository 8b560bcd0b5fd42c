// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/failure/failure_count.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/core/units.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;

namespace {

ElementStress elements(const std::vector<Stress2>& stresses) {
  ElementStress all;
  all.reset(stresses.size());
  for (std::size_t e = 0; e < stresses.size(); ++e) all.set(e, stresses[e]);
  return all;
}

// Uniaxial compression with a given safety factor in Table 1's rock.
Stress2 crushed(double safety_factor) { return {300_MPa / safety_factor, 0, 0}; }
// Uniaxial tension likewise.
Stress2 torn(double safety_factor) { return {0, -12_MPa / safety_factor, 0}; }

}  // namespace

TEST_CASE("Rat is the share of failed elements, in tension and in shear alike") {
  const FailureCount failures = count_failures(
      HoekBrown{}, elements({crushed(2), crushed(0.9), torn(0.8), crushed(1.5), torn(3)}));
  CHECK(failures.elements == 5);
  CHECK(failures.failed == 2);
  CHECK(failures.ratio() == 0.4);
}

TEST_CASE("the first failed element is the one with the lowest safety factor") {
  const FailureCount failures = count_failures(
      HoekBrown{}, elements({crushed(0.9), torn(0.7), crushed(0.8), crushed(4), torn(0.95)}));
  CHECK(failures.first_failed == 1);
  CHECK(failures.lowest_safety_factor == near(0.7, 1e-14));
}

TEST_CASE("of equal safety factors the lower index is first") {
  const FailureCount failures = count_failures(
      HoekBrown{}, elements({crushed(3), crushed(0.9), crushed(0.5), torn(0.5), crushed(0.5)}));
  CHECK(failures.first_failed == 2);
  CHECK(failures.lowest_safety_factor == 0.5);
  CHECK(count_failures(HoekBrown{}, elements({torn(0.5), crushed(0.5)})).first_failed == 0);
  CHECK(count_failures(HoekBrown{}, elements({crushed(0.5), torn(0.5)})).first_failed == 0);
}

TEST_CASE("an intact element is never the first failed one") {
  // Its safety factor is barely above one, that of the failed one in the band is exactly one.
  const Stress2 band{0, -11.99_MPa, 0};
  const FailureCount failures =
      count_failures(HoekBrown{}, elements({crushed(1 + 1e-15), band, crushed(1 + 1e-15)}));
  CHECK(failures.failed == 1);
  CHECK(failures.first_failed == 1);
  CHECK(failures.lowest_safety_factor == 1);
}

TEST_CASE("where nothing has failed the count still names the element nearest to failure") {
  const FailureCount failures =
      count_failures(HoekBrown{}, elements({torn(5), crushed(3), crushed(1.25), crushed(1.5)}));
  CHECK(failures.failed == 0);
  CHECK(failures.ratio() == 0);
  CHECK(failures.first_failed == 2);
  CHECK(failures.lowest_safety_factor == near(1.25, 1e-14));
}

TEST_CASE("the count does not depend on the order of the elements but for ties") {
  const std::vector<Stress2> forward{crushed(0.9), torn(0.6), crushed(2), crushed(0.7)};
  const std::vector<Stress2> backward(forward.rbegin(), forward.rend());
  const FailureCount f = count_failures(HoekBrown{}, elements(forward));
  const FailureCount b = count_failures(HoekBrown{}, elements(backward));
  CHECK(f.failed == b.failed);
  CHECK(f.lowest_safety_factor == b.lowest_safety_factor);
  CHECK(f.first_failed == 3 - b.first_failed);
}

TEST_CASE("a particle without load or without elements has not failed") {
  const FailureCount unloaded = count_failures(HoekBrown{}, elements({{}, {}, {}}));
  CHECK(unloaded.elements == 3);
  CHECK(unloaded.failed == 0);
  CHECK(std::isinf(unloaded.lowest_safety_factor));
  CHECK(count_failures(HoekBrown{}, ElementStress{}).ratio() == 0);
  CHECK(count_failures(NeverFails{}, elements({torn(0.01), crushed(0.01)})).failed == 0);
}

TEST_CASE("with sampling points the failed area is counted") {
  Mesh mesh;
  mesh.nodes = {{0, 0}, {3, 0}, {3, 2}, {0, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};  // of areas 3 and 6
  const auto stress = elements({crushed(1.5), crushed(0.5)});
  const FailureCount failures = count_failures(HoekBrown{}, stress, SamplingPoints(mesh), 9);
  CHECK(failures.failed == 1);
  CHECK(failures.first_failed == 1);
  CHECK(failures.failed_area == 6);
  CHECK(failures.area_ratio() == near(2.0 / 3, 1e-15));
  CHECK(count_failures(HoekBrown{}, stress).area_ratio() == 0);
}

namespace {

// Contact forces of some kN fail part of a particle of 16 mm.
std::vector<BoundaryLoad> heavy_loads(const Mesh& mesh, Random& random) {
  auto loads = test::random_loads(mesh, 4, random);
  for (BoundaryLoad& load : loads) load.force_body *= 10;
  return loads;
}

// Round-off moves a safety factor by some 1e-10, and no element over its limit.
void check_same(const FailureCount& found, const FailureCount& expected) {
  CHECK(found.ratio() == expected.ratio());
  CHECK(found.first_failed == expected.first_failed);
  CHECK(found.lowest_safety_factor ==
        near(expected.lowest_safety_factor, 1e-9 * expected.lowest_safety_factor));
}

FailureCount failures_of(const Mesh& mesh, const std::vector<BoundaryLoad>& loads) {
  const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false);
  return count_failures(HoekBrown{}, test::stress_of(op, loads));
}

}  // namespace

TEST_CASE("a turned or mirrored particle has the same Rat, and the same first failed element") {
  Random random(301);
  int between = 0;
  for (int sample = 0; sample < 20; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    const auto loads = heavy_loads(mesh, random);
    const FailureCount failures = failures_of(mesh, loads);
    between += failures.failed > 0 && failures.failed < failures.elements;

    const Rotation turn = Rotation::from_angle(random.uniform(-3, 3));
    auto turned_loads = loads;
    for (BoundaryLoad& load : turned_loads) load.force_body = turn * load.force_body;
    check_same(failures_of(test::turned(mesh, turn), turned_loads), failures);

    auto mirrored_loads = loads;
    for (BoundaryLoad& load : mirrored_loads) load.force_body.x() *= -1;
    check_same(failures_of(test::mirror_image(mesh), mirrored_loads), failures);
  }
  CHECK(between >= 10);  // neither all intact nor all failed
}

TEST_CASE("a particle whose vertices are counted from another one has the same Rat") {
  // The mesh is carried along: its boundary nodes are counted from another corner too.
  Random random(302);
  for (int sample = 0; sample < 20; ++sample) {
    const Mesh mesh = test::random_mesh(random, 100);
    auto loads = heavy_loads(mesh, random);
    const FailureCount failures = failures_of(mesh, loads);
    const std::uint32_t shift = mesh.boundary_nodes - mesh.corners[1];
    const auto renamed = [&](std::uint32_t node) {
      return node < mesh.boundary_nodes ? (node + shift) % mesh.boundary_nodes : node;
    };
    Mesh other = mesh;
    for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) other.nodes[renamed(i)] = mesh.nodes[i];
    for (auto& triangle : other.triangles)
      for (std::uint32_t& node : triangle) node = renamed(node);
    for (BoundaryLoad& load : loads)
      load.at = {renamed(load.at.node), renamed(load.at.next), load.at.weight};
    check_same(failures_of(other, loads), failures);
  }
}
