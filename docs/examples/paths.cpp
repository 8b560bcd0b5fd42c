// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <numbers>
#include <vector>

#include <riprap/experiment/paths/oedometer.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/experiment/read_path.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

// An oedometer test, stage by stage.
LoadingPath<> oedometer() {
  const LoadingRate rate{.inertial_number = 1e-3};
  const auto to = [&](const char* name, double stress, const LoadingRate& along_axis_2) {
    return LoadingStage<>{.name = name,
                          .axis_1 = Fixed{},
                          .axis_2 = EngineeringRate{.rate_of_strain = along_axis_2},
                          .end = StressReached{.stress = stress, .of = StressOf::axis_2},
                          .record_every = 0.001};
  };
  LoadingPath<> path{.confining_pressure = 2.0_MPa, .stages = Preparation{}.stages(2.0_MPa)};
  return path.append(std::vector{to("loading", 8.0_MPa, rate), to("unloading 1", 4.0_MPa, -rate),
                                 to("unloading 2", 2.0_MPa, -rate),
                                 to("unloading 3", 1.0_MPa, -rate)});
}

// A control of one's own: axis 1 goes to and fro.
struct Vibration {
  static constexpr const char* name = "vibration";  // in files
  double frequency = 100;                           // [Hz]
  double amplitude = 1e-4;                          // of the strain

  double rate(const auto& view, int /*axis*/) const {
    const double omega = 2 * std::numbers::pi * frequency;
    return amplitude * omega * std::cos(omega * view.stage_time());
  }
  static void for_each_parameter(auto& self, auto&& visit) {
    visit("frequency", self.frequency);
    visit("amplitude", self.amplitude);
  }
  static void for_each_field(auto& /*self*/, auto&& /*visit*/) {}  // it keeps no state
};

// An end condition of one's own: so many breakages in the stage.
struct Breakages {
  static constexpr const char* name = "breakages";
  std::size_t number = 1;
  std::size_t before = 0;  // state

  void begin(const auto& view) { before = view.sim.breaks().size(); }
  bool reached(const auto& view) const { return view.sim.breaks().size() >= before + number; }
  static void for_each_parameter(auto& self, auto&& visit) { visit("number", self.number); }
  static void for_each_field(auto& self, auto&& visit) { visit("before", self.before); }
};

int main(int argc, char** argv) try {
  Simulation sim{Model{}, random_assembly({.count = 40, .seed = 2}), Rock{}};
  Curve curve;
  const LoadingPath<> path = argc > 1 ? read_path(argv[1]) : oedometer();
  const PathResult result = path.run(sim, curve);
  for (const CurvePoint& p : curve.points())
    std::printf("stage %zu: strain %.4f, %.2f MPa, K0 %.2f\n", p.stage_index, p.axial_strain,
                p.stress.s22 / 1e6, p.stress.s11 / p.stress.s22);

  // Ready-made stages and others in one path, step by step.
  using OwnStage = LoadingStage<AxisControlOr<Vibration>, EndConditionOr<Breakages>>;
  LoadingPath<OwnStage> shaken;
  shaken.append(Oedometer{.vertical_stresses = {2.0_MPa}}.stages(1.0_MPa));
  shaken.stages.push_back(
      {.name = "shaking",
       .axis_1 = Vibration{},
       .axis_2 = ControlledStress{.stress = 2.0_MPa},
       .end = AnyOf<SingleEndOr<Breakages>>{{.parts = {Breakages{}, StepsMade{.steps = 2000}}}}});
  auto run = shaken.start(sim);
  while (run.advance())
    if (run.view().at_check && run.view().stage_steps % 1024 == 0)
      std::printf("%s: %.0f %%\n", run.view().stage_name.data(), 100 * run.view().done);

  return result.stages.back().reached_target && run.finished() ? 0 : 1;
} catch (const std::exception& error) {  // InvalidInput or SimulationError
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
