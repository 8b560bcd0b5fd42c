// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The stress at every sampling point of one particle.

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include <riprap/core/stress2.hpp>

namespace riprap {

/// Stresses [Pa], compression positive, in the body's own frame: one for each sampling point of
/// each triangle, in the order of SamplingPoints. Component by component, so that sums over loads
/// run through contiguous memory.
class ElementStress {
 public:
  /// All zero, for so many sampling points; keeps its memory.
  void reset(std::size_t points) {
    points_ = static_cast<Eigen::Index>(points);
    values_.resize(3 * points_);
    std::fill_n(values_.data(), values_.size(), 0.0);
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(points_); }
  [[nodiscard]] Stress2 operator[](std::size_t point) const {
    const auto i = static_cast<Eigen::Index>(point);
    return {values_[i], values_[points_ + i], values_[2 * points_ + i]};
  }
  void set(std::size_t point, const Stress2& s) {
    const auto i = static_cast<Eigen::Index>(point);
    values_[i] = s.s11;
    values_[points_ + i] = s.s22;
    values_[2 * points_ + i] = s.s12;
  }

  /// All components: the s11 of every point, then the s22, then the s12.
  [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }
  [[nodiscard]] Eigen::VectorXd& values() { return values_; }

 private:
  Eigen::Index points_ = 0;
  Eigen::VectorXd values_;
};

}  // namespace riprap
