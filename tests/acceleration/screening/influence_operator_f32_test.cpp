// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/influence_operator_f32.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

InfluenceOperator exact_operator(const Mesh& mesh) {
  return {mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false};
}

// With three or six nodes; loads are to be placed on the mesh of the operator.
InfluenceOperator random_operator(Random& random, unsigned triangles) {
  const Mesh mesh = test::random_mesh(random, triangles);
  if (random.uniform_integer(0, 1) == 0) return exact_operator(mesh);
  return {mesh, LinearStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false};
}

double frobenius_square(const ElementStress& stress) {
  double sum = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const Stress2 s = stress[e];
    sum += s.s11 * s.s11 + s.s22 * s.s22 + 2 * s.s12 * s.s12;
  }
  return sum;
}

}  // namespace

TEST_CASE("the error of the compact operator is below its bound, and the bound is small") {
  Random random(91);
  ElementStressF32 stress;
  for (int sample = 0; sample < 60; ++sample) {
    const InfluenceOperator exact = random_operator(random, random.uniform_integer(10, 100));
    const Mesh& mesh = exact.mesh();
    const InfluenceOperatorF32 compact(exact);
    CHECK(compact.elements() == exact.sampling_points().size());
    const auto loads = test::random_loads(mesh, random.uniform_integer(1, 8), random);
    const double scale = random.uniform(0.1, 3);
    compact.find_stress(loads, scale, stress);
    ElementStress expected = test::stress_of(exact, loads);
    expected.values() *= scale;
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t e = 0; e < stress.elements; ++e)
        error = std::max(
            error, std::abs(static_cast<double>(stress.component(c)[e]) -
                            expected.values()[static_cast<Eigen::Index>(c * stress.elements + e)]));
    CHECK(error <= stress.error);
    CHECK(error >= 1e-3 * stress.error);
    // Single precision has 6e-8; loads at one node cancel, and sums have 40 terms.
    CHECK(stress.error <= 1e-4 * expected.values().cwiseAbs().maxCoeff());
  }
}

TEST_CASE("no unit force stresses a particle more than the largest norm") {
  Random random(93);
  for (int sample = 0; sample < 30; ++sample) {
    const InfluenceOperator exact = random_operator(random, 60);
    const Mesh& mesh = exact.mesh();
    const InfluenceOperatorF32 compact(exact);
    double largest = 0;
    for (auto& load : test::random_loads(mesh, 400, random)) {
      load.force_body /= load.force_body.norm();
      largest = std::max(largest,
                         std::sqrt(frobenius_square(test::stress_of(exact, std::span(&load, 1)))));
    }
    // Round-off of sums in single precision.
    CHECK(largest <= (1 + 2e-5) * compact.largest_norm());
    // The bound on the shares of quadratic shape functions takes another fifth.
    CHECK(largest >= 0.5 * compact.largest_norm());
  }
}

TEST_CASE("a load off the boundary or not finite is refused") {
  Random random(93);
  const Mesh mesh = test::random_mesh(random, 40);
  const InfluenceOperatorF32 compact(exact_operator(mesh));
  ElementStressF32 out;
  const auto find = [&](const BoundaryLoad& load) {
    const std::vector<BoundaryLoad> loads{load};
    compact.find_stress(loads, 1, out);
  };
  CHECK_NOTHROW(find({{0, 1, 0.5}, {1, 0}}));
  CHECK_THROWS_AS(find({{9999, 0, 0.5}, {1, 0}}), InvalidInput);
  CHECK_THROWS_AS(find({{0, 1, 1.5}, {1, 0}}), InvalidInput);
  CHECK_THROWS_AS(find({{0, 1, 0.5}, {std::nan(""), 0}}), InvalidInput);
}
