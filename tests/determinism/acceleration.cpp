// SPDX-License-Identifier: BSL-1.0
// acceleration PARTICLES STRAIN PRESSURE...: biaxial tests at each of the pressures [MPa], with the
// models of acceleration/, with each of them replaced by one that does nothing, with operators for
// a part of the particles, and without acceleration. Breakages, curves and energies must be the
// same to the last byte, and some particles must break.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <riprap/riprap.hpp>
#include <riprap/simulation/presets/recommended.hpp>

using namespace riprap;

namespace {

struct Outcome {
  std::string tables;
  std::size_t breaks;
};

struct Sample {
  unsigned particles;
  double strain;
  double pressure;  // [Pa]
};

template <class ModelType>
Outcome run(const Sample& sample, const ModelType& model) {
  const Assembly assembly = Simulation<ModelType>::Domain::periodic
                                ? random_periodic_assembly({.count = sample.particles, .seed = 1})
                                : random_assembly({.count = sample.particles, .seed = 1});
  Simulation sim{model, assembly, Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = sample.pressure, .axial_strain = sample.strain}.run(sim, curve);
  return {curve_csv(curve) + energy_csv(curve) + breakages_csv(curve), sim.breaks().size()};
}

template <class ModelType>
bool same(const Sample& sample, const ModelType& model, const Outcome& expected,
          const char* replaced) {
  const bool equal = run(sample, model).tables == expected.tables;
  std::printf("  %s: %s\n", replaced, equal ? "same bytes" : "OTHER BYTES");
  return equal;
}

// Number of breaks; -1 where bytes differ.
template <class ModelType>
int compare(const Sample& sample, const ModelType& model) {
  const Outcome expected = run(sample, model);
  std::printf("%g MPa: %zu breaks\n", 1e-6 * sample.pressure, expected.breaks);
  const std::size_t part = sample.particles * std::size_t{60'000};  // of the operators [bytes]
  bool equal = same(sample, model.neighbour_list(RebuildEveryStep{}), expected, "neighbour list");
  equal &= same(sample, model.detection(EvaluateEachPair{}), expected, "detection");
  equal &= same(sample, model.screening(EvaluateAll{}), expected, "screening");
  equal &= same(sample, model.operator_store(OperatorCache{.budget = part}), expected,
                "operators of a part of the particles only");
  equal &= same(sample, model.without_acceleration(), expected, "all");
  return equal ? static_cast<int>(expected.breaks) : -1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::puts("acceleration PARTICLES STRAIN PRESSURE...");
    return 2;
  }
  Sample sample{.particles = static_cast<unsigned>(std::atoi(argv[1])),
                .strain = std::atof(argv[2]),
                .pressure = 0};
  int breaks = 0;
  for (int k = 3; k < argc; ++k) {
    sample.pressure = 1e6 * std::atof(argv[k]);
    const auto recommended = presets::recommended();
    for (const int found :
         {compare(sample, Model{}), compare(sample, Model{}.boundary(PeriodicCell{})),
          compare(sample, recommended), compare(sample, recommended.boundary(PeriodicCell{}))}) {
      if (found < 0) return 1;
      breaks += found;
    }
  }
  if (breaks < 2) {
    std::puts("too few particles broke for this to say anything");
    return 1;
  }
}
