// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/step_phase.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <type_traits>

using namespace riprap;

TEST_CASE("every part of a step has a name of its own, and elsewhere is the last") {
  std::set<std::string> names;
  for (std::size_t i = 0; i < step_phase_count; ++i) {
    const std::string name = to_text(static_cast<StepPhase>(i));
    CHECK(!name.empty());
    CHECK(names.insert(name).second);
  }
  CHECK(static_cast<std::size_t>(StepPhase::other) + 1 == step_phase_count);
  CHECK(to_text(StepPhase::contact_law) == std::string("contact law"));
}

TEST_CASE("the timer that does nothing takes no memory") {
  static_assert(std::is_empty_v<NoPhaseTimer>);
  NoPhaseTimer{}(StepPhase::integration);
}
