#pragma once
/// @file
/// Observers: read-only guests of a step, called only for the hooks they have.

#include <type_traits>

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
concept is_function = std::is_member_function_pointer_v<decltype(member)>;

template <class O, bool there>
concept HasNoSuchHook = !there;

/// Says in one sentence that an observer would be passed over in silence.
template <class O, bool there>
consteval void check_no_hook() {
  static_assert(HasNoSuchHook<O, there>,
                "riprap: an observer has a hook that cannot be called with a const "
                "reference to what hooks get (docs/policies/observer.md)");
}

/// Bodies have moved, contacts are still those of the last step.
inline constexpr auto before_forces = []<class O>(O& observer, const auto& sim) {
  if constexpr (requires { observer.before_forces(sim); })
    observer.before_forces(sim);
  else
    check_no_hook<O, requires { requires is_function<&O::before_forces>; }>();
};

/// Contacts are those of the new poses.
inline constexpr auto after_forces = []<class O>(O& observer, const auto& sim) {
  if constexpr (requires { observer.after_forces(sim); })
    observer.after_forces(sim);
  else
    check_no_hook<O, requires { requires is_function<&O::after_forces>; }>();
};

/// Some particles are about to break; poses stay as they are until after_splits.
inline constexpr auto before_splits = []<class O>(O& observer, const auto& sim) {
  if constexpr (requires { observer.before_splits(sim); })
    observer.before_splits(sim);
  else
    check_no_hook<O, requires { requires is_function<&O::before_splits>; }>();
};

/// One particle has become two; `event` is a BreakEvent.
inline constexpr auto on_break = []<class O>(O& observer, const auto& sim, const auto& event) {
  if constexpr (requires { observer.on_break(sim, event); })
    observer.on_break(sim, event);
  else
    check_no_hook<O, requires { requires is_function<&O::on_break>; }>();
};

/// Pieces have met their neighbours.
inline constexpr auto after_splits = []<class O>(O& observer, const auto& sim) {
  if constexpr (requires { observer.after_splits(sim); })
    observer.after_splits(sim);
  else
    check_no_hook<O, requires { requires is_function<&O::after_splits>; }>();
};

/// The step is complete.
inline constexpr auto after_step = []<class O>(O& observer, const auto& sim) {
  if constexpr (requires { observer.after_step(sim); })
    observer.after_step(sim);
  else
    check_no_hook<O, requires { requires is_function<&O::after_step>; }>();
};

}  // namespace riprap::hooks
