// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Unconfined compression of a specimen of intact rock (section 3.2 of the paper). Not part of
/// riprap.hpp: it needs sparse solvers.

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/experiment/platen_slip.hpp>
#include <riprap/experiment/unconfined_result.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/prescribed_displacement.hpp>

namespace riprap {

/// Linear elasticity, pressed together by two rigid platens that stay parallel, until the mean
/// platen stress is `load` times the uniaxial strength of the criterion, sigma_1f at sigma_3 = 0.
/// Failed elements keep their stiffness. Stress is linear in the load and so independent of Young's
/// modulus; under a criterion that scales with its strength, Rat is independent of that, too.
///
/// With smooth platens, or Poisson's ratio 0, stress is uniform, and at `load` = 1 every element
/// lies on the failure surface itself: round-off decides, and Rat means nothing. With any friction
/// it does: of a small disturbance only the shape counts, not the size.
struct UnconfinedCompression {
  double width = 0.054;      ///< [m]
  double height = 0.108;     ///< [m]
  double thickness = 0.054;  ///< out of plane [m]; stress does not depend on it
  /// Of the platens [-]: 0 for smooth ones, infinity for rough ones, to which all nodes stick.
  double friction = std::numeric_limits<double>::infinity();
  double load = 1;  ///< mean platen stress over the uniaxial strength [-]

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require_positive("UnconfinedCompression.width", width);
    require_positive("UnconfinedCompression.height", height);
    require_positive("UnconfinedCompression.thickness", thickness);
    require(friction >= 0, "UnconfinedCompression.friction", friction,
            "must be 0 or above; infinity for rough platens");
    require_positive("UnconfinedCompression.load", load);
  }

  /// Throws InvalidInput, for a criterion without a finite strength above 0 as well.
  template <Criterion C, Mesher M = UniformMesher, PlaneState P = PlaneStress,
            Element E = ConstantStrainTriangle>
  [[nodiscard]] UnconfinedResult run(const Rock& rock, const C& criterion,
                                     const M& mesher = M{.triangles = 1000}, const P& plane = P{},
                                     const E& element = E{}) const {
    validate();
    rock.validate();
    riprap::validate(criterion);
    riprap::validate(mesher);
    UnconfinedResult result;
    result.strength = criterion.major_stress_at_failure(0);
    require_positive("UnconfinedCompression: uniaxial strength of the criterion", result.strength);
    const ConvexPolygon rectangle{{-0.5 * width, -0.5 * height},
                                  {0.5 * width, -0.5 * height},
                                  {0.5 * width, 0.5 * height},
                                  {-0.5 * width, 0.5 * height}};
    result.mesh = mesh_for_element<E::nodes>(mesher(rectangle.ring()));
    result.sampling_rule = E::sampling_points;
    find_platen_nodes(result);
    Deformation d = shortened(result, element, plane, rock);
    apply_load(d, result);
    result.stress = std::move(d.stress);
    judge(criterion, result);
    return result;
  }

 private:
  // The edges of the rectangle are those of the bottom, the right, the top and the left.
  static void find_platen_nodes(UnconfinedResult& r) {
    const auto& corners = r.mesh.corners;
    for (std::uint32_t n = corners[0]; n <= corners[1]; ++n)
      r.platen_nodes.push_back({.node = n, .top = false});
    for (std::uint32_t n = corners[3] + 1; n-- > corners[2];)
      r.platen_nodes.push_back({.node = n, .top = true});
  }

  // Lateral components first, then normal ones, each in the order of the platen nodes.
  [[nodiscard]] static std::vector<NodeComponent> both_components(const UnconfinedResult& r) {
    std::vector<NodeComponent> held;
    for (const std::uint32_t axis : {0u, 1u})
      for (const PlatenNode& n : r.platen_nodes) held.push_back({n.node, axis});
    return held;
  }

  // By its own height: displacement-controlled, and scaled to the load afterwards.
  template <class E, class P>
  [[nodiscard]] Deformation shortened(UnconfinedResult& r, const E& element, const P& plane,
                                      const Rock& rock) const {
    const std::size_t count = r.platen_nodes.size();
    std::vector<NodeComponent> held = both_components(r);
    std::vector<double> values(2 * count, 0.0);
    for (std::size_t i = 0; i < count; ++i)
      values[count + i] = r.platen_nodes[i].top ? -height : 0.0;
    if (friction == 0) {  // one node keeps the specimen in place, without a force
      held.erase(held.begin() + 1, held.begin() + static_cast<std::ptrdiff_t>(count));
      values.erase(values.begin() + 1, values.begin() + static_cast<std::ptrdiff_t>(count));
    }
    const PrescribedDisplacement<E, P> solver(r.mesh, element, plane, rock, thickness, held);
    if (friction > 0 && std::isfinite(friction)) slip(solver, r, values);
    return solver.solve(values);
  }

  // Fills the lateral half of the values.
  template <class Solver>
  void slip(const Solver& solver, const UnconfinedResult& r, std::vector<double>& values) const {
    const auto count = static_cast<Eigen::Index>(r.platen_nodes.size());
    const auto read = [&](const Deformation& d, auto&& pressed, auto&& held) {
      for (Eigen::Index i = 0; i < count; ++i) {
        const PlatenNode& n = r.platen_nodes[static_cast<std::size_t>(i)];
        held[i] = d.force(n.node).x();
        pressed[i] = (n.top ? -1 : 1) * d.force(n.node).y();
      }
    };
    PlatenNodes nodes{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::MatrixXd(count, count),
                      Eigen::MatrixXd(count, count)};
    read(solver.solve(values), nodes.pressed, nodes.held);
    std::vector<double> unit(values.size(), 0.0);
    for (Eigen::Index k = 0; k < count; ++k) {
      unit[static_cast<std::size_t>(k)] = 1;
      read(solver.solve(unit), nodes.pressed_per_slip.col(k), nodes.held_per_slip.col(k));
      unit[static_cast<std::size_t>(k)] = 0;
    }
    const Eigen::VectorXd slips = coulomb_slip(nodes, friction);
    for (Eigen::Index i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = slips[i];
  }

  void apply_load(Deformation& d, UnconfinedResult& r) const {
    double force = 0;
    for (PlatenNode& n : r.platen_nodes) {
      n.force = d.force(n.node);
      if (n.top) force += n.normal_force();
    }
    r.platen_stress = load * r.strength;
    const double factor = r.platen_stress * width * thickness / force;
    d.scale(factor);
    r.axial_strain = factor;
    for (PlatenNode& n : r.platen_nodes) {
      n.force = d.force(n.node);
      n.slip = d.displacement(n.node).x();
    }
  }

  template <class C>
  static void judge(const C& criterion, UnconfinedResult& r) {
    r.failures = count_failures(criterion, r.stress);
    for (std::size_t e = 0; e < r.stress.size(); ++e) {
      r.elements.push_back(evaluate(criterion, r.stress[e]));
      r.tensile += r.elements[e].mode == FailureMode::tension;
      r.shear += r.elements[e].mode == FailureMode::shear;
    }
  }
};

}  // namespace riprap
