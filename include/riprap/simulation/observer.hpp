#pragma once
/// @file
/// Observers: read-only guests of a step, called only for the hooks they have.

namespace riprap {

/// An observer is any object with some of these members, each called with the simulation (const):
///
/// - `before_forces(sim)`: bodies have moved, contacts are still those of the last step
/// - `after_forces(sim)`: contacts are those of the new poses
/// - `before_splits(sim)`, `after_splits(sim)`: round the breaks of one step, poses unchanged
/// - `on_break(sim, event)`: one particle has become two; `event` is a BreakEvent
/// - `after_step(sim)`
///
/// A hook that an observer does not have costs nothing. Experiments add hooks of their own.
///
/// `notify(call, observers...)` passes each observer to `call`, which picks the hook.
template <class Call, class... Observers>
void notify(Call&& call, Observers&... observers) {
  (call(observers), ...);
}

}  // namespace riprap
