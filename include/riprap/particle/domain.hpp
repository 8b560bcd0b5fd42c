// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The domain of the simulation: unbounded, or a periodic cell.

#include <cmath>
#include <compare>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// The whole plane; no images.
struct UnboundedDomain {
  static constexpr bool periodic = false;
  struct Image {
    friend constexpr auto operator<=>(const Image&, const Image&) = default;
  };
};

/// A rectangular cell, periodic along axes 1 and 2, that deforms at a given rate.
struct PeriodicDomain {
  static constexpr bool periodic = true;

  /// Which copy of a body: whole periods along the axes.
  struct Image {
    int axis_1 = 0;
    int axis_2 = 0;
    friend constexpr auto operator<=>(const Image&, const Image&) = default;
    friend constexpr Image operator-(const Image& i) { return {-i.axis_1, -i.axis_2}; }
    friend constexpr Image operator+(const Image& i, const Image& j) {
      return {i.axis_1 + j.axis_1, i.axis_2 + j.axis_2};
    }

    static void for_each_field(auto& self, auto&& visit) {
      visit("axis_1", self.axis_1);
      visit("axis_2", self.axis_2);
    }
  };

  Vec2 period{0, 0};  ///< extents of the cell [m]
  Vec2 rate{0, 0};    ///< of shortening [1/s]
  Vec2 centre{0, 0};  ///< of the cell, where it stays when it shrinks [m]

  /// From a body to its image [m].
  [[nodiscard]] Vec2 offset(const Image& image) const {
    return {image.axis_1 * period.x(), image.axis_2 * period.y()};
  }
  /// Of the image relative to its body [m/s].
  [[nodiscard]] Vec2 velocity(const Image& image) const {
    return -componentwise_product(rate, offset(image));
  }
  /// The copy of the cell that holds x.
  [[nodiscard]] Image cell_of(const Vec2& x) const {
    return {static_cast<int>(std::lround((x.x() - centre.x()) / period.x())),
            static_cast<int>(std::lround((x.y() - centre.y()) / period.y()))};
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("period", self.period);
    visit("rate", self.rate);
    visit("centre", self.centre);
  }
};

}  // namespace riprap
