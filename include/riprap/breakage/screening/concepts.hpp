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
/// no result. Its state depends on the parts of a model, with which it is checked.
template <class S>
concept Screening = Policy<S> && requires { S::skips_particles; };

template <class S>
consteval bool check_screening() {
  check_policy<S>();
  static_assert(
      requires { S::skips_particles; },
      "riprap: a Screening must have static constexpr bool skips_particles and template "
      "<class BreakagePart, class StressPart> class State");
  return Screening<S>;
}

}  // namespace riprap
