// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Dense symmetric systems of equations, and the few sums of vectors that an influence operator
/// takes. Plain functions: those of Eigen take a compiler seconds.

#include <cstddef>
#include <vector>

#include <riprap/core/linkage.hpp>

namespace riprap {

namespace internal {

/// y -= A x, with the columns of A `stride` apart. Every row is summed from left to right (from 128
/// columns on in blocks of 16, beyond a stride of 4000 of 4), whatever the width of a register.
void subtract_product(std::size_t rows, std::size_t columns, const double* a, std::size_t stride,
                      const double* x, double* y);

/// The sum of a[i] b[i], in four interleaved partial sums.
[[nodiscard]] double dot_product(const double* a, const double* b, std::size_t count);

}  // namespace internal

/// P A P' = L D L' of a symmetric matrix, by columns, with the largest diagonal element as pivot.
/// The order of all sums is fixed, and that of Eigen::LDLT for two lanes.
class SymmetricFactors {
 public:
  /// @param matrix by columns; the lower triangle is read
  SymmetricFactors(std::vector<double> matrix, std::size_t size);

  /// Replaces the right-hand side by the solution.
  void solve(double* x) const;

 private:
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return matrix_[column * size_ + row];
  }
  void exchange(std::size_t k, std::size_t pivot);
  void eliminate(std::size_t k, std::vector<double>& work);
  void solve_lower(double* x) const;
  void solve_upper(double* x) const;

  std::size_t size_;
  std::vector<double> matrix_;
  std::vector<std::size_t> pivots_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/symmetric_factors.ipp>
#endif
