// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <string>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <utility>
#include <vector>

using namespace riprap;
using test::near;

namespace {

using Unbreakable = Simulation<decltype(Model{}.criterion(NeverFails{}))>;

Unbreakable loose_sample() {
  return {Model{}.criterion(NeverFails{}), random_assembly({.count = 30, .seed = 2}), Rock{}};
}

// Axis 1 to and fro.
struct Vibration {
  double frequency = 100;   // [Hz]
  double amplitude = 1e-3;  // of the strain
  double begun_at = -1;     // state: sim.time() when the stage began [s]

  void begin(const auto& view, int /*axis*/) { begun_at = view.sim.time(); }
  double rate(const auto& view, int /*axis*/) const {
    const double omega = 2 * std::numbers::pi * frequency;
    return amplitude * omega * std::cos(omega * (view.sim.time() - begun_at));
  }
  static void for_each_parameter(auto& self, auto&& visit) {
    visit("frequency", self.frequency);
    visit("amplitude", self.amplitude);
  }
  static void for_each_field(auto& self, auto&& visit) { visit("begun_at", self.begun_at); }
};

// Ends when axis 1 has shortened in a number of steps.
struct Shortened {
  std::uint64_t steps = 20;
  std::uint64_t count = 0;  // state

  void begin(const auto& /*view*/) { count = 0; }
  bool reached(const auto& view) {
    count += view.rate.x() > 0;
    return count >= steps;
  }
  static void for_each_parameter(auto& self, auto&& visit) { visit("steps", self.steps); }
  static void for_each_field(auto& self, auto&& visit) { visit("count", self.count); }
};

using OwnStage = LoadingStage<AxisControlOr<Vibration>, EndConditionOr<Shortened>>;

// What the hooks of a path say.
struct Log {
  std::vector<std::string> names;
  std::vector<std::uint64_t> steps;  // of the stage at each record
  std::vector<double> strains;       // along axis 2 at each record
  void begin_stage(const auto& view) { names.emplace_back(view.name()); }
  void record(const auto& view) {
    steps.push_back(view.stage_steps);
    strains.push_back(view.axial_strain());
  }
};

// Whether particles may break, and rub.
struct Switches {
  std::vector<bool> breakage{};
  std::vector<double> friction{};
  void progress(const auto& view) {
    breakage.push_back(view.sim.breakage());
    friction.push_back(view.sim.contacts().law().friction);
  }
};

LoadingStage<> straining(double rate, EndCondition end) {
  return {.name = "straining",
          .axis_2 = EngineeringRate{.rate_of_strain = {.per_second = rate}, .smooth = false},
          .end = std::move(end)};
}

}  // namespace

TEST_CASE("stages follow each other; strains count from the first, states are recorded once") {
  Unbreakable sim = loose_sample();
  const double dt = sim.time_step();
  LoadingPath<> path;
  path.stages = {straining(1, StepsMade{.steps = 100}), straining(-1, StepsMade{.steps = 40}),
                 straining(1, StrainReached{.strain = 10.5 * dt})};
  path.stages[1].name = "back";
  path.stages[0].record_every = 0;
  path.stages[0].record_every_steps = 50;
  path.stages[1].record_every = 30.5 * dt;
  path.stages[2].zero_strain = true;
  Log log;
  const PathResult result = path.run(sim, log);
  CHECK(log.names == std::vector<std::string>{"straining", "back", "straining"});
  CHECK(log.steps == std::vector<std::uint64_t>{0, 50, 100, 31, 40, 11});
  const std::vector<double> strains{0, 50 * dt, 100 * dt, 69 * dt, 60 * dt, 11 * dt};
  REQUIRE(log.strains.size() == strains.size());
  // Round-off of steps.
  for (std::size_t k = 0; k < strains.size(); ++k) CHECK(log.strains[k] == near(strains[k], 1e-13));
  for (const StageResult& stage : result.stages) CHECK(stage.reached_target);
}

TEST_CASE("a stage at its cap has missed its target, or is an error") {
  Unbreakable sim = loose_sample();
  LoadingPath<> path;
  path.stages = {straining(1e-3, StrainReached{.strain = 0.5}),
                 straining(1e-3, StepsMade{.steps = 2})};
  path.stages[0].most_steps = 10;
  const PathResult result = path.run(sim);
  CHECK(!result.stages[0].reached_target);
  CHECK(result.stages[0].steps == 10);
  CHECK(result.stages[1].reached_target);
  path.stages[0].at_cap = AtCap::error;
  path.stages[0].friction = false;
  const double friction = sim.contact_law().friction;
  CHECK_THROWS_WITH_AS(path.run(sim),
                       "straining did not reach its end within 10 steps: mean stress 0 Pa",
                       SimulationError);
  CHECK(sim.contact_law().friction == friction);
}

