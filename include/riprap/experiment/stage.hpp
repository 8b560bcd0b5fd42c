// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The stages of a biaxial test and what an observer sees of them.

#include <concepts>

#include <riprap/core/vec2.hpp>
#include <riprap/simulation/observer.hpp>

namespace riprap {

/// In this order.
enum class Stage { compaction, relaxation, hydrostatic, shear };

[[nodiscard]] constexpr const char* to_text(Stage stage) {
  switch (stage) {
  case Stage::compaction:
    return "compaction";
  case Stage::relaxation:
    return "relaxation";
  case Stage::hydrostatic:
    return "hydrostatic";
  case Stage::shear:
    return "shear";
  }
  return "";
}

/// The state of a biaxial test, handed to observers' hooks.
template <class Sim>
struct BiaxialView {
  const Sim& sim;
  Stage stage = Stage::compaction;
  double done = 0;                    ///< rough share of the stage that is done, in [0, 1]
  bool reached_target = false;        ///< at end_stage; false: it was missed, or a stop came first
  bool interrupted = false;           ///< an observer's stop_requested ended the test
  double confining_pressure = 0;      ///< [Pa]
  double mean_diameter = 0;           ///< of the circles of equal area, intact particles [m]
  Vec2 stretch{1, 1};                 ///< extent over that at the start of the stage, axes 1 and 2
  Vec2 rate{0, 0};                    ///< shortening rates [1/s]
  double area = 0;                    ///< of the assembly [m^2]
  double mean_confinement_error = 0;  ///< of shear so far: mean of sigma_11 / pressure - 1
  double saturated_share = 0;         ///< steps of shear so far with the servo at its limit

  /// Engineering strain of the field along axis 2, positive in shortening.
  [[nodiscard]] double axial_strain() const { return 1 - stretch.y(); }
  /// Positive in contraction.
  [[nodiscard]] double volumetric_strain() const { return 1 - stretch.x() * stretch.y(); }
};

/// Hooks that a biaxial test adds to those of a simulation step.
namespace hooks {

/// Which hooks an observer has, in a biaxial test of the simulation `Sim`.
template <class O, class Sim>
struct BiaxialHooks : StepHooks<O, Sim> {
  using View = BiaxialView<Sim>;
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
  static constexpr bool any = StepHooks<O, Sim>::any || begin_stage || progress || record ||
                              record_break || stop_requested || end_stage;
};

/// Refuses an observer that a biaxial test would never call: a hook may be misspelt.
template <class O, class Sim>
consteval void check_biaxial_observer() {
  static_assert(BiaxialHooks<O, Sim>::any,
                "riprap: an observer of a BiaxialTest must have one of the hooks begin_stage, "
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

/// In shear: at the start, at regular strains, and at the end.
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

}  // namespace hooks
}  // namespace riprap
