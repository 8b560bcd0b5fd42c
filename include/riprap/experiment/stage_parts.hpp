// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Calls of the controls and of the end condition of a stage.

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/experiment/loading_concepts.hpp>
#include <riprap/experiment/path_result.hpp>
#include <riprap/experiment/reachable_end.hpp>
#include <riprap/particle/body.hpp>

namespace riprap::internal {

/// A SimulationError that `work` throws says the stage as well.
template <class Work>
void naming_stage(const std::string& name, Work&& work) {
  try {
    work();
  } catch (const SimulationError& error) {
    throw SimulationError("stage '" + name + "': " + error.what());
  }
}

[[gnu::cold]] void begin_axis(auto& control, const auto& view, int axis) {
  std::visit([&](auto& c) { begin_part(c, view, axis); }, control);
}
[[gnu::cold]] void begin_parts(auto& stage, const auto& view) {
  require_reachable_end(stage, view);
  begin_axis(stage.axis_1, view, 1);
  begin_axis(stage.axis_2, view, 2);
  std::visit([&](auto& c) { begin_part(c, view); }, stage.end);
}

[[nodiscard]] bool ask_variant(auto& end, const auto& view) {
  return std::visit([&](auto& c) -> bool { return ask(c, view); }, end);
}
[[nodiscard]] double share_done_of(const auto& end, const auto& view) {
  return std::visit([&](const auto& c) -> double { return share_done(c, view); }, end);
}

/// Whether a control is given the rate of the other axis.
template <class View>
[[nodiscard]] bool follows(const auto& control) {
  return std::visit(
      [](const auto& c) {
        return !requirements::ControlRate<std::remove_cvref_t<decltype(c)>, View>;
      },
      control);
}

template <class View>
[[nodiscard]] double rate_of(auto& control, const View& view, int axis, double other) {
  return std::visit(
      [&](auto& c) -> double {
        if constexpr (requirements::ControlRate<std::remove_cvref_t<decltype(c)>, View>)
          return c.rate(view, axis);
        else
          return c.rate(view, axis, other);
      },
      control);
}

/// Shortening rates of both axes for the next step [1/s]; an axis that follows comes second.
template <class View>
[[nodiscard]] Vec2 wanted_rates(auto& stage, const View& view) {
  const auto both = [&]() -> Vec2 {
    if (follows<View>(stage.axis_1)) {
      const double second = rate_of(stage.axis_2, view, 2, 0);
      return {rate_of(stage.axis_1, view, 1, second), second};
    }
    const double first = rate_of(stage.axis_1, view, 1, 0);
    return {first, rate_of(stage.axis_2, view, 2, first)};
  };
  Vec2 rates = both();
  require_length_left(stage, view, rates);
  return rates;
}

/// The sample moves as a whole from the first step on.
template <class Sim>
void set_affine_velocities(Sim& sim, const Vec2& rate, const Vec2& centre) {
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    if (const Body& body = sim.particles().body(i); body.is_free())
      sim.set_velocity(i, -componentwise_product(rate, body.position - centre));
}

/// What the servos say of the stage so far; of two, what is worse.
template <class View>
void account(const auto& stage, View& view, StageResult& result) {
  result.steps = view.stage_steps;
  result.saturated_steps = 0;
  result.mean_error = 0;
  result.rms_error = 0;
  result.last_error = 0;
  const auto take_worse = [](double& worst, double error) {
    if (std::abs(error) > std::abs(worst)) worst = error;
  };
  for (const auto* control : {&stage.axis_1, &stage.axis_2})
    std::visit(
        [&](const auto& c) {
          const auto* servo = servo_of(c);
          if (servo == nullptr) return;
          result.saturated_steps += servo->saturated();
          result.rms_error = std::max(result.rms_error, servo->rms_error());
          take_worse(result.mean_error, servo->mean_error());
          take_worse(result.last_error, servo->last_error());
        },
        *control);
  view.mean_confinement_error = result.mean_error;
  view.saturated_share =
      static_cast<double>(result.saturated_steps) / static_cast<double>(result.steps);
}

[[nodiscard]] bool is_axis_held(const auto& control) {
  return std::visit([](const auto& c) { return is_held(c); }, control);
}
[[nodiscard]] bool are_held(const auto& stage) {
  return is_axis_held(stage.axis_1) && is_axis_held(stage.axis_2);
}

}  // namespace riprap::internal