TEST_CASE("a constant rate that leads away from the strain that ends its stage is refused") {
  Unbreakable sim = loose_sample();
  const auto run = [&](const LoadingStage<>& stage) {
    LoadingPath<> path;
    path.stages = {straining(2, StepsMade{.steps = 1}), stage};
    path.stages[1].zero_strain = true;
    return path.run(sim);
  };
  const StrainReached shortened{.strain = 1e-7};
  CHECK_THROWS_WITH_AS(run(straining(-2, shortened)),
                       "stage 'straining': rate of strain of axis_2 = -2: must lead from the "
                       "strain 0 to 1e-07, which ends the stage",
                       InvalidInput);
  // By an inertial number, and to a strain of the axis that stands still.
  LoadingStage<> stage = straining(2, StrainReached{.strain = -0.5, .of = StrainOf::axis_1});
  CHECK_THROWS_WITH_AS(run(stage),
                       "stage 'straining': rate of strain of axis_1 = 0: must lead from the "
                       "strain 0 to -0.5, which ends the stage",
                       InvalidInput);
  stage.axis_1 = LogarithmicRate{.rate_of_strain = {.inertial_number = 1e-3}};
  CHECK_THROWS_AS(run(stage), InvalidInput);
  // A cap that is an error ends nothing, one of the stage's own after which the path goes on does.
  stage = straining(-2, shortened);
  stage.most_steps = 3;
  CHECK(run(stage).stages[1].steps == 3);
  stage.at_cap = AtCap::error;
  CHECK_THROWS_AS(run(stage), InvalidInput);

  // One part that can end it is enough for "any", one that cannot too much for "all".
  using Any = AnyOf<SingleEndOr<>>;
  using All = AllOf<SingleEndOr<>>;
  const StepsMade steps{.steps = 3};
  CHECK(run(straining(-2, Any{{{shortened, steps}}})).stages[1].steps == 3);
  CHECK_THROWS_AS(run(straining(-2, Any{{{shortened, shortened}}})), InvalidInput);
  CHECK_THROWS_AS(run(straining(-2, All{{{shortened, steps}}})), InvalidInput);
  // A strain of volume, and one that is there at the start.
  CHECK(run(straining(-2, StrainReached{.strain = 0})).stages[1].reached_target);
  stage = straining(-2, StrainReached{.strain = 1e-7, .of = StrainOf::volume});
  stage.axis_1 = EngineeringRate{.rate_of_strain = {.per_second = 4}, .smooth = false};
  CHECK(run(stage).stages[1].reached_target);
}

TEST_CASE("the stage is judged from the strain at which it begins") {
  Unbreakable sim = loose_sample();
  LoadingPath<> path;
  path.stages = {straining(2, StrainReached{.strain = 2e-6}),
                 straining(-2, StrainReached{.strain = 1e-6})};
  CHECK(path.run(sim).stages[1].reached_target);
  path.stages[1] = straining(2, StrainReached{.strain = 1e-6});
  CHECK_THROWS_AS(path.run(sim), InvalidInput);
}

TEST_CASE("a cell or a boundary that is driven to no area says the stage and the axis") {
  // In parts of its length a step.
  const auto text_of = [](auto&& sim, int axis, double rate) {
    LoadingPath<> path;
    path.stages = {straining(rate / sim.time_step(), StepsMade{.steps = 100})};
    if (axis == 1) std::swap(path.stages[0].axis_1, path.stages[0].axis_2);
    try {
      path.run(sim);
    } catch (const SimulationError& error) {
      return std::string(error.what());
    }
    return std::string{};
  };
  CHECK(text_of(loose_sample(), 2, 1.25)
            .starts_with("stage 'straining': axis_2 has no length left at strain 0: its rate is "));
  // A particle that no image comes near; two such steps are more than the whole length.
  const auto cell = [] {
    return Simulation{Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}),
                      {.particles = {{test::rectangle({0, 0}, 1e-3, 1e-3)}}, .period = {1, 1}},
                      Rock{}};
  };
  CHECK(text_of(cell(), 1, 0.625)
            .starts_with("stage 'straining': axis_1 has no length left at strain 0.625: "));
  CHECK(text_of(cell(), 2, 0.625)
            .starts_with("stage 'straining': axis_2 has no length left at strain 0.625: "));
}

TEST_CASE("breakage and friction are off where a stage says so, and back afterwards") {
  Unbreakable sim = loose_sample();
  const double friction = sim.contact_law().friction;
  LoadingPath<> path;
  path.stages.assign(3, straining(1e-3, StepsMade{.steps = 128}));
  path.stages[1].breakage = false;
  path.stages[1].friction = false;
  Switches witness;
  path.run(sim, witness);
  CHECK(witness.breakage == std::vector<bool>{true, false, true});
  CHECK(witness.friction == std::vector<double>{friction, 0, friction});
}

