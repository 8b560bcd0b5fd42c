// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the screening: which particles have to be evaluated in a breakage pass.

#include <concepts>
#include <vector>

#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

namespace requirements {

/// Stands for the template of a state.
template <template <class BreakagePart, class StressPart> class>
struct ScreeningStateTemplate {};

/// `S::State` is a template of the two parts of a model that it is made from.
template <class S>
concept ScreeningTemplate = requires { ScreeningStateTemplate<S::template State>{}; };

/// `S::State<BreakagePart, StressPart>`, made from the two: what a simulation keeps. An exact
/// evaluation is needed of every particle that `state.find_candidates(input, loads, is_loaded,
/// candidates, on_phase_end)` puts into `candidates`, in rising order. It gathers the loads of a
/// particle and asks `is_loaded(i)`, false if the particle cannot break whatever its stress is.
/// `state.forget(i)`: another particle has index i now.
template <class S, class BreakagePart, class StressPart>
concept ScreeningState =
    requires { typename S::template State<BreakagePart, StressPart>; } &&
    std::constructible_from<typename S::template State<BreakagePart, StressPart>,
                            const BreakagePart&, const StressPart&> &&
    requires(typename S::template State<BreakagePart, StressPart>& state, BodyIndex i) {
      state.forget(i);
    };

}  // namespace requirements

/// A `Screening` leaves out particles of which it is proved that they do not break now. It changes
/// no result. Its state depends on the parts of a model: `BreakageStage` asserts ScreeningState.
template <class S>
concept Screening = Policy<S> && requirements::ScreeningTemplate<S>;

template <class S>
consteval bool check_screening() {
  check_policy<S>();
  static_assert(requirements::ScreeningTemplate<S>,
                "riprap: a Screening must have template <class BreakagePart, class StressPart> "
                "class State");
  return Screening<S>;
}

/// Of the state for the parts of a model. Always true: an error is one sentence.
template <class S, class BreakagePart, class StressPart>
consteval bool check_screening_state() {
  static_assert(requirements::ScreeningState<S, BreakagePart, StressPart>,
                "riprap: the State of a Screening must be made from the breakage part and the "
                "stress part of a model, and have forget(i)");
  return true;
}

}  // namespace riprap
