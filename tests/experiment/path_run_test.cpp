// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstdint>
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <string>
#include <vector>

using namespace riprap;

namespace {

using Sim = Simulation<Model<>>;

Sim small_sample() { return {Model{}, random_assembly({.count = 40, .seed = 1}), Rock{}}; }

constexpr BiaxialTest short_test{
    .confining_pressure = 16e6, .axial_strain = 0.004, .record_every = 0.0005};

std::string tables(const Curve& curve) {
  return curve_csv(curve) + energy_csv(curve) + breakages_csv(curve);
}

// What a test leaves but for the time that it took.
std::string text_of(const BiaxialResult& result) {
  std::string text;
  for (const StageResult& s : result.stages)
    for (const double number :
         {static_cast<double>(s.steps), static_cast<double>(s.saturated_steps),
          static_cast<double>(s.reached_target), s.mean_error, s.rms_error, s.last_error})
      text += to_text(number) + " ";
  return text + to_text(result.axial_rate) + (result.interrupted ? " interrupted" : "");
}

}  // namespace

TEST_CASE("a test made step by step is the test at once") {
  Sim at_once = small_sample();
  Curve expected;
  const BiaxialResult result = short_test.run(at_once, expected);

  Sim sim = small_sample();
  Curve curve;
  auto run = short_test.start(sim, curve);
  std::uint64_t steps = 0;
  CHECK(!run.finished());
  for (bool more = true; more; ++steps) more = run.advance();
  CHECK(run.finished());
  CHECK(!run.advance());
  CHECK(steps == sim.steps());
  CHECK(text_of(run.result()) == text_of(result));
  CHECK(tables(curve) == tables(expected));
}

TEST_CASE("a run whose fields are put into another run goes on to the same bytes") {
  Sim uninterrupted = small_sample();
  Curve expected;
  const BiaxialResult result = short_test.run(uninterrupted, expected);
  // The middle of every stage, its first and its last step.
  std::vector<std::uint64_t> stops;
  std::uint64_t begun = 0;
  for (const StageResult& stage : result.stages) {
    for (const std::uint64_t step : {std::uint64_t{1}, stage.steps / 2, stage.steps})
      stops.push_back(begun + step);
    begun += stage.steps;
  }
  stops.pop_back();  // the end

  Sim sim = small_sample();
  Curve curve;
  const double friction = sim.contact_law().friction;
  FieldNode fields = fields_of(short_test.start(sim, curve), "run");
  for (const std::uint64_t stop : stops) {
    {
      auto run = short_test.start(sim, curve);
      read_fields(fields, run);
      run.restored();
      while (sim.steps() < stop) REQUIRE(run.advance());
      fields = fields_of(run, "run");
    }
    // The run has gone, and has given law and breakage back.
    CHECK(sim.contact_law().friction == friction);
    CHECK(sim.breakage());
  }
  auto run = short_test.start(sim, curve);
  read_fields(fields, run);
  run.restored();
  CHECK(text_of(run.run()) == text_of(result));
  CHECK(tables(curve) == tables(expected));
}

TEST_CASE("a run that goes on counts the time of its first part") {
  Sim sim = small_sample();
  FieldNode fields;
  double first_part = 0;
  {
    auto run = short_test.start(sim);
    for (int i = 0; i < 1000; ++i) REQUIRE(run.advance());
    first_part = run.result().stages[0].wall_seconds;
    CHECK(first_part > 0);
    fields = fields_of(run, "run");
  }
  auto run = short_test.start(sim);
  read_fields(fields, run);
  run.restored();
  for (int i = 0; i < 1000; ++i) REQUIRE(run.advance());
  CHECK(run.result().stages[0].wall_seconds > first_part);
}

TEST_CASE(
    "a run that ends early gives breakage and friction back, one that has not begun nothing") {
  Sim sim = small_sample();
  const double friction = sim.contact_law().friction;
  {
    auto run = short_test.start(sim);
    REQUIRE(run.advance());
    CHECK(sim.contact_law().friction == 0);
    CHECK(!sim.breakage());
  }
  CHECK(sim.contact_law().friction == friction);
  CHECK(sim.breakage());
  {
    const auto run = short_test.start(sim);
    sim.set_breakage(false);
  }
  CHECK(!sim.breakage());
}
