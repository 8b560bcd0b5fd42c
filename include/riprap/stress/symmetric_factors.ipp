// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <riprap/core/lanes.hpp>
#include <riprap/stress/symmetric_factors.hpp>

namespace riprap {

namespace internal {

[[gnu::always_inline]] inline void subtract_lanes(double* from, const DoubleLanes& lanes) {
  store_lanes(from, load_lanes<DoubleLanes>(from) - lanes);
}

// The same for one block of columns.
RIPRAP_INLINE void subtract_columns(std::size_t rows, std::size_t columns, const double* a,
                                    std::size_t stride, const double* x, double* y) {
  std::size_t i = 0;
  for (; i + 4 * double_lanes <= rows; i += 4 * double_lanes) {
    DoubleLanes s0{};
    DoubleLanes s1{};
    DoubleLanes s2{};
    DoubleLanes s3{};
    const double* column = a + i;
    for (std::size_t j = 0; j < columns; ++j, column += stride) {
      s0 += load_lanes<DoubleLanes>(column) * x[j];
      s1 += load_lanes<DoubleLanes>(column + double_lanes) * x[j];
      s2 += load_lanes<DoubleLanes>(column + 2 * double_lanes) * x[j];
      s3 += load_lanes<DoubleLanes>(column + 3 * double_lanes) * x[j];
    }
    subtract_lanes(y + i, s0);
    subtract_lanes(y + i + double_lanes, s1);
    subtract_lanes(y + i + 2 * double_lanes, s2);
    subtract_lanes(y + i + 3 * double_lanes, s3);
  }
  for (; i + double_lanes <= rows; i += double_lanes) {
    DoubleLanes s{};
    for (std::size_t j = 0; j < columns; ++j)
      s += load_lanes<DoubleLanes>(a + i + j * stride) * x[j];
    subtract_lanes(y + i, s);
  }
  for (; i < rows; ++i) {
    double s = 0;
    for (std::size_t j = 0; j < columns; ++j) s += a[i + j * stride] * x[j];
    y[i] -= s;
  }
}

RIPRAP_INLINE void subtract_product(std::size_t rows, std::size_t columns, const double* a,
                                    std::size_t stride, const double* x, double* y) {
  const std::size_t block = columns < 128 ? columns : stride < 4000 ? 16 : 4;
  for (std::size_t j = 0; j < columns; j += block)
    subtract_columns(rows, std::min(block, columns - j), a + j * stride, stride, x + j, y);
}

RIPRAP_INLINE double dot_product(const double* a, const double* b, std::size_t count) {
  const auto pair = [&](std::size_t i) {
    return load_lanes<TwoDoubles>(a + i) * load_lanes<TwoDoubles>(b + i);
  };
  if (count == 0) return 0;
  if (count == 1) return a[0] * b[0];
  const std::size_t pairs = count / 2 * 2;
  const std::size_t fours = count / 4 * 4;
  TwoDoubles even = pair(0);
  if (pairs > 2) {
    TwoDoubles odd = pair(2);
    for (std::size_t i = 4; i < fours; i += 4) {
      even += pair(i);
      odd += pair(i + 2);
    }
    even += odd;
    if (pairs > fours) even += pair(fours);
  }
  double sum = even[0] + even[1];
  for (std::size_t i = pairs; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

// From each y the sum of the products of x and a row, which are `stride` apart; every sum in two
// interleaved partial sums. Four rows at once, which do not wait for each other.
template <std::size_t rows>
[[gnu::always_inline]] inline void subtract_row_sums(std::size_t count, const double* a,
                                                     std::size_t stride, const double* x,
                                                     double* y) {
  static_assert(rows == 1 || rows == 4);
  const auto times = [&](std::size_t row, std::size_t i, const TwoDoubles& two) {
    return load_lanes<TwoDoubles>(a + row * stride + i) * two;
  };
  TwoDoubles s0{};
  TwoDoubles s1{};
  TwoDoubles s2{};
  TwoDoubles s3{};
  const std::size_t pairs = count / 2 * 2;
  for (std::size_t i = 0; i < pairs; i += 2) {
    const auto two = load_lanes<TwoDoubles>(x + i);
    s0 += times(0, i, two);
    if constexpr (rows == 4) {
      s1 += times(1, i, two);
      s2 += times(2, i, two);
      s3 += times(3, i, two);
    }
  }
  const TwoDoubles* const sums[]{&s0, &s1, &s2, &s3};
  for (std::size_t row = 0; row < rows; ++row) {
    double sum = (*sums[row])[0] + (*sums[row])[1];
    for (std::size_t i = pairs; i < count; ++i) sum += a[row * stride + i] * x[i];
    y[row] -= sum;
  }
}

inline constexpr std::size_t panel = 8;  // columns that are solved together

}  // namespace internal

RIPRAP_INLINE SymmetricFactors::SymmetricFactors(std::vector<double> matrix, std::size_t size)
    : size_(size), matrix_(std::move(matrix)), pivots_(size) {
  std::vector<double> work(size);
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    double largest = std::abs(at(k, k));
    for (std::size_t i = k + 1; i < size; ++i) {
      const double candidate = std::abs(at(i, i));
      if (!(candidate > largest)) continue;
      largest = candidate;
      pivot = i;
    }
    pivots_[k] = pivot;
    if (pivot != k) exchange(k, pivot);
    eliminate(k, work);
  }
}

// Rows and columns k and pivot, in the lower triangle.
RIPRAP_INLINE void SymmetricFactors::exchange(std::size_t k, std::size_t pivot) {
  for (std::size_t j = 0; j < k; ++j) std::swap(at(k, j), at(pivot, j));
  for (std::size_t i = pivot + 1; i < size_; ++i) std::swap(at(i, k), at(i, pivot));
  std::swap(at(k, k), at(pivot, pivot));
  for (std::size_t i = k + 1; i < pivot; ++i) std::swap(at(i, k), at(pivot, i));
}

// Column k of L and element k of D from the columns before.
RIPRAP_INLINE void SymmetricFactors::eliminate(std::size_t k, std::vector<double>& work) {
  const std::size_t below = size_ - k - 1;
  if (k > 0) {
    const double* const weights = work.data();
    for (std::size_t j = 0; j < k; ++j) work[j] = at(j, j) * at(k, j);
    const auto row = [&](std::size_t i) {
      const double* element = &at(i, 0);
      double sum = *element * weights[0];
      for (std::size_t j = 1; j < k; ++j) sum += *(element += size_) * weights[j];
      return sum;
    };
    at(k, k) -= row(k);
    if (below == 1)
      at(k + 1, k) -= row(k + 1);
    else if (below > 1)
      internal::subtract_product(below, k, &at(k + 1, 0), size_, work.data(), &at(k + 1, k));
  }
  const double diagonal = at(k, k);
  if (!(std::abs(diagonal) > 0)) return;
  double* const column = &at(k, k) + 1;
  std::size_t i = 0;
  for (; i + internal::double_lanes <= below; i += internal::double_lanes) {
    internal::store_lanes(column + i,
                          internal::load_lanes<internal::DoubleLanes>(column + i) / diagonal);
  }
  for (; i < below; ++i) column[i] /= diagonal;
}

RIPRAP_INLINE void SymmetricFactors::solve(double* x) const {
  for (std::size_t k = 0; k < size_; ++k) std::swap(x[k], x[pivots_[k]]);
  solve_lower(x);
  for (std::size_t k = 0; k < size_; ++k) {
    const double diagonal = matrix_[k * size_ + k];
    x[k] = std::abs(diagonal) > std::numeric_limits<double>::min() ? x[k] / diagonal : 0;
  }
  solve_upper(x);
  for (std::size_t k = size_; k-- > 0;) std::swap(x[k], x[pivots_[k]]);
}

RIPRAP_INLINE void SymmetricFactors::solve_lower(double* x) const {
  for (std::size_t first = 0; first < size_; first += internal::panel) {
    const std::size_t end = std::min(first + internal::panel, size_);
    for (std::size_t k = first; k < end; ++k)
      if (x[k] != 0)
        for (std::size_t i = k + 1; i < end; ++i) x[i] -= x[k] * matrix_[k * size_ + i];
    internal::subtract_product(size_ - end, end - first, matrix_.data() + first * size_ + end,
                               size_, x + first, x + end);
  }
}

RIPRAP_INLINE void SymmetricFactors::solve_upper(double* x) const {
  for (std::size_t end = size_; end > 0;) {
    const std::size_t first = end - std::min(end, internal::panel);
    const std::size_t beyond = size_ - end;
    const double* const rows = matrix_.data() + end;
    if (beyond > 0) {
      std::size_t i = first;
      for (; i + 4 <= end; i += 4)
        internal::subtract_row_sums<4>(beyond, rows + i * size_, size_, x + end, x + i);
      for (; i < end; ++i)
        internal::subtract_row_sums<1>(beyond, rows + i * size_, size_, x + end, x + i);
    }
    for (std::size_t i = end - 1; i-- > first;)
      x[i] -= internal::dot_product(matrix_.data() + i * size_ + i + 1, x + i + 1, end - 1 - i);
    end = first;
  }
}

}  // namespace riprap
