// Whole time steps of a dense sample of N sharp particles at 2 MPa, while a biaxial test shears it.
// step/breakage checks the stress in every free particle at every step and breaks what has to
// break; step/no_breakage leaves that out. Each N is brought to shear once, outside the timing,
// which takes a minute; timed steps start where the last ones ended, and the servo steers on,
// untimed. Not measured: the stages before shear, measurements and records. The counter `breaks`
// says how many breaks fell into the timed steps: early in shear, few or none (see
// stress/build_operator).

#include <map>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

#include "support.hpp"

namespace bench {
namespace {

// A biaxial test in shear, from where the program of the test has left it.
class Sheared {
 public:
  explicit Sheared(unsigned count)
      : sim(Model{}, random_assembly({.count = count, .mean_diameter = size}), Rock{}) {
    sim.set_breakage(false);
    rate_ = test.run(sim).axial_rate;
    (void)sim.failed_ratios();  // builds the operators that are not there yet
    steer(0);
  }

  // Shortens axis 2 on and holds the stress along axis 1.
  void steer(double time) {
    const double area = sim.boundary().region(sim.particles()).area();
    const double thickness = sim.particles().thickness();
    const double stress = average_stress(sim.contacts(), area, thickness).s11;
    sim.boundary().set_rate(servo_.rate(pressure - stress, time), rate_);
  }

  Simulation<Model<>> sim;

 private:
  static constexpr double pressure = 2e6;
  // Barely relaxed: the pressure that comes next is what counts.
  static constexpr BiaxialTest test{
      .confining_pressure = pressure, .axial_strain = 0.002, .rest_unbalanced_force = 0.1};

  double rate_ = 0;
  // As in the test: a sample as stiff as k_n / 2t, answered in the time of a pressure wave.
  PressureServo servo_{0.5 * LinearSpringCoulomb{}.normal_stiffness / size, 4e-4, 20};
};

[[nodiscard]] Sheared& sheared(unsigned count) {
  static std::map<unsigned, Sheared> samples;
  return samples.try_emplace(count, count).first->second;
}

template <bool breakage>
void step(benchmark::State& state) {
  Sheared& sample = sheared(static_cast<unsigned>(state.range(0)));
  auto& sim = sample.sim;
  sim.set_breakage(breakage);
  const std::size_t breaks = sim.breaks().size();

  constexpr int between_steering = 32;
  int steps = 0;
  for (auto _ : state) {
    sim.step();
    if (++steps % between_steering != 0) continue;
    state.PauseTiming();
    sample.steer(between_steering * sim.time_step());
    state.ResumeTiming();
  }
  const Particles& particles = sim.particles();
  count_time(state, "particle-step", static_cast<double>(particles.size()));
  state.counters["contacts/particle"] =
      coordination(sim.contacts(), particles).contacts_per_particle;
  state.counters["breaks"] = static_cast<double>(sim.breaks().size() - breaks);
}

BENCHMARK(step<false>)->Name("step/no_breakage")->Arg(500)->Arg(2000);
BENCHMARK(step<true>)->Name("step/breakage")->Arg(500)->Arg(2000);

}  // namespace
}  // namespace bench
