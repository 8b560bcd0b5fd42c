#pragma once
/// @file
/// The role of the time-step rule.

#include <concepts>

namespace riprap {

/// A `TimeStepRule` chooses the time step and how light a body may be in the equations of motion.
///
/// - `rule.time_step(mass, stiffness)` [s]: from the smallest intact particle's mass [kg] and the
///   contact law's peak stiffness [N/m].
/// - `rule.mass_scaling(mass, smallest)` [-], >= 1: factor on mass and inertia, in the equations of
///   motion only, of a body of `mass` where `smallest` is the smallest intact particle's.
/// - `rule.validate()`: throws InvalidInput for parameters that break a rule.
template <class T>
concept TimeStepRule = requires(const T& rule, double mass, double stiffness) {
  { rule.time_step(mass, stiffness) } -> std::convertible_to<double>;
  { rule.mass_scaling(mass, mass) } -> std::convertible_to<double>;
  rule.validate();
};

}  // namespace riprap
