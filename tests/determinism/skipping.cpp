// SPDX-License-Identifier: BSL-1.0
// skipping PARTICLES STRAIN PRESSURE...: biaxial tests at each of the pressures [MPa], three times:
// as they are, with memory for a part of the operators only, and with a trigger that does not say
// how many failed elements it needs, so that every particle is evaluated at every step. Breakages
// and curves must be the same to the last byte, and some particles must break.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <riprap/riprap.hpp>

using namespace riprap;

namespace {

// The default without what lets particles be passed over.
struct AlwaysAsked {
  FailedElementRatio rule{};
  bool operator()(const FailureCount& failures) const { return rule(failures); }
};

struct Outcome {
  std::string tables;
  std::size_t breaks;
};

template <class Trigger>
Outcome run(const Trigger& trigger, unsigned particles, double strain, double pressure,
            std::size_t budget) {
  Simulation sim{Model{}.trigger(trigger), random_assembly({.count = particles, .seed = 1}),
                 Rock{}};
  sim.set_operator_budget(budget);
  Curve curve;
  BiaxialTest{.confining_pressure = pressure, .axial_strain = strain}.run(sim, curve);
  return {curve_csv(curve) + energy_csv(curve) + breakages_csv(curve), sim.breaks().size()};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::puts("skipping PARTICLES STRAIN PRESSURE...");
    return 2;
  }
  const auto particles = static_cast<unsigned>(std::atoi(argv[1]));
  const double strain = std::atof(argv[2]);
  constexpr std::size_t all = std::size_t{4} << 30;
  const std::size_t some = particles * std::size_t{60'000};
  std::size_t breaks = 0;
  for (int k = 3; k < argc; ++k) {
    const double pressure = 1e6 * std::atof(argv[k]);
    const Outcome every = run(AlwaysAsked{}, particles, strain, pressure, all);
    const Outcome few = run(FailedElementRatio{}, particles, strain, pressure, all);
    const Outcome bounded = run(FailedElementRatio{}, particles, strain, pressure, some);
    std::printf("%s MPa: %zu breaks\n", argv[k], every.breaks);
    breaks += every.breaks;
    if (few.tables != every.tables) {
      std::puts("passing over particles has changed the outcome");
      return 1;
    }
    if (bounded.tables != every.tables) {
      std::puts("the budget of memory has changed the outcome");
      return 1;
    }
  }
  if (breaks < 2) {
    std::puts("too few particles broke for this to say anything");
    return 1;
  }
}
