#pragma once
/// @file
/// The role of the trigger: when does a particle with failed elements break?

#include <concepts>

#include <riprap/breakage/failure_tally.hpp>

namespace riprap {

/// A `BreakageTrigger` decides from the tally of one evaluation.
///
/// - `trigger(tally)` -> bool
/// - `trigger.validate()`: throws InvalidInput for parameters that break a rule.
///
/// Optional:
/// - `trigger.strength_factor(id, area)` [-], above 0: strength of the particle over that of the
///   criterion, the same whenever it is asked for.
template <class T>
concept BreakageTrigger = requires(const T& trigger, const FailureTally& tally) {
  { trigger(tally) } -> std::convertible_to<bool>;
  trigger.validate();
};

}  // namespace riprap
