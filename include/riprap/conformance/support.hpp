// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the support.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/support/concepts.hpp>

namespace riprap {
namespace internal {

/// A square of 20 mm, in triangles from its twelve boundary nodes to the middle.
template <Support S>
[[nodiscard]] InfluenceOperator square_operator() {
  const std::array<Vec2, 4> ring{Vec2{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0.01}, {-0.01, 0.01}};
  Mesh mesh;
  for (std::size_t k = 0; k < 4; ++k) {
    mesh.corners.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
    for (int i = 0; i < 3; ++i)
      mesh.nodes.push_back(ring[k] + i / 3.0 * (ring[(k + 1) % 4] - ring[k]));
  }
  mesh.boundary_nodes = 12;
  mesh.nodes.push_back({0, 0});
  for (std::uint32_t i = 0; i < 12; ++i) mesh.triangles.push_back({i, (i + 1) % 12, 12});
  return {std::move(mesh), ConstantStrainTriangle{}, PlaneStress{}, Rock{},
          0.016,           S::needs_flexibility};
}

/// Forces of up to 1 kN, each pair of neighbours pressed together or drawn apart along the line
/// between them: in balance.
[[nodiscard]] inline std::vector<BoundaryLoad> balanced_loads(Random& random, std::uint32_t count,
                                                              const Mesh& mesh) {
  std::vector<BoundaryLoad> loads;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t node = 12 * i / count;
    loads.push_back({.at = {node, (node + 1) % 12, random.uniform(0.1, 0.9)},
                     .normal_force = random.uniform(0, 1e3)});
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    const Vec2 apart = mesh.position(loads[i + 1].at) - mesh.position(loads[i].at);
    const Vec2 force = random.uniform(-1e3, 1e3) * apart.normalized();
    loads[i].force_body -= force;
    loads[i + 1].force_body += force;
  }
  return loads;
}

}  // namespace internal

/// Which axioms a support breaks.
template <Support S>
[[nodiscard]] Violations support_violations(const S& support) {
  AxiomCheck check;
  Random random(1);
  const InfluenceOperator op = internal::square_operator<S>();
  for (const std::uint32_t count : {0u, 1u, 2u, 3u, 4u, 6u})
    for (int i = 0; i < 20; ++i) {
      check.at("number of loads", count);
      std::vector<BoundaryLoad> loads = internal::balanced_loads(random, count, op.mesh());
      for (BoundaryLoad& load : loads)
        load.force_body += Vec2{random.uniform(-100, 100), random.uniform(-100, 100)};
      std::vector<BoundaryLoad> balanced = loads;
      support.apply_reactions(balanced, op);

      std::vector<BoundaryLoad> tripled = loads;
      std::vector<BoundaryLoad> none = loads;
      for (std::size_t k = 0; k < count; ++k) {
        tripled[k].force_body *= 3;
        tripled[k].normal_force *= 3;
        none[k].force_body = Vec2{0, 0};
      }
      support.apply_reactions(tripled, op);
      support.apply_reactions(none, op);
      for (std::size_t k = 0; k < count; ++k) {
        check.equal("loads stay where they act: way",
                    (op.mesh().position(balanced[k].at) - op.mesh().position(loads[k].at)).norm(),
                    0, 0);
        check.equal("three times the loads have three times the reactions",
                    (tripled[k].force_body - 3 * balanced[k].force_body).norm(), 0, 1e-8);
        check.equal("without loads there are no reactions", none[k].force_body.norm(), 0, 0);
        if constexpr (LinearSupport<S>)
          if (support.is_linear())
            check.equal("a linear support leaves the loads as they are: difference [N]",
                        (balanced[k].force_body - loads[k].force_body).norm(), 0, 0);
      }
    }
  return std::move(check).violations();
}

/// For supports that hold the particle and leave no load out: loads in balance stay so.
template <Support S>
[[nodiscard]] Violations support_balance_violations(const S& support) {
  AxiomCheck check;
  Random random(1);
  const InfluenceOperator op = internal::square_operator<S>();
  for (const std::uint32_t count : {2u, 3u, 4u, 6u})
    for (int i = 0; i < 20; ++i) {
      check.at("number of loads", count);
      std::vector<BoundaryLoad> loads = internal::balanced_loads(random, count, op.mesh());
      support.apply_reactions(loads, op);
      Vec2 force{0, 0};
      double moment = 0;
      for (const BoundaryLoad& load : loads) {
        force += load.force_body;
        moment += cross(op.mesh().position(load.at), load.force_body);
      }
      // Round-off of kilonewtons, and of kilonewtons at a hundredth of a metre.
      check.equal("forces in balance stay in balance: sum [N]", force.norm(), 0, 1e-8);
      check.equal("moments in balance stay in balance: sum [N m]", moment, 0, 1e-10);
    }
  return std::move(check).violations();
}

}  // namespace riprap
