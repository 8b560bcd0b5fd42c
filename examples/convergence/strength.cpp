// SPDX-License-Identifier: BSL-1.0
#include "strength.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/line_fit/mean_tension_line.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/line_fit/weighted_xy_by_mean_stress.hpp>
#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>

#include "graded_mesh.hpp"

namespace convergence {

using namespace riprap;

namespace {

// Also of meshes that divide edges unevenly, for which BoundaryLocator is not made.
BoundaryPoint nearest_on_boundary(const Mesh& mesh, const Vec2& x) {
  BoundaryPoint nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) {
    const std::uint32_t next = (i + 1) % mesh.boundary_nodes;
    const Vec2 side = mesh.nodes[next] - mesh.nodes[i];
    const double along = std::clamp((x - mesh.nodes[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    const BoundaryPoint at{i, next, 1 - along};
    const double distance = (mesh.position(at) - x).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = at;
    }
  }
  return nearest;
}

template <Element E, PlaneState P>
Field solve(const LoadedParticle& particle, double thickness, const Mesh& mesh, const E& element,
            const P& plane) {
  AssembleAndSolve solver(mesh, element, plane, Rock{}, thickness);
  Field field{.mesh = solver.mesh(), .rule = E::sampling_points};
  std::vector<BoundaryLoad> loads;
  for (const auto& [arm, force] : particle.forces)
    loads.push_back({nearest_on_boundary(field.mesh, arm), force, force.norm()});
  solver.solve_free(loads, field.stress);
  return field;
}

Mesh mesh_of(const LoadedParticle& particle, const MeshChoice& choice) {
  if (!choice.graded) return UniformMesher{choice.triangles}(particle.ring);
  std::vector<Vec2> points;
  for (const PointForce& f : particle.forces) points.push_back(f.arm);
  return graded_mesh(particle.ring, points, choice.triangles);
}

}  // namespace

std::vector<double> Field::areas() const {
  const SamplingPoints all = points();
  std::vector<double> areas;
  for (std::size_t i = 0; i < all.size(); ++i) areas.push_back(all.area(i));
  return areas;
}

Field stress_field(const LoadedParticle& particle, double thickness, const MeshChoice& choice,
                   Plane plane) {
  const Mesh mesh = mesh_of(particle, choice);
  const auto by_plane = [&](const auto& element) {
    if (plane == Plane::strain) return solve(particle, thickness, mesh, element, PlaneStrain{});
    return solve(particle, thickness, mesh, element, PlaneStress{});
  };
  if (choice.six_nodes) return by_plane(LinearStrainTriangle{});
  return by_plane(ConstantStrainTriangle{});
}

double failed_share(const HoekBrown& criterion, const ElementStress& stress,
                    std::span<const double> areas, double factor) {
  double failed = 0;
  double all = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    all += areas[i];
    if (evaluate(criterion, factor * stress[i]).failed()) failed += areas[i];
  }
  return failed / all;
}

double critical_load(const HoekBrown& criterion, const ElementStress& stress,
                     std::span<const double> areas, double limit) {
  // As FailedAreaRatio compares, so that 40 of 100 equal areas reach 0.4.
  const auto breaks = [&](double factor) {
    return failed_share(criterion, stress, areas, factor) >= (1 - 1e-9) * limit;
  };
  double high = 1;
  while (!breaks(high)) high *= 2;
  double low = 0.5 * high;
  while (breaks(low)) {
    high = low;
    low *= 0.5;
  }
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (low + high);
    (breaks(middle) ? high : low) = middle;
  }
  return high;
}

std::array<std::optional<Line>, line_names.size()> crack_lines(const HoekBrown& criterion,
                                                               const Field& field, double factor) {
  ElementStress stress = field.stress;
  stress.values() *= factor;
  const SamplingPoints points = field.points();
  const FailureCount failures = count_failures(criterion, stress);
  const Stress2 first = stress[failures.first_failed];
  const FailurePlanes planes = failure_planes(criterion, first, evaluate(criterion, first).mode);
  const std::vector<WeightedPoint> failed = failed_points(criterion, points, stress, Body{});
  const auto line = [&](const auto& fit) {
    return fit_line(fit, failed, planes, mean_stress(points, stress));
  };
  return {line(WeightedXY{}), line(TotalLeastSquares{}), line(MeanTensionLine{}),
          line(WeightedXYByMeanStress{})};
}

}  // namespace convergence
