// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/step_timer.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/same_run.hpp>

using namespace riprap;

namespace {

static_assert(hooks::times_phases<StepTimer>);
static_assert(!hooks::times_phases<EnergyLedger>);

constexpr std::size_t count = 300;  // two tasks

auto loose_sample() {
  Simulation sim{Model{}.integrator(VelocityVerlet{}), random_assembly({.count = count}), Rock{}};
  sim.boundary().set_rate(5, 5);
  return sim;
}

double seconds_between(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string printed(const StepTimer& timer) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file);
  timer.print(file);
  std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
  std::rewind(file);
  REQUIRE(std::fread(text.data(), 1, text.size(), file) == text.size());
  std::fclose(file);
  return text;
}

// Records the phases.
struct Phases {
  std::vector<StepPhase> parts;
  void on_phase_end(StepPhase part) { parts.push_back(part); }
};

}  // namespace

TEST_CASE("the time since the last phase belongs to the phase that is named") {
  const auto start = std::chrono::steady_clock::now();
  StepTimer timer;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  timer.on_phase_end(StepPhase::narrow_phase);
  CHECK(timer.seconds(StepPhase::narrow_phase) >= 0.02);
  CHECK(timer.seconds() == timer.seconds(StepPhase::narrow_phase));
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  timer.on_phase_end(StepPhase::other);
  CHECK(timer.seconds(StepPhase::other) >= 0.01);
  CHECK(timer.seconds() <= seconds_between(start));
}

TEST_CASE("the parts of a run add up to nearly all of its time") {
  Simulation sim = loose_sample();
  const auto start = std::chrono::steady_clock::now();
  StepTimer timer;
  for (int i = 0; i < 200; ++i) sim.step(timer);
  const double all = seconds_between(start);
  double sum = 0;
  for (std::size_t i = 0; i < step_phase_count; ++i) {
    const double part = timer.seconds(static_cast<StepPhase>(i));
    CHECK(part >= 0);
    sum += part;
  }
  CHECK(timer.seconds() == sum);
  CHECK(sum <= all);
  CHECK(sum >=
        0.5 * all);  // the end of the last step is in no phase; others may have the processor
  CHECK(timer.seconds(StepPhase::integration) > 0);
  CHECK(timer.seconds(StepPhase::contact_law) > 0);
  CHECK(timer.seconds(StepPhase::stress_check) > 0);
  CHECK(timer.particle_steps() == 200 * count);
}

TEST_CASE("the table has a line for every part, and for all") {
  StepTimer timer;
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  timer.on_phase_end(StepPhase::splitting);
  const std::string table = printed(timer);
  CHECK(std::ranges::count(table, '\n') == 2 + step_phase_count);
  CHECK(table.find("splitting             100.0 %") != std::string::npos);
  CHECK(table.find("integration             0.0 %") != std::string::npos);
  CHECK(printed(StepTimer{}).find("nan") == std::string::npos);
}

TEST_CASE("phases end in the order in which they run") {
  Simulation sim = loose_sample();
  Phases phases;
  sim.step(phases);
  REQUIRE(!phases.parts.empty());
  CHECK(phases.parts.front() == StepPhase::other);  // what was between the steps
  std::vector<StepPhase> first_times;
  for (const StepPhase part : phases.parts)
    if (part != StepPhase::other && std::ranges::count(first_times, part) == 0)
      first_times.push_back(part);
  CHECK(std::ranges::is_sorted(first_times));
  for (const StepPhase part :
       {StepPhase::integration, StepPhase::broad_phase, StepPhase::narrow_phase,
        StepPhase::contact_law, StepPhase::stress_check})
    CHECK(std::ranges::count(first_times, part) == 1);
  // The second kick.
  CHECK(std::ranges::count(phases.parts, StepPhase::integration) == 2);
}

TEST_CASE("to be timed changes no result") {
  Simulation timed = loose_sample();
  Simulation plain = loose_sample();
  StepTimer timer;
  for (int i = 0; i < 400; ++i) {
    timed.step(timer);
    plain.step();
  }
  const auto numbers = [](const auto& sim) {
    std::vector<double> all{sim.contacts().friction_loss(), sim.work().boundary,
                            sim.work().damping};
    for (const Body& b : sim.particles().bodies())
      for (const double x : {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(),
                             b.velocity.y(), b.angular_velocity, b.contact.moment})
        all.push_back(x);
    return all;
  };
  CHECK(plain.contacts().friction_loss() > 0);
  CHECK(test::same_bytes(numbers(timed), numbers(plain)));
}
