// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/weighted_influence.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/weighted_norm.hpp>

using namespace riprap;

namespace {

// With three or six nodes.
InfluenceOperator random_operator(Random& random) {
  const Mesh mesh = test::random_mesh(random, 60);
  if (random.uniform_integer(0, 1) == 0)
    return {mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false};
  return {mesh, LinearStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false};
}

struct Weighted {
  explicit Weighted(Random& random)
      : exact(random_operator(random)), compact(exact),
        factors(test::random_factors(random, exact.sampling_points().size())) {}

  [[nodiscard]] std::vector<LocatedPoint> places(const std::vector<BoundaryLoad>& loads) const {
    std::vector<LocatedPoint> all;
    for (const BoundaryLoad& load : loads) {
      all.push_back(compact.locator().nearest(exact.mesh().position(load.at)));
      all.back().at = load.at;
    }
    return all;
  }
  [[nodiscard]] WeightedInfluence influence(const std::vector<BoundaryLoad>& loads) const {
    WeightedInfluence found;
    found.assign(compact, loads, places(loads), factors);
    return found;
  }

  InfluenceOperator exact;
  InfluenceOperatorF32 compact;
  std::vector<float> factors;
};

// Moves a point by an arc length, counter-clockwise positive; true if it has passed a corner.
bool walk(const Mesh& mesh, double arc, BoundaryPoint& at) {
  const auto next = [&](std::uint32_t node) { return (node + 1) % mesh.boundary_nodes; };
  const auto length = [&](std::uint32_t node) {
    return (mesh.nodes[next(node)] - mesh.nodes[node]).norm();
  };
  const auto is_corner = [&](std::uint32_t node) {
    return std::find(mesh.corners.begin(), mesh.corners.end(), node) != mesh.corners.end();
  };
  bool passed = false;
  std::uint32_t node = at.node;
  double along = (1 - at.weight) * length(node) + arc;
  for (; along < 0; along += length(node)) {
    passed |= is_corner(node);
    node = (node + mesh.boundary_nodes - 1) % mesh.boundary_nodes;
  }
  for (; along > length(node); node = next(node)) {
    along -= length(node);
    passed |= is_corner(next(node));
  }
  at = {node, next(node), 1 - along / length(node)};
  return passed;
}

double value(const AxisForm& form, const Vec2& p, const Vec2& q) {
  const auto x = Vec2{form.xx, form.xy};
  const auto y = Vec2{form.yx, form.yy};
  return p.x() * x.dot(q) + p.y() * y.dot(q);
}

}  // namespace

TEST_CASE("the norm of the weighted stresses is a quadratic form in the forces") {
  Random random(92);
  for (int sample = 0; sample < 30; ++sample) {
    const Weighted particle(random);
    const auto loads = test::random_loads(particle.exact.mesh(), 4, random);
    const WeightedInfluence influence = particle.influence(loads);
    double form = 0;
    double terms = 0;
    for (std::size_t c = 0; c < loads.size(); ++c) {
      for (std::size_t d = 0; d < loads.size(); ++d)
        form += value(influence.product(c, d), loads[c].force_body, loads[d].force_body);
      terms += std::sqrt(value(influence.product(c, c), loads[c].force_body, loads[c].force_body));
    }
    const double norm =
        test::weighted_norm(test::stress_of(particle.exact, loads), particle.factors);
    CHECK(std::abs(form - norm * norm) <= WeightedInfluence::product_error * terms * terms);
  }
}

TEST_CASE("no unit force gives more than the largest weighted norm") {
  Random random(93);
  for (int sample = 0; sample < 10; ++sample) {
    const Weighted particle(random);
    const double largest = particle.influence({}).largest_norm();
    for (auto& load : test::random_loads(particle.exact.mesh(), 100, random)) {
      load.force_body /= load.force_body.norm();
      const ElementStress stress = test::stress_of(particle.exact, std::span(&load, 1));
      CHECK(test::weighted_norm(stress, particle.factors) <= (1 + 2e-5) * largest);
    }
  }
}

// Along its edge, and round a corner where that is allowed.
TEST_CASE("a force that moves changes the weighted stresses by no more than its sensitivity") {
  Random random(94);
  double tightest = 0;
  int round_corners = 0;
  for (int sample = 0; sample < 40; ++sample) {
    const Weighted particle(random);
    const Mesh& mesh = particle.exact.mesh();
    const auto loads = test::random_loads(mesh, 60, random);
    const auto places = particle.places(loads);
    const WeightedInfluence influence = particle.influence(loads);
    for (std::size_t c = 0; c < loads.size(); ++c) {
      const PositionSensitivity& found = influence.position_sensitivity(c);
      const double size = loads[c].force_body.norm();
      CHECK(found.force <= 1.001f * found.unit * static_cast<float>(size));
      for (const double part : {-0.999, -0.5, -0.01, 0.01, 0.5, 0.999}) {
        double arc = part * static_cast<double>(found.radius);
        BoundaryLoad moved = loads[c];
        bool corner = walk(mesh, arc, moved.at);
        if (corner && !found.holds_round_corner) continue;
        if (corner) {  // as far again beyond the corner as the load is from it
          moved = loads[c];
          const double from_corner = std::abs(places[c].from_corner);
          arc += part < 0 ? -from_corner : from_corner;
          corner = walk(mesh, arc, moved.at);
          ++round_corners;
        }
        ElementStress change = test::stress_of(particle.exact, std::span(&moved, 1));
        change.values() -= test::stress_of(particle.exact, std::span(&loads[c], 1)).values();
        const double norm = test::weighted_norm(change, particle.factors);
        const double bound = static_cast<double>(found.force) * std::abs(arc);
        // Round-off of the columns, which the reference allows for.
        CHECK(norm <= bound + 1e-6 * influence.largest_norm() * size);
        tightest = std::max(tightest, norm / bound);
      }
    }
  }
  CHECK(round_corners > 100);
  CHECK(tightest >= 0.95);
}
