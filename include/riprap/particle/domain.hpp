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

/// A cell that repeats itself along two edges: (period.x(), 0) along axis 1 and (shear_offset,
/// period.y()) across axis 2, a rectangle where the offset is zero. It deforms at a homogeneous
/// velocity gradient: shortening along both axes and simple shear, by which what lies x_2 above the
/// centre moves along axis 1 at shear_rate x_2 (Lees and Edwards 1972).
struct PeriodicDomain {
  static constexpr bool periodic = true;

  /// Which copy of a body: whole edges of the cell.
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

  Vec2 period{0, 0};        ///< extents of the cell [m]
  Vec2 rate{0, 0};          ///< of shortening [1/s]
  Vec2 centre{0, 0};        ///< of the cell, where it stays when it is strained [m]
  double shear_offset = 0;  ///< along axis 1, of the image one period up axis 2 [m]; has no limit
  double shear_rate = 0;    ///< dv_1/dx_2 [1/s]

  /// From a body to its image [m].
  [[nodiscard]] Vec2 offset(const Image& image) const {
    return {image.axis_1 * period.x() + image.axis_2 * shear_offset, image.axis_2 * period.y()};
  }
  /// Velocity at x from the centre of what moves with the cell [m/s].
  [[nodiscard]] Vec2 field(const Vec2& x) const {
    return Vec2{shear_rate * x.y(), 0} - componentwise_product(rate, x);
  }
  /// Of the image relative to its body [m/s].
  [[nodiscard]] Vec2 velocity(const Image& image) const { return field(offset(image)); }
  /// The cell after a time step [s] at the rates that are set.
  void drift(double time_step) {
    const Vec2 up = field({shear_offset, period.y()});
    period -= time_step * componentwise_product(rate, period);
    shear_offset += time_step * up.x();
  }
  /// The copy of the cell that holds x. Copies are taken as upright rectangles, in rows that are
  /// shifted against each other.
  [[nodiscard]] Image cell_of(const Vec2& x) const {
    const long row = std::lround((x.y() - centre.y()) / period.y());
    const double in_row = x.x() - centre.x() - static_cast<double>(row) * shear_offset;
    return {static_cast<int>(std::lround(in_row / period.x())), static_cast<int>(row)};
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("period", self.period);
    visit("rate", self.rate);
    visit("centre", self.centre);
    visit("shear_offset", self.shear_offset);
    visit("shear_rate", self.shear_rate);
  }
};

}  // namespace riprap
