// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Holds a normal stress at a pressure by adjusting a strain rate.

#include <algorithm>
#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Proportional and integral control of a strain rate [1/s], positive in shortening. The sample is
/// taken as a spring of `stiffness` [Pa]; the loop is critically damped for it, with both poles at
/// -1 / (2 response). A purely proportional servo drifts as the sample deforms.
class PressureServo {
 public:
  PressureServo(double stiffness, double response, double largest_rate)
      : gain_(1 / (stiffness * response)), integral_gain_(gain_ / (4 * response)),
        largest_rate_(largest_rate) {}

  /// @param shortfall wanted minus present stress [Pa]
  [[nodiscard]] double rate(double shortfall, double time_step) {
    const double integral = integral_ + integral_gain_ * shortfall * time_step;
    const double wanted = gain_ * shortfall + integral;
    const double rate = std::clamp(wanted, -largest_rate_, largest_rate_);
    // No winding up while the rate is at its limit.
    if (rate == wanted)
      integral_ = integral;
    else
      ++saturated_;
    return rate;
  }

  /// Calls in which the rate was held at its limit.
  [[nodiscard]] std::uint64_t saturated() const { return saturated_; }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("gain", self.gain_);
    visit("integral_gain", self.integral_gain_);
    visit("largest_rate", self.largest_rate_);
    visit("integral", self.integral_);
    visit("saturated", self.saturated_);
  }

 private:
  double gain_;
  double integral_gain_;
  double largest_rate_;
  double integral_ = 0;
  std::uint64_t saturated_ = 0;
};

}  // namespace riprap
