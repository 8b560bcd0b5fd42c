// SPDX-License-Identifier: BSL-1.0
// Mesh, stress, failure, lines, cut: the steps of one check.

#include "analysis.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <span>

#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/support/inertia_relief.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

using namespace riprap;

namespace {

// The parts of a model that find_crack asks for.
struct Breaking {
  decltype(Case::criterion) criterion;
  WeightedXY line_fit{};
  StraightCut splitter{};
};

void check(const Case& c) {
  require_positive("--thickness", c.thickness);
  c.mesher.validate();
  c.trigger.validate();
  c.rock.validate();
  c.criterion.validate();
  c.splitter.validate();
  for (const PointForce& f : c.forces)
    for (const double value : {f.at.x(), f.at.y(), f.force.x(), f.force.y()})
      require(std::isfinite(value), "--force", value, "must be a finite number");
}

// Criteria square stresses, and not-a-number would count as an element that holds.
void check_stress(const Analysis& a) {
  constexpr double largest_stress = 1e100;  // [Pa]
  double largest_force = 0;
  for (const BoundaryLoad& load : a.loads)
    largest_force =
        std::max({largest_force, std::abs(load.force_body.x()), std::abs(load.force_body.y())});
  for (std::size_t e = 0; e < a.mesh.size(); ++e)
    for (const double value : {a.stress[e].s11, a.stress[e].s22, a.stress[e].s12})
      require(std::abs(value) <= largest_stress, "largest component of a --force", largest_force,
              "the stress in the particle is above 1e100 Pa or not finite");
}

// Contacts know their normal; of a bare force it is the share across the edge it acts on.
BoundaryLoad boundary_load(const Mesh& mesh, const Body& body, const PointForce& given) {
  const Vec2 force = body.rotation.inverse_times(given.force);
  const BoundaryPoint point =
      nearest_boundary_point(mesh, body.rotation.inverse_times(given.at - body.position));
  const Vec2 inward = perpendicular(mesh.nodes[point.next] - mesh.nodes[point.node]).normalized();
  return {point, force, given.normal.value_or(std::max(0.0, inward.dot(force)))};
}

template <Support S>
void solve(Analysis& a, const S& support) {
  const Case& c = a.given;
  const InfluenceOperator op(a.mesh, ConstantStrainTriangle{}, PlaneStress{}, c.rock, c.thickness,
                             S::needs_flexibility);
  a.balanced = a.loads;
  support.apply_reactions(std::span<BoundaryLoad>(a.balanced), op);
  a.stress.reset(op.sampling_points().size());
  for (const BoundaryLoad& load : a.balanced) op.add_stress(load.at, load.force_body, a.stress);
}

std::string with_digits(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// Which rule of the splitter the pieces break.
std::string why_refused(const Analysis& a, double mean_area) {
  if (!a.line()) return "No line: the failed elements determine none.";
  if (!a.pieces) return "Cut refused: the line leaves one side empty.";
  const StraightCut& rule = a.given.splitter;
  for (const auto& [name, piece] : {std::pair{"A", &a.pieces->left}, {"B", &a.pieces->right}}) {
    const double share = area_properties(*piece).area / mean_area;
    if (share < rule.minimum_area)
      return std::string("Cut refused: piece ") + name +
             with_digits(" has %.1f %% of the", 100 * share) +
             with_digits(" area, less than %g %%.", 100 * rule.minimum_area);
    if (aspect(*piece) > rule.maximum_aspect)
      return std::string("Cut refused: the aspect of piece ") + name +
             with_digits(" is %.2f,", aspect(*piece)) +
             with_digits(" more than %g.", rule.maximum_aspect);
  }
  return {};
}

void find_lines_and_pieces(Analysis& a) {
  const Case& c = a.given;
  const Ring ring = c.polygon.ring();
  const double area = area_properties(ring).area;
  if (a.failures.failed == 0) {
    a.refusal = "No element has failed.";
    return;
  }
  a.planes = failure_planes(c.criterion, a.stress[a.failures.first_failed].rotated(a.body.rotation),
                            a.first_failed().mode);
  const auto points = failed_points(c.criterion, SamplingPoints(a.mesh), a.stress, a.body);
  a.by_x = WeightedX{}(points, a.planes);
  a.by_y = WeightedY{}(points, a.planes);
  const std::optional<Line> chosen = WeightedXY{}(points, a.planes);
  a.x_chosen = chosen && a.by_x && chosen->direction == a.by_x->direction;

  if (!c.trigger(a.failures)) {
    a.refusal = "Stays whole: Rat = " + with_digits("%.2f", a.failures.ratio()) +
                " is below RatF = " + to_text(c.trigger.critical) + ".";
    return;
  }
  const Breaking model{.criterion = c.criterion, .splitter = c.splitter};
  const double mean_area = c.mean_area.value_or(area);
  a.crack =
      find_crack(model, a.failures, SamplingPoints(a.mesh), a.stress, a.body, ring, mean_area);
  if (a.crack) {
    a.pieces = a.crack->pieces;
    return;
  }
  const StraightCut any{.minimum_area = 0,
                        .maximum_aspect = std::numeric_limits<double>::infinity()};
  if (chosen) a.pieces = any(ring, *chosen, mean_area);
  a.refusal = why_refused(a, mean_area);
}

}  // namespace

Wrench Analysis::unbalanced() const {
  Wrench sum;
  for (const BoundaryLoad& load : loads) {
    sum.force += load.force_body;
    sum.moment += cross(mesh.position(load.at), load.force_body);
  }
  return sum;
}

Analysis analyse(Case given) {
  check(given);
  Analysis a{.given = std::move(given)};
  const Case& c = a.given;
  a.body.position = area_properties(c.polygon.ring()).centroid;
  a.body.rotation = c.rotation;
  const Rotation back{c.rotation.cosine, -c.rotation.sine};
  const ConvexPolygon local = c.polygon.moved(Rotation{}, -a.body.position).moved(back, {0, 0});
  a.mesh = c.mesher(local.ring());
  for (const PointForce& f : c.forces) a.loads.push_back(boundary_load(a.mesh, a.body, f));
  if (c.pinned)
    solve(a, TwoPinnedContacts{});
  else
    solve(a, InertiaRelief{});
  check_stress(a);
  for (std::size_t e = 0; e < a.mesh.size(); ++e)
    a.elements.push_back(evaluate(c.criterion, a.stress[e]));
  a.failures = count_failures(c.criterion, a.stress);
  find_lines_and_pieces(a);
  return a;
}
