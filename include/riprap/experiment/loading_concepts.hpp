// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What the controls and the end conditions of a loading path must have, and how they are called.

#include <concepts>
#include <cstdint>
#include <string>

#include <riprap/experiment/stress_control.hpp>

namespace riprap {

namespace requirements {

/// `control.rate(view, axis)`: shortening rate of axis 1 or 2 [1/s] for the next step, called once
/// a step. It need not be const: a control may keep a servo's state.
template <class C, class View>
concept ControlRate = requires(C& control, const View& view, const int axis) {
  { control.rate(view, axis) } -> std::convertible_to<double>;
};

/// Or `control.rate(view, axis, other)`, which is given the rate of the other axis [1/s].
template <class C, class View>
concept FollowingRate = requires(C& control, const View& view, const int axis, const double other) {
  { control.rate(view, axis, other) } -> std::convertible_to<double>;
};

/// `condition.reached(view)`, or a call of the condition itself, after every step.
template <class E, class View>
concept EndReached = requires(E& condition, const View& view) {
  { condition.reached(view) } -> std::convertible_to<bool>;
} || requires(E& condition, const View& view) {
  { condition(view) } -> std::convertible_to<bool>;
};

}  // namespace requirements

/// Drives one axis of the sample. Optional: `begin(view, axis)`, at the start of the stage;
/// `held()`, whether the stage may count as having reached its target; `servo` or `control.servo`,
/// a TrackingServo; `constant_rate(view)`, its rate of strain [1/s] but for a ramp at the start,
/// whose sign is then that of the whole stage; `validate(owner)`.
template <class C, class View>
concept ControlsAxis = std::copyable<C> &&
                       (requirements::ControlRate<C, View> || requirements::FollowingRate<C, View>);

/// Ends a stage. Optional: `begin(view)`, at the start of the stage; `done(view)`, the share of the
/// stage that is done; `validate(owner)`.
template <class E, class View>
concept EndsStage = std::copy_constructible<E> && requirements::EndReached<E, View>;

template <class C, class View>
consteval bool check_control() {
  static_assert(ControlsAxis<C, View>,
                "riprap: the control of an axis must be copyable and have double rate(const auto& "
                "view, int axis), or the same with a third argument double other "
                "(docs/paths.md)");
  return ControlsAxis<C, View>;
}

template <class E, class View>
consteval bool check_end() {
  static_assert(EndsStage<E, View>,
                "riprap: an end condition must be copyable and have bool reached(const auto& "
                "view), or be called so itself (docs/paths.md)");
  return EndsStage<E, View>;
}

namespace internal {

template <class View>
[[nodiscard]] bool ask(auto& condition, const View& view) {
  if constexpr (requires { condition.reached(view); })
    return condition.reached(view);
  else
    return condition(view);
}

void begin_part(auto& part, const auto&... of) {
  if constexpr (requires { part.begin(of...); }) part.begin(of...);
}

void validate_part(const auto& part, const std::string& owner) {
  if constexpr (requires { part.validate(owner); }) part.validate(owner);
}

[[nodiscard]] double share_done(const auto& condition, const auto& view) {
  if constexpr (requires { condition.done(view); })
    return condition.done(view);
  else
    return 0;
}

/// The servo of a control, or null.
[[nodiscard]] auto* servo_of(const auto& control) {
  if constexpr (requires { control.control.servo.saturated(); })
    return &control.control.servo;
  else if constexpr (requires { control.servo.saturated(); })
    return &control.servo;
  else
    return static_cast<const TrackingServo*>(nullptr);
}

[[nodiscard]] bool is_held(const auto& control) {
  if constexpr (requires { control.control.held(); })
    return control.control.held();
  else if constexpr (requires { control.held(); })
    return control.held();
  else
    return true;
}

}  // namespace internal
}  // namespace riprap
