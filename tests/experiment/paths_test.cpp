// SPDX-License-Identifier: BSL-1.0
// The physics of the ready-made paths, on small samples.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/paths/cyclic_shear.hpp>
#include <riprap/experiment/paths/isotropic_compression.hpp>
#include <riprap/experiment/paths/oedometer.hpp>
#include <riprap/experiment/paths/shear.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <vector>

using namespace riprap;

namespace {

constexpr double pressure = 4e6;

// The last states of all stages of loading, and all states.
struct Loaded {
  Curve curve;
  std::vector<CurvePoint> ends;
  std::vector<StageResult> stages;
};

// Keeps the largest errors over all steps, not only at records.
struct Extremes {
  double volumetric_strain = 0;
  double lateral_strain = 0;
  std::size_t steps = 0;
  double mean_stress_sum = 0;

  bool stop_requested(const auto& view) {
    if (view.stage != Stage::loading) return false;
    volumetric_strain = std::max(volumetric_strain, std::abs(view.volumetric_strain()));
    lateral_strain = std::max(lateral_strain, std::abs(view.strain(1)));
    mean_stress_sum += view.stress().mean();
    ++steps;
    return false;
  }
};

Loaded run_on_sample(const std::vector<LoadingStage<>>& loading, Extremes& extremes) {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 60, .seed = 3}),
                 Rock{}};
  LoadingPath<> path{.confining_pressure = pressure, .stages = Preparation{}.stages(pressure)};
  path.append(loading);
  Loaded loaded;
  const PathResult result = path.run(sim, loaded.curve, extremes);
  CHECK(!result.interrupted);
  loaded.stages.assign(result.stages.begin() + 3, result.stages.end());
  for (const StageResult& stage : result.stages) CHECK(stage.reached_target);
  loaded.ends.resize(loading.size());
  for (const CurvePoint& p : loaded.curve.points()) loaded.ends.at(p.stage_index - 3) = p;
  return loaded;
}

}  // namespace

TEST_CASE("oedometer: no lateral strain, K0 below 1 in loading, and unloading gives back less") {
  Extremes extremes;
  const Loaded sample = run_on_sample(
      Oedometer{.vertical_stresses = {8e6, 16e6, 4e6, 16e6}}.stages(pressure), extremes);
  CHECK(extremes.lateral_strain == 0);
  const auto& ends = sample.ends;
  for (const std::size_t loaded : {0u, 1u, 3u}) {
    const double k0 = ends[loaded].stress.s11 / ends[loaded].stress.s22;
    CHECK(k0 > 0.2);
    CHECK(k0 < 1);
  }
  // Horizontal stress is locked in: K0 rises in unloading.
  CHECK(ends[2].stress.s11 / ends[2].stress.s22 > ends[1].stress.s11 / ends[1].stress.s22);
  // A stage ends with the first step beyond its limit; steps change the stress by far less than 2
  // %.
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(std::abs(ends[k].stress.s22 / std::vector{8e6, 16e6, 4e6, 16e6}[k] - 1) < 0.02);
  // Stiffer in unloading: to 4 MPa less strain comes back than 4 to 16 MPa took.
  CHECK(ends[0].axial_strain > 0);
  CHECK(ends[1].axial_strain > ends[0].axial_strain);
  const double taken = ends[1].axial_strain;
  const double returned = ends[1].axial_strain - ends[2].axial_strain;
  CHECK(returned > 0);
  CHECK(returned < taken);
}

TEST_CASE("isotropic compression: both stresses are held, and unloading gives back less") {
  Extremes extremes;
  const std::vector<double> pressures{8e6, 16e6, 4e6};
  const Loaded sample =
      run_on_sample(IsotropicCompression{.pressures = pressures}.stages(pressure), extremes);
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    CHECK(std::abs(sample.ends[k].stress.s11 / pressures[k] - 1) <= 0.01);
    CHECK(std::abs(sample.ends[k].stress.s22 / pressures[k] - 1) <= 0.01);
  }
  CHECK(sample.ends[1].volumetric_strain > sample.ends[0].volumetric_strain);
  CHECK(sample.ends[2].volumetric_strain > 0);
  CHECK(sample.ends[2].volumetric_strain < sample.ends[1].volumetric_strain);
}

