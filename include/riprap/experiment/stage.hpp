// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Hooks of the observers of a test.

#include <concepts>

#include <riprap/experiment/loading_view.hpp>
#include <riprap/simulation/observer.hpp>

/// Hooks that a test adds to those of a simulation step.
namespace riprap::hooks {

/// Which hooks an observer has, in a test of the simulation `Sim`.
template <class O, class Sim>
struct LoadingHooks : StepHooks<O, Sim> {
  using View = LoadingView<Sim>;
  static constexpr bool begin_stage = requires(O& o, View& view) { o.begin_stage(view); } ||
                                      requires { requires IsFunction<&O::begin_stage>; };
  static constexpr bool progress = requires(O& o, View& view) { o.progress(view); } ||
                                   requires { requires IsFunction<&O::progress>; };
  static constexpr bool record = requires(O& o, View& view) { o.record(view); } ||
                                 requires { requires IsFunction<&O::record>; };
  static constexpr bool record_break = requires(O& o, View& view, const BreakEvent& event) {
    o.record_break(view, event);
  } || requires { requires IsFunction<&O::record_break>; };
  static constexpr bool end_stage = requires(O& o, View& view) { o.end_stage(view); } ||
                                    requires { requires IsFunction<&O::end_stage>; };
  static constexpr bool stop_requested = requires(O& o, View& view) { o.stop_requested(view); } ||
                                         requires { requires IsFunction<&O::stop_requested>; };
  static constexpr bool any = HasStepHook<O, Sim> || begin_stage || progress || record ||
                              record_break || stop_requested || end_stage;
};

template <class O, class Sim>
concept HasLoadingHook = LoadingHooks<O, Sim>::any;

/// Refuses an observer that a test would never call: a hook may be misspelt.
template <class O, class Sim>
consteval void check_loading_observer() {
  static_assert(
      HasLoadingHook<O, Sim>,
      "riprap: an observer of a LoadingPath or BiaxialTest must have one of the hooks begin_stage, "
      "progress, record, record_break, stop_requested, end_stage, or one of a step "
      "(docs/policies/observer.md)");
}

/// A stage begins.
inline constexpr auto begin_stage = []<class O, class View>(O& observer, const View& view) {
  if constexpr (requires { observer.begin_stage(view); })
    observer.begin_stage(view);
  else
    check_no_hook<O, requires { requires IsFunction<&O::begin_stage>; },
                  requires(View& other) { observer.begin_stage(other); }>();
};

/// Every hundred steps or so.
inline constexpr auto progress = []<class O, class View>(O& observer, const View& view) {
  if constexpr (requires { observer.progress(view); })
    observer.progress(view);
  else
    check_no_hook<O, requires { requires IsFunction<&O::progress>; },
                  requires(View& other) { observer.progress(other); }>();
};

/// In stages with records: at the start, at regular strains, and at the end.
inline constexpr auto record = []<class O, class View>(O& observer, const View& view) {
  if constexpr (requires { observer.record(view); })
    observer.record(view);
  else
    check_no_hook<O, requires { requires IsFunction<&O::record>; },
                  requires(View& other) { observer.record(other); }>();
};

/// A particle broke in the step just made; `event` is a BreakEvent.
inline constexpr auto record_break = []<class O, class View>(O& observer, const View& view,
                                                             const auto& event) {
  if constexpr (requires { observer.record_break(view, event); })
    observer.record_break(view, event);
  else
    check_no_hook<O, requires { requires IsFunction<&O::record_break>; },
                  requires(View& other) { observer.record_break(other, event); }>();
};

template <class O, class View>
concept StopRequest = requires(O& observer, const View& view) {
  { observer.stop_requested(view) } -> std::convertible_to<bool>;
};

/// After every step; true ends the test here.
inline constexpr auto stop_requested = []<class O, class View>(O& observer, const View& view) {
  if constexpr (StopRequest<O, View>)
    return static_cast<bool>(observer.stop_requested(view));
  else if constexpr (requires { observer.stop_requested(view); })
    static_assert(StopRequest<O, View>,
                  "riprap: stop_requested of an observer must give back a bool");
  else
    check_no_hook<O, requires { requires IsFunction<&O::stop_requested>; },
                  requires(View& other) { observer.stop_requested(other); }>();
  return false;
};

/// A stage has ended; `view.reached_target` and `view.interrupted` say how.
inline constexpr auto end_stage = []<class O, class View>(O& observer, const View& view) {
  if constexpr (requires { observer.end_stage(view); })
    observer.end_stage(view);
  else
    check_no_hook<O, requires { requires IsFunction<&O::end_stage>; },
                  requires(View& other) { observer.end_stage(other); }>();
};

}  // namespace riprap::hooks
