// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Controls that hold a stress by a servo.

#include <cmath>
#include <cstdint>
#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_rate.hpp>
#include <riprap/experiment/pressure_servo.hpp>

namespace riprap {

/// A servo that keeps account of its errors.
class TrackingServo {
 public:
  template <class View>
  void begin(const View& view, double largest_rate) {
    *this = {};
    servo_ = PressureServo(view.sample_stiffness(), view.servo_response(), std::abs(largest_rate));
  }
  /// Without account: the target may be 0.
  [[nodiscard]] double rate(double stress, double target, double time_step) {
    ++steps_;
    last_error_ = target == 0 ? 0 : stress / target - 1;
    return servo_.rate(target - stress, time_step);
  }
  [[nodiscard]] double tracked_rate(double stress, double target, double time_step) {
    const double error = stress / target - 1;
    error_sum_ += error;
    error_squares_ += error * error;
    last_error_ = error;
    ++steps_;
    return servo_.rate(-error * target, time_step);
  }

  /// Mean and root mean square of stress / target - 1 over the tracked steps.
  [[nodiscard]] double mean_error() const { return over_steps(error_sum_); }
  [[nodiscard]] double rms_error() const { return std::sqrt(over_steps(error_squares_)); }
  /// stress / target - 1 in the last step, tracked or not; 0 where the target is 0.
  [[nodiscard]] double last_error() const { return last_error_; }
  [[nodiscard]] std::uint64_t saturated() const { return servo_.saturated(); }

  static constexpr bool names_all_members = false;
  /// But for the last error, which every step sets anew.
  static void for_each_field(auto& self, auto&& visit) {
    visit("servo", self.servo_);
    visit("error_sum", self.error_sum_);
    visit("error_squares", self.error_squares_);
    visit("steps", self.steps_);
  }

 private:
  [[nodiscard]] double over_steps(double sum) const {
    return steps_ == 0 ? 0 : sum / static_cast<double>(steps_);
  }

  PressureServo servo_{1, 1, 0};
  double error_sum_ = 0;
  double error_squares_ = 0;
  double last_error_ = 0;
  std::uint64_t steps_ = 0;
};

/// What all controls by servo have in common.
struct ServoControl {
  LoadingRate expected_rate{.inertial_number = 1e-3};  ///< of the stage
  double largest_rate = 10;                            ///< of the servo, over the expected rate [-]
  /// Mean relative error above which the stage has missed its target; 0: errors are not judged.
  double tolerance = 0;
  TrackingServo servo{};  ///< state; not to be set

  template <class View>
  void begin(const View& view, int /*axis*/) {
    servo.begin(view, largest_rate * expected_rate.value(view));
  }
  [[nodiscard]] double rate(double stress, double target, double time_step) {
    return tolerance > 0 ? servo.tracked_rate(stress, target, time_step)
                         : servo.rate(stress, target, time_step);
  }
  [[nodiscard]] bool held() const {
    return tolerance == 0 || std::abs(servo.mean_error()) <= tolerance;
  }
  void validate(const std::string& owner) const {
    expected_rate.validate(owner);
    require_positive(owner + ".largest_rate", largest_rate);
    require_non_negative(owner + ".tolerance", tolerance);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    LoadingRate::for_each_parameter(self.expected_rate, visit);
    visit("largest_rate", self.largest_rate);
    visit("tolerance", self.tolerance);
  }
};

/// The normal stress of the axis is driven to a value and held there, at once or along a ramp.
struct ControlledStress {
  static constexpr const char* name = "stress";
  double stress = 0;       ///< [Pa]
  double stress_rate = 0;  ///< of the ramp from the stress at the start [Pa/s]; 0: at once
  ServoControl control{};
  double first = 0;  ///< state: the stress at the start [Pa]

  template <class View>
  void begin(const View& view, int axis) {
    control.begin(view, axis);
    if (stress_rate > 0) first = view.stress(axis);
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int axis) {
    return control.rate(view.stress(axis), target(view), view.sim.time_step());
  }
  void validate(const std::string& owner) const {
    require_finite(owner + ".stress", stress);
    require_non_negative(owner + ".stress_rate", stress_rate);
    require(control.tolerance == 0 || stress != 0, owner + ".stress", stress,
            "must not be 0 where its relative error is judged");
    control.validate(owner);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("stress", self.stress);
    visit("stress_rate", self.stress_rate);
    ServoControl::for_each_parameter(self.control, visit);
  }
  static void for_each_field(auto& self, auto&& visit) {
    visit("servo", self.control.servo);
    visit("first", self.first);
  }

 private:
  template <class View>
  [[nodiscard]] double target(const View& view) const {
    if (stress_rate == 0) return stress;
    const double moved = stress_rate * view.stage_time();
    return std::abs(stress - first) <= moved ? stress
                                             : first + std::copysign(moved, stress - first);
  }
};

/// No traction: the normal stress of the axis is driven to 0. What has no cohesion flows apart.
struct FreeBoundary {
  static constexpr const char* name = "free";
  ServoControl control{};

  template <class View>
  void begin(const View& view, int axis) {
    control.begin(view, axis);
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int axis) {
    return control.rate(view.stress(axis), 0, view.sim.time_step());
  }
  void validate(const std::string& owner) const {
    control.validate(owner);
    require(control.tolerance == 0, owner + ".tolerance", control.tolerance,
            "must be 0: an error relative to no stress has no meaning");
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    ServoControl::for_each_parameter(self.control, visit);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("servo", self.control.servo); }
};

/// The normal stress of the axis is a multiple of that of the other axis.
struct StressRatio {
  static constexpr const char* name = "stress ratio";
  double ratio = 1;  ///< [-]
  ServoControl control{};

  template <class View>
  void begin(const View& view, int axis) {
    control.begin(view, axis);
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int axis) {
    return control.rate(view.stress(axis), ratio * view.stress(3 - axis), view.sim.time_step());
  }
  void validate(const std::string& owner) const {
    require_positive(owner + ".ratio", ratio);
    control.validate(owner);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("ratio", self.ratio);
    ServoControl::for_each_parameter(self.control, visit);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("servo", self.control.servo); }
};

/// The axis keeps the mean of both normal stresses at a value.
struct ConstantMeanStress {
  static constexpr const char* name = "mean stress";
  double stress = 0;  ///< [Pa]
  ServoControl control{};

  template <class View>
  void begin(const View& view, int axis) {
    control.begin(view, axis);
  }
  template <class View>
  [[nodiscard]] double rate(const View& view, int /*axis*/) {
    return control.rate(view.stress().mean(), stress, view.sim.time_step());
  }
  void validate(const std::string& owner) const {
    require_positive(owner + ".stress", stress);
    control.validate(owner);
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("stress", self.stress);
    ServoControl::for_each_parameter(self.control, visit);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("servo", self.control.servo); }
};

}  // namespace riprap
