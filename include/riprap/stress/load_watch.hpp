// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a particle's loads may do before it has to be looked at again, contact by contact.

#include <bit>
#include <cstdint>
#include <limits>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Numbers that are computed with at once.
using FourFloats = float __attribute__((vector_size(16)));
using FourBits = std::int32_t __attribute__((vector_size(16)));
using FourDoubles = double __attribute__((vector_size(32)));

/// Arm [m] and force [N] of one contact of a particle, in the particle's own frame, and what a unit
/// of change in each of their components takes from a budget of one. A new one has no price: any
/// change is too dear, and none as well. Single precision.
struct alignas(32) LoadPrice {
  static constexpr float none = std::numeric_limits<float>::quiet_NaN();

  FourFloats load{0, 0, 0, 0};  ///< x and y of the arm, x and y of the force
  FourFloats price{none, none, none, none};

  LoadPrice() = default;
  LoadPrice(const FourFloats& arm_and_force, const FourFloats& each)
      : load{arm_and_force}, price{each} {}

  /// Arm and force as `load` has them.
  [[nodiscard]] static FourFloats single(const Vec2& arm, const Vec2& force) {
    const FourDoubles exact{arm.x(), arm.y(), force.x(), force.y()};
    return __builtin_convertvector(exact, FourFloats);
  }

  /// What LoadWatch may come out short by, for round-off. A component is turned by two products of
  /// rounded numbers and a sum: off by five unit round-offs of the whole vector; three times that
  /// is allowed for. That of changes themselves, 1e-6 of them, is left to the caller.
  [[nodiscard]] float round_off() const {
    const FourFloats size = magnitude(load);
    const FourFloats both = size + __builtin_shufflevector(size, size, 1, 0, 3, 2);
    const FourFloats off = price * both;
    return 1e-6f * ((off[0] + off[1]) + (off[2] + off[3]));
  }

  /// The same for the opposite force.
  [[nodiscard]] LoadPrice opposite() const {
    LoadPrice other = *this;
    other.load = FourFloats{load[0], load[1], -load[2], -load[3]};
    return other;
  }

  [[nodiscard]] static FourFloats magnitude(const FourFloats& x) {
    return std::bit_cast<FourFloats>(std::bit_cast<FourBits>(x) & 0x7FFFFFFF);
  }
};

/// Goes through the contacts of one particle, in any order, and finds whether they are those that
/// have a price, and have changed by less than the budget.
class LoadWatch {
 public:
  /// No number of contacts: of a particle that is not watched.
  static constexpr std::uint32_t none = 0x8000'0000;

  LoadWatch() = default;
  /// @param contacts that have a price
  LoadWatch(const Rotation& rotation, std::uint32_t contacts) : missing_(contacts) {
    const auto c = static_cast<float>(rotation.cosine);
    const auto s = static_cast<float>(rotation.sine);
    cosine_ = FourFloats{c, c, c, c};
    sine_ = FourFloats{s, -s, s, -s};
    spent_ = FourFloats{0, 0, 0, 0};
  }

  /// Arm and force in laboratory axes.
  void meet(const LoadPrice& known, const Vec2& arm, const Vec2& force) {
    const FourFloats load = LoadPrice::single(arm, force);
    const FourFloats across = __builtin_shufflevector(load, load, 1, 0, 3, 2);
    const FourFloats change = load * cosine_ + across * sine_ - known.load;
    spent_ += LoadPrice::magnitude(change) * known.price;
    --missing_;
  }

  [[nodiscard]] bool holds() const {
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
