// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Linear bound on the change of a particle's stresses, accumulated contact by contact.

#include <cstdint>
#include <limits>

#include <riprap/acceleration/screening/axis_form.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Arm [m] and force [N] of one contact of a particle, in the particle's own frame, and weights:
/// the part of a budget of one that a unit change of each component uses up. Default: NaN weights,
/// so that every comparison fails. Single precision.
struct alignas(32) LoadSensitivity {
  static constexpr float none = std::numeric_limits<float>::quiet_NaN();

  FourFloats load{0, 0, 0, 0};  ///< x and y of the arm, x and y of the force
  FourFloats weights{none, none, none, none};

  LoadSensitivity() = default;
  LoadSensitivity(const FourFloats& arm_and_force, const FourFloats& each)
      : load{arm_and_force}, weights{each} {}

  /// Arm and force in the layout of `load`.
  [[nodiscard]] static FourFloats single(const Vec2& arm, const Vec2& force) {
    const Simd<double, 4> exact{arm.x(), arm.y(), force.x(), force.y()};
    return __builtin_convertvector(exact, FourFloats);
  }

  /// Bound on the round-off of IncrementalBound. Rotating a component takes two products of rounded
  /// numbers and a sum: an error of five unit round-offs of the vector; three times that is
  /// assumed. The caller accounts for the relative error of the changes themselves, 1e-6.
  [[nodiscard]] float round_off() const {
    const FourFloats size = magnitude(load);
    const FourFloats both = size + __builtin_shufflevector(size, size, 1, 0, 3, 2);
    const FourFloats off = weights * both;
    return 1e-6f * ((off[0] + off[1]) + (off[2] + off[3]));
  }

  /// The same for the opposite force.
  [[nodiscard]] LoadSensitivity opposite() const {
    LoadSensitivity other = *this;
    other.load = FourFloats{load[0], load[1], -load[2], -load[3]};
    return other;
  }
};

/// Accumulates the weighted changes of the contacts of one particle, in any order. Within the
/// budget if they are the contacts with weights, and their changes sum up to less than one.
class IncrementalBound {
 public:
  /// Number of contacts of a particle without weights.
  static constexpr std::uint32_t untracked = 0x8000'0000;

  IncrementalBound() = default;
  /// @param contacts number of contacts with weights
  IncrementalBound(const Rotation& rotation, std::uint32_t contacts) : missing_(contacts) {
    const auto c = static_cast<float>(rotation.cosine);
    const auto s = static_cast<float>(rotation.sine);
    cosine_ = FourFloats{c, c, c, c};
    sine_ = FourFloats{s, -s, s, -s};
    spent_ = FourFloats{0, 0, 0, 0};
  }

  /// Arm and force in laboratory axes.
  void accumulate(const LoadSensitivity& known, const Vec2& arm, const Vec2& force) {
    const FourFloats load = LoadSensitivity::single(arm, force);
    const FourFloats across = __builtin_shufflevector(load, load, 1, 0, 3, 2);
    const FourFloats change = load * cosine_ + across * sine_ - known.load;
    spent_ += magnitude(change) * known.weights;
    --missing_;
  }

  [[nodiscard]] bool within_budget() const {
    const FourFloats other = __builtin_shufflevector(spent_, spent_, 2, 3, 0, 1);
    const FourFloats two = spent_ + other;
    return missing_ == 0 && two[0] + two[1] <= 1;
  }

 private:
  FourFloats cosine_;
  FourFloats sine_;
  FourFloats spent_;
  std::uint32_t missing_;
};

}  // namespace riprap
