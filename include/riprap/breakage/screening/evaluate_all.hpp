// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Every loaded particle is evaluated at every check: the screening without acceleration.

#include <vector>

#include <riprap/breakage/screening/concepts.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// Skips no particle.
struct EvaluateAll {
  template <class BreakagePart, class StressPart>
  struct State {
    State(const BreakagePart&, const StressPart&) {}

    template <class Input, class IsLoaded, class OnPhaseEnd>
    void find_candidates(const Input& input, ContactLoads& loads, IsLoaded&& is_loaded,
                         std::vector<BodyIndex>& candidates, OnPhaseEnd&&) const {
      for (BodyIndex i = 0; i < input.particles.size(); ++i) {
        loads.gather(input.contacts, i);
        if (is_loaded(i)) candidates.push_back(i);
      }
    }
    void forget(BodyIndex) {}
  };
};

static_assert(Screening<EvaluateAll>);

}  // namespace riprap
