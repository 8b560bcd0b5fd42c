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

double value(const AxisForm& form, const Vec2& p, const Vec2& q) {
  const auto x = Vec2{form.xx, form.xy};
  const auto y = Vec2{form.yx, form.yy};
  return p.x() * x.dot(q) + p.y() * y.dot(q);
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

TEST_CASE("the norm of all stresses is a quadratic form in the forces") {
  Random random(92);
  for (int sample = 0; sample < 30; ++sample) {
    const InfluenceOperator exact = random_operator(random, 60);
    const Mesh& mesh = exact.mesh();
    const InfluenceOperatorF32 compact(exact);
    const auto loads = test::random_loads(mesh, 4, random);
    double form = 0;
    double terms = 0;
    for (const BoundaryLoad& p : loads)
      for (const BoundaryLoad& q : loads)
        form += value(compact.product(p.at, q.at), p.force_body, q.force_body);
    for (const BoundaryLoad& p : loads)
      terms += std::sqrt(value(compact.product(p.at, p.at), p.force_body, p.force_body));
    const double expected = frobenius_square(test::stress_of(exact, loads));
    CHECK(std::abs(form - expected) <= InfluenceOperatorF32::product_error * terms * terms);
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
    // Half the round-off of the products.
    CHECK(largest <= (1 + InfluenceOperatorF32::product_error) * compact.largest_norm());
    // The bound on the shares of quadratic shape functions takes another fifth.
    CHECK(largest >= 0.5 * compact.largest_norm());
  }
}

TEST_CASE("a unit force that moves changes the stresses by no more than steepness times distance") {
  Random random(94);
  double tightest = 0;
  for (int sample = 0; sample < 30; ++sample) {
    const InfluenceOperator exact = random_operator(random, 60);
    const Mesh& mesh = exact.mesh();
    const InfluenceOperatorF32 compact(exact);
    for (BoundaryLoad load : test::random_loads(mesh, 100, random)) {
      load.force_body /= load.force_body.norm();
      const ElementStress there = test::stress_of(exact, std::span(&load, 1));
      const Vec2 place = mesh.position(load.at);
      const double position_sensitivity = compact.position_sensitivity(load.at);
      load.at.weight = random.uniform(0, 1);
      ElementStress moved = test::stress_of(exact, std::span(&load, 1));
      moved.values() -= there.values();
      const double distance = (mesh.position(load.at) - place).norm();
      const double change = std::sqrt(frobenius_square(moved));
      CHECK(change <= position_sensitivity * distance);
      tightest = std::max(tightest, change / (position_sensitivity * distance));
    }
  }
  CHECK(tightest >= 0.95);
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
