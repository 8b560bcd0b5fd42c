#pragma once
/// @file
/// Boxes around the loads of a particle: while all of them stay inside, it is known to hold.

#include <bit>
#include <cmath>
#include <cstdint>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Numbers that are computed with at once.
using FourFloats = float __attribute__((vector_size(16)));
using FourBits = std::int32_t __attribute__((vector_size(16)));
using TwoFloats = float __attribute__((vector_size(8)));
using TwoDoubles = double __attribute__((vector_size(16)));

/// Where the arm [m] and the force [N] of one contact of a particle may go, in the particle's own
/// frame: x and y of the arm, then of the force. A new one has no inside.
struct alignas(32) LoadBox {
  FourFloats centre{0, 0, 0, 0};
  FourFloats reach{-1, -1, -1, -1};

  /// @param way, along_x, along_y by how much the arm and the components of the force may differ
  /// from those of the centre. The comparison in single precision never takes them for less than
  /// they do.
  [[nodiscard]] static LoadBox around(const Vec2& arm, const Vec2& force, double way,
                                      double along_x, double along_y) {
    // A component is turned by two products of rounded numbers and a sum: four times half a unit in
    // the last place of the whole vector, and one for the centre. Three times that is allowed for.
    constexpr double round_off = 1e-6;
    const auto less = [](double by, double size) {
      return static_cast<float>((1 - 2 * round_off) * by - round_off * size);
    };
    const float each_way = less(0.7071 * way, arm.lpNorm<1>());
    LoadBox box;
    box.centre = FourFloats{static_cast<float>(arm.x()), static_cast<float>(arm.y()),
                            static_cast<float>(force.x()), static_cast<float>(force.y())};
    box.reach = FourFloats{each_way, each_way, less(along_x, force.lpNorm<1>()),
                           less(along_y, force.lpNorm<1>())};
    return box;
  }
};

/// Goes through the contacts of one particle, in any order, and finds whether they are those that
/// have boxes, each inside its own.
class LoadWatch {
 public:
  /// No number of contacts: of a particle that has no boxes.
  static constexpr std::uint32_t none = 0x8000'0000;

  LoadWatch() = default;
  /// @param boxes how many boxes the particle has
  LoadWatch(const Rotation& rotation, std::uint32_t boxes) : missing_(boxes) {
    const auto c = static_cast<float>(rotation.cosine);
    const auto s = static_cast<float>(rotation.sine);
    cosine_ = FourFloats{c, c, c, c};
    sine_ = FourFloats{s, -s, s, -s};
    inside_ = FourBits{-1, -1, -1, -1};
  }

  /// Arm and force in laboratory axes.
  void meet(const LoadBox& box, const Vec2& arm, const Vec2& force) {
    const auto arm_now = __builtin_convertvector(TwoDoubles{arm.x(), arm.y()}, TwoFloats);
    const auto force_now = __builtin_convertvector(TwoDoubles{force.x(), force.y()}, TwoFloats);
    const FourFloats load = __builtin_shufflevector(arm_now, force_now, 0, 1, 2, 3);
    const FourFloats across = __builtin_shufflevector(load, load, 1, 0, 3, 2);
    const FourFloats off = load * cosine_ + across * sine_ - box.centre;
    const FourBits size = std::bit_cast<FourBits>(off) & 0x7FFFFFFF;
    inside_ &= std::bit_cast<FourFloats>(size) <= box.reach;
    --missing_;
  }

  [[nodiscard]] bool holds() const {
    return missing_ == 0 && (inside_[0] & inside_[1] & inside_[2] & inside_[3]) != 0;
  }

 private:
  FourFloats cosine_;
  FourFloats sine_;
  FourBits inside_;
  std::uint32_t missing_;
};

}  // namespace riprap
