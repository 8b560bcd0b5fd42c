// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stiffness matrix of a mesh within the band about its diagonal, and its factorisation.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// Nodes are numbered along the particle, so that those of an element have near numbers and the
/// entries lie near the diagonal; zeros outside of this band are neither stored nor computed with.
/// About as many nodes lie across a particle as the root of their number n: factorisation takes
/// n^2 operations and a solution n^1.5, not n^3 and n^2.
class BandedStiffness {
 public:
  /// @param mesh whose elements have so many nodes
  BandedStiffness(const Mesh& mesh, std::size_t nodes_of_element);

  /// Rows, which are those of the right-hand sides: two for each node.
  [[nodiscard]] std::size_t size() const { return first_.size(); }
  /// Row of an axis of a node of the mesh.
  [[nodiscard]] std::size_t row(std::size_t node, std::size_t axis) const {
    return 2 * std::size_t{place_[node]} + axis;
  }
  /// The symmetric matrix is given by its lower triangle: for p < q nothing is added.
  void add(std::size_t p, std::size_t q, double stiffness) {
    if (p >= q) column(q)[p - q] += stiffness;
  }
  /// Holds the particle by three springs: two at the first node, one at the last, across the line
  /// that joins them. Forces in equilibrium put no force on them.
  void hold(const Mesh& mesh);

  /// K = L D L^T, in place.
  void factorise();
  /// Solves in place for `loads` right-hand sides: entry c of row r is at r loads + c. Needs
  /// factorise().
  void solve(std::vector<double>& sides, std::size_t loads) const;

 private:
  [[nodiscard]] double* column(std::size_t j) { return values_.data() + first_[j]; }
  [[nodiscard]] const double* column(std::size_t j) const { return values_.data() + first_[j]; }

  std::vector<std::uint32_t> place_;  // of each node along the particle
  std::vector<std::size_t> first_;    // where the column of each row's diagonal begins
  std::vector<std::size_t> last_;     // last row of each column, never lower than of the one before
  std::vector<double> values_;        // columns from the diagonal down
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/banded_stiffness.ipp>
#endif
