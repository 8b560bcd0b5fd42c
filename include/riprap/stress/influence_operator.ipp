// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <riprap/core/simd.hpp>
#include <riprap/stress/banded_stiffness.hpp>
#include <riprap/stress/influence_operator.hpp>

// Plain loops: the classes that Eigen makes of every expression took compilers longer than the
// loops do.

namespace riprap {

namespace internal {

/// The three rigid modes of a particle, or forces that go with them: one number for each
/// displacement of a node.
using Modes = std::array<std::vector<double>, 3>;

// The product of the rows r of a and c of b.
[[nodiscard]] inline double row_product(const Modes& a, std::size_t r, const Modes& b,
                                        std::size_t c) {
  return a[0][r] * b[0][c] + a[1][r] * b[1][c] + a[2][r] * b[2][c];
}

[[nodiscard]] RIPRAP_INLINE Modes rigid_modes(const std::vector<Vec2>& nodes) {
  Modes rigid;
  for (auto& mode : rigid) mode.assign(2 * nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rigid[0][2 * i] = rigid[1][2 * i + 1] = 1;
    rigid[2][2 * i] = -nodes[i].y();
    rigid[2][2 * i + 1] = nodes[i].x();
  }
  return rigid;
}

// Forces of unit rigid accelerations, over the mass. The density cancels, and about the centroid
// the rigid modes are orthogonal in mass.
[[nodiscard]] RIPRAP_INLINE Modes inertial_modes(const Modes& rigid, const Mesh& mesh,
                                                 const ElementMatrices& elements) {
  Modes inertial;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    std::vector<double>& force = inertial[mode];
    force.assign(rigid[mode].size(), 0);
    for (std::size_t e = 0; e < mesh.size(); ++e)
      for (std::size_t p = 0; p < elements.nodes; ++p)
        for (std::size_t q = 0; q < elements.nodes; ++q)
          for (std::size_t axis = 0; axis < 2; ++axis)
            force[2 * std::size_t{mesh.node(e, q)} + axis] +=
                elements.mass_of(e)[elements.nodes * p + q] *
                rigid[mode][2 * std::size_t{mesh.node(e, p)} + axis];
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i) sum += rigid[mode][i] * force[i];
    for (double& f : force) f /= sum;
  }
  return inertial;
}

}  // namespace internal

RIPRAP_INLINE void InfluenceOperator::add_stress(const BoundaryPoint& at, const Vec2& force,
                                                 ElementStress& stress) const {
  require_boundary_load(at, force, mesh_.boundary_nodes);
  require(stress.values().size() == stress_.rows(), "ElementStress.size()",
          static_cast<double>(stress.size()), "must be that of the operator's sampling_points()");
  if (!mesh_.mid_sides.empty()) return add_quadratic_stress(at, force, stress);
  const double w = at.weight;
  const double near_x = w * force.x();
  const double near_y = w * force.y();
  const double far_x = (1 - w) * force.x();
  const double far_y = (1 - w) * force.y();
  const auto count = static_cast<std::size_t>(stress_.rows());
  const double* const near = stress_.data() + column(at.node) * stress_.rows();
  const double* const far = stress_.data() + column(at.next) * stress_.rows();
  double* const sum = stress.values().data();
  const auto lanes = [](const double* from) { return load_lanes<DoubleLanes>(from); };
  std::size_t i = 0;
  for (; i + native_lanes <= count; i += native_lanes) {
    const DoubleLanes all =
        lanes(sum + i) + (near_x * lanes(near + i) + near_y * lanes(near + count + i) +
                          far_x * lanes(far + i) + far_y * lanes(far + count + i));
    store_lanes(sum + i, all);
  }
  for (; i < count; ++i)
    sum[i] += near_x * near[i] + near_y * near[count + i] + far_x * far[i] + far_y * far[count + i];
}

// The same with the shares of three nodes.
RIPRAP_INLINE void InfluenceOperator::add_quadratic_stress(const BoundaryPoint& at,
                                                           const Vec2& force,
                                                           ElementStress& stress) const {
  const NodalShares shares = nodal_shares(at, true, mesh_.boundary_nodes);
  const auto count = static_cast<std::size_t>(stress_.rows());
  double* const sum = stress.values().data();
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = shares.weights[k] * force.x();
    const double y = shares.weights[k] * force.y();
    const double* const columns = stress_.data() + column(shares.nodes[k]) * stress_.rows();
    std::size_t i = 0;
    for (; i + native_lanes <= count; i += native_lanes)
      store_lanes(sum + i, load_lanes<DoubleLanes>(sum + i) +
                               (x * load_lanes<DoubleLanes>(columns + i) +
                                y * load_lanes<DoubleLanes>(columns + count + i)));
    for (; i < count; ++i) sum[i] += x * columns[i] + y * columns[count + i];
  }
}

RIPRAP_INLINE Vec2 InfluenceOperator::displacement(const BoundaryPoint& of, const BoundaryPoint& at,
                                                   const Vec2& force) const {
  const auto block = [&](std::uint32_t i, std::uint32_t j) -> Vec2 {
    const auto f = [&](Eigen::Index p, Eigen::Index q) {
      return flexibility_(column(i) + p, column(j) + q);
    };
    return {f(0, 0) * force.x() + f(0, 1) * force.y(), f(1, 0) * force.x() + f(1, 1) * force.y()};
  };
  const bool quadratic = !mesh_.mid_sides.empty();
  const NodalShares to = nodal_shares(of, quadratic, mesh_.boundary_nodes);
  const NodalShares from = nodal_shares(at, quadratic, mesh_.boundary_nodes);
  const auto row = [&](std::size_t i) {
    Vec2 sum = from.weights[0] * block(to.nodes[i], from.nodes[0]);
    for (std::size_t j = 1; j < from.count; ++j)
      sum += from.weights[j] * block(to.nodes[i], from.nodes[j]);
    return sum;
  };
  Vec2 sum = to.weights[0] * row(0);
  for (std::size_t i = 1; i < to.count; ++i) sum += to.weights[i] * row(i);
  return sum;
}