TEST_CASE("a program's own control and condition run, and stop and go on") {
  const auto sample_path = [] {
    LoadingPath<OwnStage> path;
    const EndCondition ten_steps =
        AnyOf<SingleEndOr<>>{{.parts = {StepsMade{.steps = 10}, StrainReached{.strain = 0.5}}}};
    path.append(std::vector<LoadingStage<>>{straining(1, ten_steps)});
    path.stages.push_back(
        {.name = "vibration", .axis_1 = Vibration{}, .end = Shortened{.steps = 20}});
    return path;
  }();
  Unbreakable at_once = loose_sample();
  Curve expected;
  const PathResult result = sample_path.run(at_once, expected);
  CHECK(result.stages[0].steps == 10);
  CHECK(result.stages[1].reached_target);
  CHECK(result.stages[1].steps == 20);

  Unbreakable sim = loose_sample();
  Curve curve;
  FieldNode fields;
  {
    auto run = sample_path.start(sim, curve);
    for (int n = 0; n < 15; ++n) REQUIRE(run.advance());
    fields = fields_of(run, "run");
    CHECK(fields.child("controls_1").child("axis_1").child("begun_at").rows == 1);
  }
  auto run = sample_path.start(sim, curve);
  read_fields(fields, run);
  run.restored();
  CHECK(run.run().stages[1].steps == result.stages[1].steps);
  CHECK(curve_csv(curve) == curve_csv(expected));
}

TEST_CASE("a call is a condition, too") {
  const auto ended = [](const auto& view) { return view.stage_steps == 5; };
  using Stage = LoadingStage<AxisControl, EndConditionOr<decltype(ended)>>;
  Unbreakable sim = loose_sample();
  LoadingPath<Stage> path;
  path.stages.push_back({.name = "five", .end = ended});
  CHECK(path.run(sim).stages[0].steps == 5);
}

TEST_CASE("bad paths are named") {
  Unbreakable sim = loose_sample();
  LoadingPath<> path;
  path.stages = {straining(1, StepsMade{.steps = 1})};
  path.stages[0].axis_1 = ConstantVolume{};
  path.stages[0].axis_2 = ConstantVolume{};
  CHECK_THROWS_WITH_AS(path.run(sim),
                       "stage 'straining': axis_2 = 2: both axes would follow each other",
                       InvalidInput);
  path.stages[0].axis_1 = EngineeringRate{};
  CHECK_THROWS_WITH_AS(path.run(sim),
                       "stage 'straining': axis_1.inertial_number = 0: must be other than 0, or "
                       "per_second must, and not both",
                       InvalidInput);
  path.confining_pressure = 0;
  CHECK_THROWS_WITH_AS(path.run(sim),
                       "LoadingPath.confining_pressure = 0: must be a finite number above 0",
                       InvalidInput);
}

TEST_CASE("an error of a step says in which stage") {
  Unbreakable sim = loose_sample();
  LoadingPath<> path;
  // Away from the target: particles are pressed into each other.
  path.stages = {straining(1, StressReached{.stress = -1e6})};
  path.stages[0].axis_1 = EngineeringRate{.rate_of_strain = {.per_second = 1000}};
  path.stages[0].axis_2 = EngineeringRate{.rate_of_strain = {.per_second = 1000}};
  std::string message;
  try {
    (void)path.run(sim);
  } catch (const SimulationError& error) {
    message = error.what();
  }
  CHECK(message.starts_with("stage 'straining': particle "));
}

TEST_CASE("a stage says by how much a held stress missed its target in the end") {
  Unbreakable sim = loose_sample();
  LoadingPath<> path;
  // Tension, which loose particles never have: the servo takes the boundary away from them.
  path.stages = {straining(1, StressReached{.stress = -1e6, .of = StressOf::axis_1})};
  path.stages[0].axis_1 = ControlledStress{
      .stress = -1e6, .control = {.expected_rate = {.per_second = 1}, .largest_rate = 1}};
  path.stages[0].most_steps = 200;
  const StageResult missed = path.run(sim).stages[0];
  CHECK(missed.steps == 200);
  CHECK_FALSE(missed.reached_target);
  CHECK(missed.last_error == -1);
  CHECK(missed.mean_error == 0);  // not judged

  path.stages[0].axis_1 = FreeBoundary{.control = {.expected_rate = {.per_second = 1}}};
  CHECK(path.run(sim).stages[0].last_error == 0);
}

TEST_CASE("a path without stages is refused") {
  Unbreakable sim = loose_sample();
  CHECK_THROWS_WITH_AS(LoadingPath<>{}.run(sim),
                       "LoadingPath.stages: number of stages = 0: must be above 0", InvalidInput);
  CHECK(sim.steps() == 0);
}
