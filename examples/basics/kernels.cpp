// SPDX-License-Identifier: BSL-1.0
// kernels: overlap, cut, influence operator and criterion, each alone, beside closed forms
// What a simulation is made of can be called without one.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
using namespace riprap;

/// Prints a number beside its closed form; true if they are the same but for round-off.
bool same(const char* what, double value, double expected) {
  std::printf("%-44s %12.8g, closed form %12.8g\n", what, value, expected);
  return std::abs(value - expected) <= 1e-9 * std::abs(expected);
}

int main() {
  bool all = true;
  const double side = 0.016;  // [m]
  const ConvexPolygon square{
      {-side / 2, -side / 2}, {side / 2, -side / 2}, {side / 2, side / 2}, {-side / 2, side / 2}};

  // The common part of two polygons: a quarter of the square.
  const ConvexPolygon other = square.moved({}, {side / 2, side / 2});
  const OverlapPolygon common = overlap(square.ring(), other.ring(), {0, 0}, 0);
  all &= same("area of an overlap [m^2]", polygon_area(common.ring()), side * side / 4);

  // A straight cut that leaves a triangle with legs of a quarter of the side.
  const Line line{{-side / 4, -side / 2}, Vec2{-1, 1}.normalized()};
  const auto pieces = cut(square.ring(), line);
  if (!pieces) return 1;
  const double smaller = std::min(polygon_area(pieces->left), polygon_area(pieces->right));
  all &= same("area cut off [m^2]", smaller, side * side / 32);

  // Two opposite forces across the square. The mean stress of any body in equilibrium is the sum
  // of force times place over its volume, whatever the mesh.
  const double thickness = 0.016;  // [m]
  const double force = 5000;       // [N]
  const InfluenceOperator influence(UniformMesher{.triangles = 200}(square.ring()),
                                    ConstantStrainTriangle{}, PlaneStress{}, Rock{}, thickness,
                                    false);
  const Mesh& mesh = influence.mesh();
  const SamplingPoints points = influence.sampling_points();
  ElementStress stress;
  stress.reset(points.size());
  influence.add_stress(nearest_boundary_point(mesh, {0, side / 2}), {0, -force}, stress);
  influence.add_stress(nearest_boundary_point(mesh, {0, -side / 2}), {0, force}, stress);
  double mean = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    mean += points.area(i) * stress[i].s22 / (side * side);
  all &= same("mean stress under two opposite forces [Pa]", mean, force / (side * thickness));

  // Uniaxial compression by 0.8 of the strength: intact, with the safety factor 1 / 0.8.
  const HoekBrown rock{.compressive_strength = 300e6};  // [Pa]
  const ElementFailure element = evaluate(rock, Stress2{0, 240e6, 0});
  all &= same("safety factor at 0.8 of the strength [-]", element.safety_factor, 1 / 0.8);
  return all && !element.failed() ? 0 : 1;
}