TEST_CASE("constant volume shear: the area stays") {
  Extremes extremes;
  const Loaded sample = run_on_sample({constant_volume_shear({.axial_strain = 0.05})}, extremes);
  // Each step multiplies both lengths by factors whose product is 1 to 2^-53 twice or so.
  CHECK(extremes.volumetric_strain < 4e-16 * static_cast<double>(extremes.steps));
  CHECK(sample.ends[0].axial_strain >= 0.05);
  // This sample contracts in drained shear. Where it may not, the lateral stress falls: the fluid
  // takes it as pore pressure.
  const Loaded drained = run_on_sample({drained_shear(pressure, {.axial_strain = 0.05})}, extremes);
  CHECK(drained.ends[0].volumetric_strain > 0.01);
  CHECK(sample.ends[0].stress.s11 < 0.6 * pressure);
  CHECK(std::abs(drained.stages[0].mean_error) < 0.02);
}

TEST_CASE("constant mean stress shear: the mean stress stays, the ratio rises") {
  Extremes extremes;
  const Loaded sample =
      run_on_sample({constant_mean_stress_shear(pressure, {.axial_strain = 0.02})}, extremes);
  const double mean = extremes.mean_stress_sum / static_cast<double>(extremes.steps);
  CHECK(std::abs(mean / pressure - 1) < 0.02);
  CHECK(std::abs(sample.stages[0].mean_error) < 0.02);
  CHECK(sample.stages[0].rms_error < 0.08);
  CHECK(sample.ends[0].stress.s22 > 1.3 * sample.ends[0].stress.s11);
}

TEST_CASE("cyclic shear turns at its limits of strain") {
  Extremes extremes;
  const Loaded sample = run_on_sample(
      CyclicShear{.lower = -0.001, .upper = 0.002, .cycles = 2, .pressure = pressure}.stages(),
      extremes);
  REQUIRE(sample.ends.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const double beyond =
        k % 2 == 0 ? sample.ends[k].axial_strain - 0.002 : -0.001 - sample.ends[k].axial_strain;
    CHECK(beyond >= 0);
    CHECK(beyond < 1e-5);  // a step
  }
  // Friction takes energy in every half cycle.
  for (std::size_t k = 1; k < 4; ++k)
    CHECK(sample.ends[k].energy.slip > sample.ends[k - 1].energy.slip);
}

TEST_CASE("cyclic shear turns at its limits of stress") {
  Extremes extremes;
  const Loaded sample = run_on_sample(
      CyclicShear{.lower = 0, .upper = 2e6, .by_stress = true, .cycles = 2, .pressure = pressure}
          .stages(),
      extremes);
  for (std::size_t k = 0; k < 4; ++k) {
    const double difference = sample.ends[k].stress.s22 - sample.ends[k].stress.s11;
    if (k % 2 == 0)
      CHECK(difference >= 2e6);
    else
      CHECK(difference <= 0);
    CHECK(std::abs(difference - (k % 2 == 0 ? 2e6 : 0)) < 0.05 * pressure);
  }
}

TEST_CASE("bad limits are named") {
  CHECK_THROWS_WITH_AS((void)(CyclicShear{.lower = 1, .upper = 0}.stages()),
                       "CyclicShear.lower = 1: must be below upper", InvalidInput);
  CHECK_THROWS_WITH_AS((void)(Oedometer{.vertical_stresses = {-1}}.stages(1e6)),
                       "Oedometer.vertical_stresses = -1: must be a finite number above 0",
                       InvalidInput);
}