RIPRAP_INLINE void InfluenceOperator::build(const ElementMatrices& elements,
                                            const double* elasticity, double thickness,
                                            bool with_flexibility) {
  BandedStiffness stiffness(mesh_, elements.nodes);
  assemble(elements, elasticity, thickness, stiffness);
  stiffness.hold(mesh_);
  stiffness.factorise();
  const std::size_t loads = 2 * std::size_t{mesh_.boundary_nodes};
  std::vector<double> displacement = balanced_loads(elements, stiffness);
  stiffness.solve(displacement, loads);
  find_stress(displacement, stiffness, elements, elasticity);
  double sum = 0;
  for (Eigen::Index i = 0; i < stress_.size(); ++i) sum += stress_.data()[i];
  require(std::isfinite(sum), "InfluenceOperator: sum of the stresses of unit loads", sum,
          "must be finite (element, plane state)");
  if (!with_flexibility) return;
  const Eigen::Index size = stress_.cols();
  flexibility_.resize(size, size);
  for (Eigen::Index r = 0; r < size; ++r) {
    const auto of = static_cast<std::size_t>(r);
    const double* const from = displacement.data() + stiffness.row(of / 2, of % 2) * loads;
    for (Eigen::Index c = 0; c < size; ++c) flexibility_(r, c) = from[c];
  }
}

RIPRAP_INLINE void InfluenceOperator::assemble(const ElementMatrices& elements,
                                               const double* elasticity, double thickness,
                                               BandedStiffness& stiffness) const {
  const std::size_t size = 2 * elements.nodes;
  for (std::size_t e = 0; e < mesh_.size(); ++e) {
    const double volume = thickness * mesh_.area(e);
    const auto row = [&](std::size_t p) { return stiffness.row(mesh_.node(e, p / 2), p % 2); };
    for (std::size_t i = 0; i < elements.shares.size(); ++i) {
      const double part = elements.shares[i] * volume;
      const double* const strain = elements.strain_to_integrate(e, i);
      const auto b = [&](std::size_t component, std::size_t col) {
        return strain[3 * col + component];
      };
      for (std::size_t p = 0; p < size; ++p) {
        std::array<double, 3> stress{};
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k) stress[j] += part * b(k, p) * elasticity[3 * j + k];
        for (std::size_t q = 0; q < size; ++q) {
          double sum = 0;
          for (std::size_t j = 0; j < 3; ++j) sum += stress[j] * b(j, q);
          stiffness.add(row(q), row(p), sum);
        }
      }
    }
  }
}

// A unit force at each boundary node along each axis, less the inertia of the particle that it
// accelerates (inertia relief).
RIPRAP_INLINE std::vector<double>
InfluenceOperator::balanced_loads(const ElementMatrices& elements,
                                  const BandedStiffness& stiffness) const {
  const internal::Modes rigid = internal::rigid_modes(mesh_.nodes);
  const internal::Modes inertial = internal::inertial_modes(rigid, mesh_, elements);
  const std::size_t loads = 2 * std::size_t{mesh_.boundary_nodes};
  std::vector<double> force(stiffness.size() * loads);
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    double* const row = force.data() + stiffness.row(i / 2, i % 2) * loads;
    for (std::size_t c = 0; c < loads; ++c) row[c] = -internal::row_product(inertial, i, rigid, c);
    if (i < loads) row[i] += 1;
  }
  return force;
}

RIPRAP_INLINE void InfluenceOperator::find_stress(const std::vector<double>& displacement,
                                                  const BandedStiffness& stiffness,
                                                  const ElementMatrices& elements,
                                                  const double* elasticity) {
  const std::size_t count = sampling_points().size();
  const std::size_t loads = 2 * std::size_t{mesh_.boundary_nodes};
  const std::size_t rows = 3 * count;
  stress_.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(loads));
  // Row by row, but written in blocks of a cache line: columns are far apart.
  constexpr std::size_t block = 8;
  std::vector<double> of_loads(block * loads);
  for (std::size_t first = 0; first < rows; first += block) {
    const std::size_t some = std::min(block, rows - first);
    std::fill(of_loads.begin(), of_loads.end(), 0);
    for (std::size_t r = 0; r < some; ++r) {
      const std::size_t component = (first + r) / count;
      const std::size_t i = (first + r) % count;
      const std::size_t e = i / rule_.size();
      for (std::size_t k = 0; k < 2 * elements.nodes; ++k) {
        const double* const strain = elements.sampled_strain(i) + 3 * k;
        // The one place where tension-positive algebra becomes compression-positive stress.
        const double to_stress =
            -(elasticity[component] * strain[0] +
              (elasticity[component + 3] * strain[1] + elasticity[component + 6] * strain[2]));
        const double* const u =
            displacement.data() + stiffness.row(mesh_.node(e, k / 2), k % 2) * loads;
        internal::subtract(-to_stress, u, loads, of_loads.data() + r * loads);
      }
    }
    double* to = stress_.data() + first;
    for (std::size_t c = 0; c < loads; ++c, to += rows)
      for (std::size_t r = 0; r < some; ++r) to[r] = of_loads[r * loads + c];
  }
}

}  // namespace riprap
