// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <Eigen/Cholesky>
#include <cmath>

#include <riprap/core/simd.hpp>
#include <riprap/stress/influence_operator.hpp>

// Plain loops: the classes that Eigen makes of every expression took compilers longer than the
// loops do.

namespace riprap {

namespace internal {

/// The three rigid modes of a particle, or forces that go with them: one number for each
/// displacement of a node.
using Modes = std::array<std::vector<double>, 3>;

// As a vector of Eigen.
[[nodiscard]] inline Eigen::Map<Eigen::VectorXd> vector(std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}
[[nodiscard]] inline Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

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

// Forces of unit rigid accelerations, over the mass.
template <class Once>
[[nodiscard]] Modes inertial_modes(const Modes& rigid, const std::vector<double>& mass) {
  const std::size_t n = rigid[0].size() / 2;
  Modes inertial;
  std::vector<double> acceleration(n);
  std::vector<double> force(n);
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::Map<const Eigen::MatrixXd> matrix(mass.data(), size, size);
  for (std::size_t mode = 0; mode < 3; ++mode) {
    inertial[mode].resize(2 * n);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (std::size_t i = 0; i < n; ++i) acceleration[i] = rigid[mode][2 * i + axis];
      vector(force) = matrix * vector(acceleration);
      for (std::size_t i = 0; i < n; ++i) inertial[mode][2 * i + axis] = force[i];
    }
    const double factor = 1 / vector(rigid[mode]).dot(vector(inertial[mode]));
    for (double& f : inertial[mode]) f *= factor;
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
    for (std::size_t i = 0; i < count; ++i) sum[i] += x * columns[i] + y * columns[count + i];
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

template <class Once>
void InfluenceOperator::build(const ElementMatrices& elements, const double* elasticity,
                              double thickness, bool with_flexibility) {
  const std::vector<double> displacement =
      solve<Once>(assemble_stiffness(elements, elasticity, thickness), assemble_mass(elements));
  find_stress(displacement, elements, elasticity);
  double sum = 0;
  for (Eigen::Index i = 0; i < stress_.size(); ++i) sum += stress_.data()[i];
  require(std::isfinite(sum), "InfluenceOperator: sum of the stresses of unit loads", sum,
          "must be finite (element, plane state)");
  if (!with_flexibility) return;
  const Eigen::Index loads = stress_.cols();
  const auto unknowns = static_cast<Eigen::Index>(2 * mesh_.nodes.size());
  flexibility_.resize(loads, loads);
  for (Eigen::Index c = 0; c < loads; ++c)
    std::copy_n(displacement.data() + c * unknowns, loads, flexibility_.data() + c * loads);
}

// By columns; so is the mass.
RIPRAP_INLINE std::vector<double>
InfluenceOperator::assemble_stiffness(const ElementMatrices& elements, const double* elasticity,
                                      double thickness) const {
  const std::size_t unknowns = 2 * mesh_.nodes.size();
  std::vector<double> stiffness(unknowns * unknowns, 0);
  const std::size_t size = 2 * elements.nodes;
  for (std::size_t e = 0; e < mesh_.size(); ++e) {
    const double volume = thickness * mesh_.area(e);
    const auto unknown = [&](std::size_t p) {
      return 2 * std::size_t{mesh_.node(e, p / 2)} + p % 2;
    };
    for (std::size_t i = 0; i < elements.shares.size(); ++i) {
      const double part = elements.shares[i] * volume;
      const double* const strain = elements.strain_to_integrate(e, i);
      const auto b = [&](std::size_t row, std::size_t col) { return strain[3 * col + row]; };
      for (std::size_t p = 0; p < size; ++p) {
        std::array<double, 3> stress{};
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k) stress[j] += part * b(k, p) * elasticity[3 * j + k];
        for (std::size_t q = 0; q < size; ++q) {
          double sum = 0;
          for (std::size_t j = 0; j < 3; ++j) sum += stress[j] * b(j, q);
          stiffness[unknown(q) * unknowns + unknown(p)] += sum;
        }
      }
    }
  }
  return stiffness;
}

RIPRAP_INLINE std::vector<double>
InfluenceOperator::assemble_mass(const ElementMatrices& elements) const {
  const std::size_t n = mesh_.nodes.size();
  std::vector<double> mass(n * n, 0);
  for (std::size_t e = 0; e < mesh_.size(); ++e)
    for (std::size_t p = 0; p < elements.nodes; ++p)
      for (std::size_t q = 0; q < elements.nodes; ++q)
        mass[mesh_.node(e, q) * n + mesh_.node(e, p)] +=
            elements.mass_of(e)[elements.nodes * q + p];
  return mass;
}

// Displacements of all nodes for a unit force at each boundary node along each axis.
template <class Once>
std::vector<double> InfluenceOperator::solve(std::vector<double> stiffness,
                                             const std::vector<double>& mass) const {
  const std::size_t n = mesh_.nodes.size();
  const std::size_t unknowns = 2 * n;
  // Inertia relief: forces less the mass times the rigid acceleration they cause. The density
  // cancels, and about the centroid the rigid modes are orthogonal in mass.
  internal::Modes rigid = internal::rigid_modes(mesh_.nodes);
  const internal::Modes inertial = internal::inertial_modes<Once>(rigid, mass);
  const std::size_t loads = 2 * std::size_t{mesh_.boundary_nodes};
  std::vector<double> displacement(unknowns * loads, 0);
  for (std::size_t c = 0; c < loads; ++c) {
    double* const column = displacement.data() + c * unknowns;
    column[c] = 1;
    for (std::size_t r = 0; r < unknowns; ++r)
      column[r] -= internal::row_product(inertial, r, rigid, c);
  }

  // Stiffness against rigid modes makes the matrix definite; balanced loads do not feel it.
  std::vector<double>& turn = rigid[2];
  const double size = internal::vector(turn).norm() / std::sqrt(static_cast<double>(n));
  for (double& x : turn) x /= size;
  double trace = stiffness[0];
  for (std::size_t i = 1; i < unknowns; ++i) trace += stiffness[i * unknowns + i];
  const double stiff = trace / static_cast<double>(2 * n * n);
  for (std::size_t c = 0; c < unknowns; ++c)
    for (std::size_t r = 0; r < unknowns; ++r)
      stiffness[c * unknowns + r] += stiff * internal::row_product(rigid, r, rigid, c);
  // A column at a time: where Eigen multiplies large matrices, it sums in blocks that suit the
  // caches of the processor, and the last bits would depend on it.
  const auto count = static_cast<Eigen::Index>(unknowns);
  const Eigen::LDLT<Eigen::MatrixXd> factors(
      Eigen::Map<const Eigen::MatrixXd>(stiffness.data(), count, count));
  for (std::size_t c = 0; c < loads; ++c) {
    Eigen::Map<Eigen::VectorXd> displaced(displacement.data() + c * unknowns, count);
    factors.solveInPlace(displaced);
  }
  return displacement;
}

RIPRAP_INLINE void InfluenceOperator::find_stress(const std::vector<double>& displacement,
                                                  const ElementMatrices& elements,
                                                  const double* elasticity) {
  const std::size_t size = 2 * elements.nodes;
  const std::size_t count = sampling_points().size();
  const std::size_t loads = displacement.size() / (2 * mesh_.nodes.size());
  stress_.resize(static_cast<Eigen::Index>(3 * count), static_cast<Eigen::Index>(loads));
  std::array<std::size_t, 12> unknown{};
  std::array<double, 12> to_stress{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t e = i / rule_.size();
    for (std::size_t k = 0; k < size; ++k)
      unknown[k] = 2 * std::size_t{mesh_.node(e, k / 2)} + k % 2;
    for (std::size_t row = 0; row < 3; ++row) {
      // The one place where tension-positive algebra becomes compression-positive stress.
      for (std::size_t k = 0; k < size; ++k) {
        const double* const strain = elements.sampled_strain(i) + 3 * k;
        to_stress[k] = -(elasticity[row] * strain[0] +
                         (elasticity[row + 3] * strain[1] + elasticity[row + 6] * strain[2]));
      }
      fill_row(row * count + i, {to_stress.data(), size}, {unknown.data(), size}, displacement);
    }
  }
}

// One row of the stresses, for all loads.
RIPRAP_INLINE void InfluenceOperator::fill_row(std::size_t row, std::span<const double> to_stress,
                                               std::span<const std::size_t> unknown,
                                               const std::vector<double>& displacement) {
  const std::size_t unknowns = 2 * mesh_.nodes.size();
  const auto rows = static_cast<std::size_t>(stress_.rows());
  const std::size_t loads = displacement.size() / unknowns;
  // Copies: the entries that are written might be these numbers for all that a compiler knows.
  std::array<double, 6> factors{};
  std::array<std::size_t, 6> places{};
  std::copy_n(to_stress.begin(), 6, factors.begin());
  std::copy_n(unknown.begin(), 6, places.begin());
  const auto term = [&](const double* of_load, std::size_t k) {
    return factors[k] * of_load[places[k]];
  };
  const bool shear = 3 * row >= 2 * rows;
  double* entry = stress_.data() + row;
  for (std::size_t c = 0; c < loads; ++c, entry += rows) {
    const double* const u = displacement.data() + c * unknowns;
    // The order of the terms is that of a product by Eigen in two lanes, so that the bytes stay.
    if (shear)
      *entry = (term(u, 0) + (term(u, 1) + term(u, 2))) + (term(u, 3) + (term(u, 4) + term(u, 5)));
    else
      *entry = term(u, 0) + term(u, 1) + term(u, 2) + term(u, 3) + term(u, 4) + term(u, 5);
  }
  entry = stress_.data() + row;
  for (std::size_t c = 0; unknown.size() > 6 && c < loads; ++c, entry += rows)
    for (std::size_t k = 6; k < unknown.size(); ++k)
      *entry += to_stress[k] * displacement[c * unknowns + unknown[k]];
}

}  // namespace riprap

#ifdef RIPRAP_COMPILED
template void riprap::InfluenceOperator::build<void>(const ElementMatrices&, const double*, double,
                                                     bool);
#endif
