// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stages whose constant rates of strain never come to the strain that ends them.

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/experiment/crossing_condition.hpp>
#include <riprap/experiment/end_combination.hpp>

namespace riprap::internal {

/// Of axes 1 and 2 [1/s]; not-a-number where it is not constant in the stage.
using ConstantRates = std::array<double, 2>;

[[nodiscard]] double constant_rate_of(const auto& control, const auto& view) {
  return std::visit(
      [&](const auto& c) -> double {
        if constexpr (requires { c.constant_rate(view); })
          return c.constant_rate(view);
        else
          return std::numeric_limits<double>::quiet_NaN();
      },
      control);
}

/// The strain of an axis because of which an end condition is never reached; null where it may be.
[[nodiscard]] const StrainReached* unreachable_part(const auto& /*end*/, const ConstantRates&,
                                                    const auto& /*view*/) {
  return nullptr;
}
[[nodiscard]] const StrainReached* unreachable_part(const StrainReached& end,
                                                    const ConstantRates& rates, const auto& view) {
  if (end.of == StrainOf::volume) return nullptr;
  const int axis = end.of == StrainOf::axis_1 ? 1 : 2;
  const double way = end.strain - view.strain(axis);
  return way != 0 && rates[static_cast<std::size_t>(axis - 1)] * way <= 0 ? &end : nullptr;
}
template <class One>
[[nodiscard]] const StrainReached* unreachable_part(const AnyOf<One>& end,
                                                    const ConstantRates& rates, const auto& view) {
  const StrainReached* found = nullptr;
  for (const One& part : end.parts) {
    found = std::visit(
        [&](const auto& condition) { return unreachable_part(condition, rates, view); }, part);
    if (found == nullptr) return nullptr;
  }
  return found;
}
template <class One>
[[nodiscard]] const StrainReached* unreachable_part(const AllOf<One>& end,
                                                    const ConstantRates& rates, const auto& view) {
  for (const One& part : end.parts)
    if (const StrainReached* const found = std::visit(
            [&](const auto& condition) { return unreachable_part(condition, rates, view); }, part))
      return found;
  return nullptr;
}

/// Throws InvalidInput where the stage would never end: the rate of an axis is 0 or leads away from
/// the strain that ends the stage. A stage with `most_steps` of its own, after which the path goes
/// on, ends by them.
[[gnu::cold]] void require_reachable_end(const auto& stage, const auto& view) {
  using Stage = std::remove_cvref_t<decltype(stage)>;
  const Stage given{};
  if (stage.at_cap == given.at_cap && stage.most_steps != given.most_steps) return;
  const ConstantRates rates{constant_rate_of(stage.axis_1, view),
                            constant_rate_of(stage.axis_2, view)};
  const StrainReached* const end = std::visit(
      [&](const auto& condition) { return unreachable_part(condition, rates, view); }, stage.end);
  if (end == nullptr) return;
  const int axis = end->of == StrainOf::axis_1 ? 1 : 2;
  require(false, "stage '" + stage.name + "': rate of strain of axis_" + std::to_string(axis),
          rates[static_cast<std::size_t>(axis - 1)],
          "must lead from the strain " + to_text(view.strain(axis)) + " to " +
              to_text(end->strain) + ", which ends the stage");
}

/// Throws SimulationError where a step at these rates would leave an axis without length.
void require_length_left(const auto& stage, const auto& view, const Vec2& rates) {
  const double step = view.sim.time_step();
  for (const int axis : {1, 2})
    if (!(step * rates[axis - 1] < 1)) [[unlikely]]
      throw SimulationError("stage '" + stage.name + "': axis_" + std::to_string(axis) +
                            " has no length left at strain " + to_text(view.strain(axis)) +
                            ": its rate is " + to_text(rates[axis - 1]) + " 1/s, the time step " +
                            to_text(step) + " s");
}

}  // namespace riprap::internal
