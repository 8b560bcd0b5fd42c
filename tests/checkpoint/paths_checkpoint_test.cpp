// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <riprap/checkpoint/checkpoint.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/paths/cyclic_shear.hpp>
#include <riprap/experiment/paths/isotropic_compression.hpp>
#include <riprap/experiment/paths/oedometer.hpp>
#include <riprap/experiment/paths/shear.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

constexpr double pressure = 4e6;

LoadingStage<> short_stage(const char* name, const AxisControl& axis_1, const AxisControl& axis_2,
                           const EndCondition& end) {
  return {.name = name, .axis_1 = axis_1, .axis_2 = axis_2, .end = end, .record_every = 2e-4};
}

// Every control and every condition, with the ready-made stages.
LoadingPath<> all_in_one() {
  LoadingPath<> path{.confining_pressure = pressure, .stages = Preparation{}.stages(pressure)};
  const ShearOptions options{.axial_strain = 1e-3};
  path.append(IsotropicCompression{.pressures = {4.5e6}}.stages(pressure));
  path.append(Oedometer{.vertical_stresses = {5e6, 4.6e6}}.stages(pressure));
  const auto append = [&](LoadingStage<> stage) {
    stage.zero_strain = true;
    path.stages.push_back(std::move(stage));
  };
  append(drained_shear(pressure, options));
  append(constant_mean_stress_shear(pressure, options));
  append(constant_volume_shear(options));
  append(short_stage("back", ControlledStress{.stress = pressure},
                     EngineeringRate{.rate_of_strain = {.inertial_number = -1e-3}},
                     StressReached{.stress = 4.2e6}));
  for (LoadingStage<>& stage :
       CyclicShear{.lower = -5e-4, .upper = 5e-4, .cycles = 1, .pressure = pressure}.stages())
    path.stages.push_back(std::move(stage));
  path.stages[path.stages.size() - 2].zero_strain = true;
  const LoadingRate rate{.inertial_number = 1e-3};
  append(short_stage(
      "ramp", ControlledStress{.stress = 4.4e6, .stress_rate = 1e9},
      LogarithmicRate{.rate_of_strain = rate},
      AnyOf<SingleEndOr<>>{{.parts = {StrainReached{.strain = 5e-4}, StepsMade{.steps = 2000}}}}));
  append(short_stage(
      "ratio", StressRatio{.ratio = 0.8}, EngineeringRate{.rate_of_strain = rate},
      AllOf<SingleEndOr<>>{{.parts = {StrainReached{.strain = 3e-4}, StepsMade{.steps = 100}}}}));
  append(short_stage("free", FreeBoundary{}, Fixed{}, StepsMade{.steps = 300}));
  return path;
}

}  // namespace

TEST_CASE("A path goes on from checkpoints in every stage to the same bytes") {
  const auto start = [] {
    return Simulation{Model{}.criterion(HoekBrown{.compressive_strength = 60e6}),
                      random_assembly({.count = 40, .seed = 3}), Rock{}};
  };
  const LoadingPath<> path = all_in_one();
  auto whole = start();
  Curve expected;
  const PathResult result = path.run(whole, expected);
  REQUIRE(result.stages.size() == path.stages.size());
  CHECK(!whole.breaks().empty());
  std::vector<std::uint64_t> stops;
  std::uint64_t begun = 0;
  for (const StageResult& stage : result.stages) {
    REQUIRE(stage.steps > 10);
    stops.push_back(begun + stage.steps / 2);
    begun += stage.steps;
  }

  const test::TemporaryFile file;
  for (std::size_t k = 0; k <= stops.size(); ++k) {
    auto sim = start();
    Curve curve;
    auto run = path.start(sim, curve);
    if (k > 0) read_checkpoint(file.path(), sim, run, curve);
    if (k < stops.size()) {
      while (sim.steps() < stops[k] && run.advance()) {
      }
      CHECK(run.view().stage_index == k);
      write_checkpoint(file.path(), sim, run, curve);
    } else {
      (void)run.run();
      CHECK(curve_csv(curve) == curve_csv(expected));
      CHECK(energy_csv(curve) == energy_csv(expected));
      CHECK(breakages_csv(curve) == breakages_csv(expected));
      CHECK(digest(fields_of(sim, "sim")) == digest(fields_of(whole, "sim")));
    }
  }
}
