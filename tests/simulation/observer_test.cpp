// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/simulation/observer.hpp>
#include <vector>

using namespace riprap;

namespace {

struct Some {
  std::vector<int> calls;
  void before_forces(int sim) { calls.push_back(sim); }
  void on_break(int sim, int event) { calls.push_back(10 * sim + event); }
};
struct None {};
struct StopWatch {
  std::vector<StepPhase> laps;
  void on_phase_end(StepPhase part) { laps.push_back(part); }
};

// Only an observer that measures time makes the step read a clock.
static_assert(hooks::times_phases<StopWatch>);
static_assert(!hooks::times_phases<None>);
static_assert(!hooks::times_phases<Some>);

// A misspelt hook is none, one with another parameter is one, which a step refuses.
struct Misspelt {
  void after_stpe(int) {}
};
struct Changes {
  void after_step(int&) {}
};
static_assert(hooks::StepHooks<Some, int>::before_forces);
static_assert(!hooks::StepHooks<Some, int>::after_forces);
static_assert(hooks::StepHooks<StopWatch, int>::any);
static_assert(!hooks::StepHooks<None, int>::any);
static_assert(!hooks::StepHooks<Misspelt, int>::any);
static_assert(hooks::StepHooks<Changes, int>::after_step);

}  // namespace

TEST_CASE("an observer is called for the hooks it has and left alone for the others") {
  Some some;
  hooks::before_forces(some, 1);
  hooks::after_forces(some, 2);
  hooks::before_splits(some, 3);
  hooks::on_break(some, 4, 5);
  hooks::after_splits(some, 6);
  hooks::after_step(some, 7);
  CHECK(some.calls == std::vector<int>{1, 45});

  None none;
  hooks::before_forces(none, 1);
  hooks::on_break(none, 1, 2);
}

TEST_CASE("an observer that measures time gets the phase of the step") {
  StopWatch watch;
  hooks::on_phase_end(watch, StepPhase::broad_phase);
  hooks::on_phase_end(watch, StepPhase::other);
  CHECK(watch.laps == std::vector<StepPhase>{StepPhase::broad_phase, StepPhase::other});

  None none;
  hooks::on_phase_end(none, StepPhase::broad_phase);
}
