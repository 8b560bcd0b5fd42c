// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the time-step rule.

#include <concepts>

#include <riprap/core/policy.hpp>

namespace riprap {

namespace requirements {

/// `rule.time_step(mass, stiffness)` [s]: from the smallest intact particle's mass [kg] and the
/// contact law's peak stiffness [N/m], which together bound the highest frequency.
template <class T>
concept TimeStepStep = requires(const T& rule, const double mass, const double stiffness) {
  { rule.time_step(mass, stiffness) } -> std::convertible_to<double>;
};

/// `rule.mass_scaling(mass, smallest)` [-], >= 1: factor on mass and inertia, in the equations of
/// motion only, of a piece of `mass` where `smallest` is the smallest intact particle's. Pieces are
/// lighter than the particle that the step was chosen for; the rule scales their mass.
template <class T>
concept TimeStepScaling = requires(const T& rule, const double mass, const double smallest) {
  { rule.mass_scaling(mass, smallest) } -> std::convertible_to<double>;
};

}  // namespace requirements

/// A `TimeStep` chooses the time step and how light a body may be in the equations of motion.
template <class T>
concept TimeStep = Policy<T> && requirements::TimeStepStep<T> && requirements::TimeStepScaling<T>;

template <class T>
consteval bool check_time_step() {
  check_policy<T>();
  static_assert(
      requirements::TimeStepStep<T>,
      "riprap: a TimeStep must have double time_step(double mass, double stiffness) const");
  static_assert(
      requirements::TimeStepScaling<T>,
      "riprap: a TimeStep must have double mass_scaling(double mass, double smallest) const");
  return TimeStep<T>;
}

}  // namespace riprap
