// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// An axis of a chart: where it ends, and the round numbers that it shows.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

#include <riprap/core/errors.hpp>

namespace riprap {

enum class AxisScale { linear, logarithmic };

/// A number on an axis.
struct AxisTick {
  double value = 0;
  std::string label;
};

/// Ends on the ticks next to the data.
class ChartAxis {
 public:
  /// Whether a value has a place on such an axis: up to 1e300 in size, on a logarithmic one 1e-300
  /// or above.
  [[nodiscard]] static bool has_place(AxisScale scale, double value) {
    return std::abs(value) <= largest && (scale == AxisScale::linear || value >= 1 / largest);
  }

  /// Ticks are 1, 2 or 5 times a power of ten apart. Without data, or with a single value, the axis
  /// is of unit length, or where the value is so large that a unit is nothing, half as long as that
  /// on either side. Ends that have no place count as no data.
  [[nodiscard]] static ChartAxis linear(double low, double high) {
    if (!has_place(AxisScale::linear, low) || !has_place(AxisScale::linear, high)) {
      low = 0;
      high = 1;
    }
    const double size = std::max(std::abs(low), std::abs(high));
    if (!(high - low > std::max(1 / largest, 1e-15 * size))) {
      const double half = 0.5 > 1e-9 * size ? 0.5 : 0.5 * size;
      low -= half;
      high = low + 2 * half;
    }
    const double raw = (high - low) / 5;
    const double decade = std::pow(10, std::floor(std::log10(raw)));
    // Round-off does not ask for coarser ticks, nor a hair beyond a tick for another one.
    double tick = 10 * decade;
    for (const double step : {5.0, 2.0, 1.0})
      if (step * decade >= raw * (1 - 1e-9)) tick = step * decade;
    ChartAxis axis;
    axis.low_ = tick * std::floor(low / tick + 0.02);
    axis.high_ = tick * std::ceil(high / tick - 0.02);
    axis.small_ = 0.01 * tick;
    for (int k = 0; axis.low_ + k * tick <= axis.high_ + axis.small_; ++k) {
      const double v = axis.low_ + k * tick;
      axis.ticks_.push_back({v, fixed_text(v, tick)});
    }
    return axis;
  }

  /// Ticks are 1, 2 and 5 times the powers of ten, or over more than four decades these powers
  /// alone. Without data the axis is the decade from 1 to 10.
  /// Throws InvalidInput unless all data have a place on it.
  [[nodiscard]] static ChartAxis logarithmic(double low, double high) {
    if (!(low <= high)) {
      low = 1;
      high = 10;
    }
    require(low > 0, "value on a logarithmic axis", low, "must lie above 0");
    for (const double end : {low, high})
      require(has_place(AxisScale::logarithmic, end), "value on a logarithmic axis", end,
              "must lie between 1e-300 and 1e300");
    if (low == high) {
      low /= 2;
      high *= 2;
    }
    const bool powers_only = high / low > 1e4;
    constexpr double hair = 1 + 1e-9;
    ChartAxis axis;
    axis.scale_ = AxisScale::logarithmic;
    for (int power = static_cast<int>(std::floor(std::log10(low))) - 1;; ++power) {
      for (const double step : {1.0, 2.0, 5.0}) {
        if (powers_only && step > 1) break;
        const double v = power < 0 ? step / std::pow(10, -power) : step * std::pow(10, power);
        if (v <= low * hair) axis.ticks_.clear();
        axis.ticks_.push_back({v, plain_text(v)});
        if (v * hair >= high) {
          axis.low_ = axis.ticks_.front().value;
          axis.high_ = v;
          return axis;
        }
      }
    }
  }

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] const std::vector<AxisTick>& ticks() const { return ticks_; }

  /// How far along the axis a value lies: 0 at its lower end, 1 at the upper one.
  [[nodiscard]] double share(double value) const {
    if (scale_ == AxisScale::linear) return (value - low_) / (high_ - low_);
    return std::log(value / low_) / std::log(high_ / low_);
  }
  [[nodiscard]] bool is_zero(const AxisTick& tick) const { return std::abs(tick.value) < small_; }

 private:
  static constexpr double largest = 1e300;
  static constexpr std::size_t longest_label = 16;  // characters

  // As many decimals as the tick needs.
  [[nodiscard]] static std::string fixed_text(double value, double tick) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(tick) - 1e-9)));
    if (std::abs(value) < 1e-6 * tick) value = 0;
    char buffer[longest_label];
    const auto end =
        std::to_chars(buffer, buffer + longest_label, value, std::chars_format::fixed, decimals);
    return end.ec == std::errc() ? std::string(buffer, end.ptr) : short_text(value);
  }

  // The shortest decimals that read back as the value.
  [[nodiscard]] static std::string plain_text(double value) {
    char buffer[longest_label];
    const auto end = std::to_chars(buffer, buffer + longest_label, value, std::chars_format::fixed);
    return end.ec == std::errc() ? std::string(buffer, end.ptr) : short_text(value);
  }

  // Six digits and an exponent, for numbers that would be long.
  [[nodiscard]] static std::string short_text(double value) {
    char buffer[longest_label];
    const auto end =
        std::to_chars(buffer, buffer + longest_label, value, std::chars_format::general, 6);
    return {buffer, end.ptr};
  }

  AxisScale scale_ = AxisScale::linear;
  double low_ = 0;
  double high_ = 1;
  double small_ = 0;
  std::vector<AxisTick> ticks_;
};

}  // namespace riprap
