// SPDX-License-Identifier: BSL-1.0
// Whole time steps of dense samples in shear, with about four contacts a particle.
//
// step/no_breakage/N   polygons of 5 to 8 corners at 2 MPa, without stress in the particles; larger
//                      samples repeat the cell of the smallest
// step/chord/N         the same with OverlapChord and LinearSpringCoulomb, at their time step
// step/breakage/P      500 sharp particles in a biaxial test at P, as examples/biaxial runs it: the
//                      stress is checked in each at every step, and what has to break breaks. The
//                      counters say what share of the time the checks are. Timed in the first 3 %
//                      of strain; the servo steers on, untimed
// step/one_break/N     what a break costs beside the step in which it occurs, its stress and its
//                      operator apart: the particle is divided, and the contacts of its pieces are
//                      found; the mean, and the median as a counter
// threads/T            5,000 polygons at 8 MPa with breakage on T threads; mind the real time
//
// Each sample is brought to shear once, outside the timing, which takes some seconds.

#include <algorithm>
#include <chrono>
#include <map>
#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/step_timer.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

#ifdef _OPENMP
#include <riprap/core/execution/threads.hpp>
#endif

#include "support.hpp"
#include "tiled_sample.hpp"

namespace bench {
namespace {

[[nodiscard]] const DenseCell& blunt_cell(double pressure) {
  static std::map<double, DenseCell> cells;
  const auto found = cells.find(pressure);
  if (found != cells.end()) return found->second;
  return cells.emplace(pressure, dense_cell(blunt, pressure)).first->second;
}

template <class Sim>
void step_on(benchmark::State& state, Sim& sim) {
  for (auto _ : state) sim.step();
  count_time(state, "particle-step", static_cast<double>(sim.particles().size()));
  state.counters["contacts/particle"] =
      coordination(sim.contacts(), sim.particles()).contacts_per_particle;
}

template <class ModelType>
void step_without_breakage(benchmark::State& state, const ModelType& model) {
  const auto cells = static_cast<unsigned>(state.range(0)) / 500;
  const unsigned rows = cells >= 100 ? 10 : cells >= 10 ? 2 : 1;
  auto sim = sheared(model.criterion(NeverFails{}), blunt_cell(2e6), cells / rows, rows);
  step_on(state, sim);
}
void no_breakage(benchmark::State& state) { step_without_breakage(state, Model{}); }
BENCHMARK(no_breakage)
    ->Name("step/no_breakage")
    ->Arg(500)
    ->Arg(2000)
    ->Arg(5000)
    ->Arg(20000)
    ->Arg(50000)
    ->Arg(100000);

void chord(benchmark::State& state) {
  step_without_breakage(state, Model{}
                                   .narrow_phase(OverlapChord{})
                                   .contact_law(LinearSpringCoulomb{})
                                   .time_step(MassFloor{.fraction = 0.12}));
}
BENCHMARK(chord)->Name("step/chord")->Arg(500)->Arg(5000);

// Keeps what a timer says at the beginning of shear.
struct BeforeShear {
  const StepTimer& timer;
  StepTimer then{};
  void begin_stage(const auto& view) {
    if (view.stage == Stage::shear) then = timer;
  }
};

// A biaxial test of which every step of shear is timed.
void breakage(benchmark::State& state, double pressure) {
  RandomAssembly options{.count = 500, .mean_diameter = size};
  Simulation sim{Model{}, random_assembly(options), Rock{}};
  StepTimer timer;
  BeforeShear before{timer};
  for (auto _ : state) {
    BiaxialTest{.confining_pressure = pressure, .axial_strain = 0.03}.run(sim, timer, before);
    const auto seconds = [&](StepPhase part) {
      return timer.seconds(part) - before.then.seconds(part);
    };
    const auto steps = static_cast<double>(timer.particle_steps() - before.then.particle_steps());
    const double checks = seconds(StepPhase::stress_bound) + seconds(StepPhase::stress_check) +
                          seconds(StepPhase::splitting);
    const double all = timer.seconds() - before.then.seconds() - seconds(StepPhase::other);
    state.SetIterationTime(all);
    state.counters["ns/particle-step"] = 1e9 * all / steps;
    state.counters["ns of it checks"] = 1e9 * checks / steps;
  }
  state.counters["breaks"] = static_cast<double>(sim.breaks().size());
}
BENCHMARK_CAPTURE(breakage, 2MPa, 2e6)
    ->Name("step/breakage/2MPa")
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(breakage, 14MPa, 14e6)
    ->Name("step/breakage/14MPa")
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

// Has one particle evaluated, and no other.
struct OneParticle {
  template <class BreakagePart, class StressPart>
  struct State {
    State(const BreakagePart&, const StressPart&) {}
    template <class Input, class IsLoaded, class OnPhaseEnd>
    void find_candidates(const Input& input, ContactLoads& loads, IsLoaded&& is_loaded,
                         std::vector<BodyIndex>& candidates, OnPhaseEnd&&) {
      // Far from those before, and intact.
      do next_ = (next_ + input.particles.size() * 5 / 13 + 1) % input.particles.size();
      while (input.particles.ancestry(static_cast<BodyIndex>(next_)).generation > 0);
      const auto i = static_cast<BodyIndex>(next_);
      loads.gather(input.contacts, i);
      if (is_loaded(i)) candidates.push_back(i);
    }
    void forget(BodyIndex) {}

   private:
    std::size_t next_ = 0;
  };
};

struct FailsAtOnce {
  [[nodiscard]] double major_stress_at_failure(double minor) const { return minor + 1; }
  [[nodiscard]] double tensile_strength() const { return 1; }  // [Pa]
};

// Time from the last crack to the first call for a break.
struct BreakTimer {
  using Clock = std::chrono::steady_clock;
  Clock::time_point start{};
  double seconds = 0;

  void before_splits(const auto&) { start = Clock::now(); }
  void on_break(const auto&, const BreakEvent&) {
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
};

void one_break(benchmark::State& state) {
  const auto cells = static_cast<unsigned>(state.range(0)) / 500;
  const unsigned rows = cells >= 100 ? 10 : cells >= 10 ? 2 : 1;
  auto sim = sheared(Model{}.criterion(FailsAtOnce{}).screening(OneParticle{}).check_every(10),
                     blunt_cell(2e6), cells / rows, rows);
  std::vector<double> seconds;
  for (auto _ : state) {
    BreakTimer timer;
    while (timer.seconds == 0) sim.step(timer);
    seconds.push_back(timer.seconds);
    state.SetIterationTime(timer.seconds);
  }
  std::sort(seconds.begin(), seconds.end());
  state.counters["median us"] = 1e6 * seconds[seconds.size() / 2];
}
BENCHMARK(one_break)
    ->Name("step/one_break")
    ->Arg(500)
    ->Arg(5000)
    ->Arg(100000)
    ->Iterations(100)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

#ifdef _OPENMP
void threads(benchmark::State& state) {
  auto sim =
      sheared(Model{}.execution(Threads{static_cast<int>(state.range(0))}), blunt_cell(8e6), 5, 2);
  step_on(state, sim);
}
BENCHMARK(threads)->Name("threads")->Arg(1)->Arg(2)->UseRealTime();
#endif

}  // namespace
}  // namespace bench
