#pragma once
/// @file
/// Observers: read-only guests of a step, called only for the hooks they have.

/// An observer is any object with some of the member functions named here; each is called with the
/// simulation (const). A hook that an observer does not have costs nothing. Experiments add hooks
/// of their own.
///
///     struct CountSteps {
///       long count = 0;
///       void after_step(const auto& /*sim*/) { ++count; }
///     };
namespace riprap::hooks {

/// Bodies have moved, contacts are still those of the last step.
inline constexpr auto before_forces = [](auto& observer, const auto& sim) {
  if constexpr (requires { observer.before_forces(sim); }) observer.before_forces(sim);
};

/// Contacts are those of the new poses.
inline constexpr auto after_forces = [](auto& observer, const auto& sim) {
  if constexpr (requires { observer.after_forces(sim); }) observer.after_forces(sim);
};

/// Some particles are about to break; poses stay as they are until after_splits.
inline constexpr auto before_splits = [](auto& observer, const auto& sim) {
  if constexpr (requires { observer.before_splits(sim); }) observer.before_splits(sim);
};

/// One particle has become two; `event` is a BreakEvent.
inline constexpr auto on_break = [](auto& observer, const auto& sim, const auto& event) {
  if constexpr (requires { observer.on_break(sim, event); }) observer.on_break(sim, event);
};

/// Pieces have met their neighbours.
inline constexpr auto after_splits = [](auto& observer, const auto& sim) {
  if constexpr (requires { observer.after_splits(sim); }) observer.after_splits(sim);
};

/// The step is complete.
inline constexpr auto after_step = [](auto& observer, const auto& sim) {
  if constexpr (requires { observer.after_step(sim); }) observer.after_step(sim);
};

}  // namespace riprap::hooks
