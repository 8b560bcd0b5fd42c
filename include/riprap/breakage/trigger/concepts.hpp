#pragma once
/// @file
/// The role of the trigger: when does a particle with failed elements break?

#include <concepts>

#include <riprap/breakage/failure_tally.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

namespace clauses {

/// `trigger(tally)` -> bool. Const: a decision depends on one evaluation, not on those before it.
template <class T>
concept BreakageTriggerCall = requires(const T& trigger, const FailureTally& tally) {
  { trigger(tally) } -> std::convertible_to<bool>;
};

/// Optional: `trigger.strength_factor(id, area)` [-], above 0: strength of the particle over that
/// of the criterion. Const, for it must be the same whenever it is asked for; one that is not would
/// be passed over in silence.
template <class T>
concept BreakageTriggerStrength = !requires(T& trigger, ParticleId id, double area) {
  trigger.strength_factor(id, area);
} || requires(const T& trigger, const ParticleId id, const double area) {
  { trigger.strength_factor(id, area) } -> std::convertible_to<double>;
};

}  // namespace clauses

/// A `BreakageTrigger` decides from the tally of one evaluation.
template <class T>
concept BreakageTrigger =
    Policy<T> && clauses::BreakageTriggerCall<T> && clauses::BreakageTriggerStrength<T>;

template <class T>
consteval bool check_trigger() {
  check_policy<T>();
  static_assert(clauses::BreakageTriggerCall<T>,
                "riprap: a BreakageTrigger must have bool operator()(const FailureTally&) const");
  static_assert(clauses::BreakageTriggerStrength<T>,
                "riprap: strength_factor of a BreakageTrigger must be double "
                "strength_factor(ParticleId, double area) const");
  return BreakageTrigger<T>;
}

}  // namespace riprap
