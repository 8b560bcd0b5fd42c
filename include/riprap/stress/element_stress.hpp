// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The stress in every triangle of one particle.

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include <riprap/core/stress2.hpp>

namespace riprap {

/// Stresses [Pa], compression positive, in the body's own frame; component by component, so that
/// sums over loads run through contiguous memory.
class ElementStress {
 public:
  /// All zero, for `elements` triangles; keeps its memory.
  void reset(std::size_t elements) {
    elements_ = static_cast<Eigen::Index>(elements);
    values_.resize(3 * elements_);
    std::fill_n(values_.data(), values_.size(), 0.0);
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(elements_); }
  [[nodiscard]] Stress2 operator[](std::size_t e) const {
    const auto i = static_cast<Eigen::Index>(e);
    return {values_[i], values_[elements_ + i], values_[2 * elements_ + i]};
  }
  void set(std::size_t e, const Stress2& s) {
    const auto i = static_cast<Eigen::Index>(e);
    values_[i] = s.s11;
    values_[elements_ + i] = s.s22;
    values_[2 * elements_ + i] = s.s12;
  }

  /// All components: the s11 of every element, then the s22, then the s12.
  [[nodiscard]] const Eigen::VectorXd& values() const { return values_; }
  [[nodiscard]] Eigen::VectorXd& values() { return values_; }

 private:
  Eigen::Index elements_ = 0;
  Eigen::VectorXd values_;
};

}  // namespace riprap
