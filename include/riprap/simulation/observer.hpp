// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Observers: read-only callbacks of a step, called only for the hooks they have.

#include <type_traits>

#include <riprap/core/step_phase.hpp>
#include <riprap/simulation/bond_break.hpp>
#include <riprap/simulation/break_event.hpp>

/// An observer is any object with some of the member functions named here; each is called with the
/// simulation (const). A hook that an observer does not have costs nothing; one that it has, but
/// that cannot be called so, is refused. Experiments add hooks of their own.
///
///     struct CountSteps {
///       long count = 0;
///       void after_step(const auto& /*sim*/) { ++count; }
///     };
namespace riprap::hooks {

template <auto member>
concept IsFunction = std::is_member_function_pointer_v<decltype(member)>;

template <class O, bool is_function, bool takes_reference>
concept HasNoSuchHook = !is_function && !takes_reference;

/// Refuses an observer that would be ignored silently.
template <class O, bool is_function, bool takes_reference>
consteval void check_no_hook() {
  static_assert(HasNoSuchHook<O, is_function, takes_reference>,
                "riprap: an observer has a hook that cannot be called with a const "
                "reference to what hooks get (docs/policies/observer.md)");
}

/// Which hooks of a step an observer has; a hook that cannot be called is refused by the step. To
/// assert that none is misspelt: `static_assert(hooks::StepHooks<CountSteps, Sim>::after_step)`.
template <class O, class Sim>
struct StepHooks {
  static constexpr bool on_phase_end = requires(O& o, StepPhase& part) { o.on_phase_end(part); } ||
                                       requires { requires IsFunction<&O::on_phase_end>; };
  static constexpr bool before_forces = requires(O& o, Sim& sim) { o.before_forces(sim); } ||
                                        requires { requires IsFunction<&O::before_forces>; };
  static constexpr bool after_forces = requires(O& o, Sim& sim) { o.after_forces(sim); } ||
                                       requires { requires IsFunction<&O::after_forces>; };
  static constexpr bool before_splits = requires(O& o, Sim& sim) { o.before_splits(sim); } ||
                                        requires { requires IsFunction<&O::before_splits>; };
  static constexpr bool on_break = requires(O& o, Sim& sim, const BreakEvent& event) {
    o.on_break(sim, event);
  } || requires { requires IsFunction<&O::on_break>; };
  static constexpr bool on_bond_break = requires(O& o, Sim& sim, const BondBreak& event) {
    o.on_bond_break(sim, event);
  } || requires { requires IsFunction<&O::on_bond_break>; };
  static constexpr bool after_splits = requires(O& o, Sim& sim) { o.after_splits(sim); } ||
                                       requires { requires IsFunction<&O::after_splits>; };
  static constexpr bool after_step = requires(O& o, Sim& sim) { o.after_step(sim); } ||
                                     requires { requires IsFunction<&O::after_step>; };
  static constexpr bool any = on_phase_end || before_forces || after_forces || before_splits ||
                              on_break || on_bond_break || after_splits || after_step;
};

/// A concept, of which both compilers give the sentence without its condition.
template <class O, class Sim>
concept HasStepHook = StepHooks<O, Sim>::any;

/// Refuses an observer that a step would never call: a hook may be misspelt.
template <class O, class Sim>
consteval void check_step_observer() {
  static_assert(
      HasStepHook<O, Sim>,
      "riprap: an observer of a step must have one of the hooks on_phase_end, before_forces, "
      "after_forces, before_splits, on_break, on_bond_break, after_splits, after_step "
      "(docs/policies/observer.md)");
}

/// Whether an observer measures time.
template <class O>
inline constexpr bool times_phases = [] {
  constexpr bool callable =
      requires(O& observer, const StepPhase part) { observer.on_phase_end(part); };
  if constexpr (!callable)
    check_no_hook<O, requires { requires IsFunction<&O::on_phase_end>; },
                  requires(O& observer, StepPhase& other) { observer.on_phase_end(other); }>();
  return callable;
}();

/// What has passed since the last call was `part` of the step.
inline constexpr auto on_phase_end = []<class O>(O& observer, StepPhase part) {
  if constexpr (times_phases<O>) observer.on_phase_end(part);
};

/// Notifies all observers that measure time; does nothing if there are none.
template <class... Observers>
[[nodiscard]] auto phase_timer(Observers&... observers) {
  if constexpr ((times_phases<Observers> || ...))
    return [&](StepPhase part) { (on_phase_end(observers, part), ...); };
  else
    return NoPhaseTimer{};
}

/// Bodies have moved, contacts are still those of the last step.
inline constexpr auto before_forces = []<class O, class Sim>(O& observer, const Sim& sim) {
  if constexpr (requires { observer.before_forces(sim); })
    observer.before_forces(sim);
  else
    check_no_hook<O, requires { requires IsFunction<&O::before_forces>; },
                  requires(Sim& other) { observer.before_forces(other); }>();
};

/// Contacts are those of the new poses.
inline constexpr auto after_forces = []<class O, class Sim>(O& observer, const Sim& sim) {
  if constexpr (requires { observer.after_forces(sim); })
    observer.after_forces(sim);
  else
    check_no_hook<O, requires { requires IsFunction<&O::after_forces>; },
                  requires(Sim& other) { observer.after_forces(other); }>();
};

/// Some particles are about to break, those of `sim.cracks()`; poses stay as they are until
/// after_splits.
inline constexpr auto before_splits = []<class O, class Sim>(O& observer, const Sim& sim) {
  if constexpr (requires { observer.before_splits(sim); })
    observer.before_splits(sim);
  else
    check_no_hook<O, requires { requires IsFunction<&O::before_splits>; },
                  requires(Sim& other) { observer.before_splits(other); }>();
};

/// One particle has become two, or one and dust; `event` is a BreakEvent.
inline constexpr auto on_break = []<class O, class Sim>(O& observer, const Sim& sim,
                                                        const auto& event) {
  if constexpr (requires { observer.on_break(sim, event); })
    observer.on_break(sim, event);
  else
    check_no_hook<O, requires { requires IsFunction<&O::on_break>; },
                  requires(Sim& other) { observer.on_break(other, event); }>();
};

/// A bond has broken, and contacts are those of the new poses; `event` is a BondBreak.
inline constexpr auto on_bond_break = []<class O, class Sim>(O& observer, const Sim& sim,
                                                             const auto& event) {
  if constexpr (requires { observer.on_bond_break(sim, event); })
    observer.on_bond_break(sim, event);
  else
    check_no_hook<O, requires { requires IsFunction<&O::on_bond_break>; },
                  requires(Sim& other) { observer.on_bond_break(other, event); }>();
};

/// Contacts of the pieces are evaluated.
inline constexpr auto after_splits = []<class O, class Sim>(O& observer, const Sim& sim) {
  if constexpr (requires { observer.after_splits(sim); })
    observer.after_splits(sim);
  else
    check_no_hook<O, requires { requires IsFunction<&O::after_splits>; },
                  requires(Sim& other) { observer.after_splits(other); }>();
};

/// The step is complete.
inline constexpr auto after_step = []<class O, class Sim>(O& observer, const Sim& sim) {
  if constexpr (requires { observer.after_step(sim); })
    observer.after_step(sim);
  else
    check_no_hook<O, requires { requires IsFunction<&O::after_step>; },
                  requires(Sim& other) { observer.after_step(other); }>();
};

}  // namespace riprap::hooks
