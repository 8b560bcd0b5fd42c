// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include <riprap/checkpoint/checkpoint.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/wall_servo.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/rectangle.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;
using test::rectangle;

namespace {

// Runs `whole`; another to each stop, through a file to a third one, and on: the same bytes.
template <class Start>
void check_restarts(const Start& start, std::uint64_t last) {
  auto whole = start();
  while (whole.sim.steps() < last) whole.step();
  const auto state_of = [](const auto& run) {
    return digest(internal::checkpoint_fields(run.sim, run.parts));
  };
  const test::TemporaryFile file;
  for (const std::uint64_t stop : {last / 7, last / 3, last / 2, 4 * last / 5}) {
    CAPTURE(stop);
    auto first = start();
    while (first.sim.steps() < stop) first.step();
    write_checkpoint(file.path(), first.sim, first.parts);
    auto second = start();
    read_checkpoint(file.path(), second.sim, second.parts);
    while (second.sim.steps() < last) second.step();
    CHECK(state_of(second) == state_of(whole));
  }
}

auto weak_model() {
  return Model{}.criterion(HoekBrown{.compressive_strength = 3e6}).check_every(20);
}

// Two particles between rough walls, with gravity; a servo presses the lid, which slides. A third
// one is added, pushed by a load, and taken away.
struct Walls {
  using Sim = Simulation<decltype(weak_model().boundary(NoBoundary{}))>;
  struct Parts {
    EnergyLedger ledger{};
    WallServo servo;
    ParticleId added = 0;

    static void for_each_field(auto& self, auto&& visit) {
      visit("ledger", self.ledger);
      visit("servo", self.servo);
      visit("added", self.added);
    }
  };

  Walls()
      : sim{weak_model().boundary(NoBoundary{}),
            {.thickness = 0.016,
             .particles = {{rectangle({0, -0.01}, 0.2, 0.02), Motion::wall},
                           {rectangle({0, 0.0262}, 0.2, 0.02), Motion::wall},
                           {rectangle({-0.02, 0.008}, 0.016, 0.016)},
                           {rectangle({0.01, 0.0075}, 0.016, 0.015)}}},
            Rock{}},
        parts{.servo = WallServo(1, {0, -1}, 3e3, 2e7, 200 * sim.time_step(), 0.5)} {
    sim.set_body_force({0, -9.81});
    parts.ledger.open(sim);
  }
  void step() {
    if (sim.steps() == 700) {
      parts.added = sim.add(rectangle({0.05, 0.0065}, 0.012, 0.012));
      sim.set_load(parts.added, {-20, -5}, 0.01);
    }
    if (sim.steps() == 2200 && sim.particles().find(parts.added)) sim.remove(parts.added);
    parts.servo(sim);
    sim.step(parts.ledger);
  }

  Sim sim;
  Parts parts;
};

// A periodic cell that is pressed and sheared.
struct SimpleShear {
  using Sim = Simulation<decltype(weak_model().boundary(PeriodicCell{}))>;
  SimpleShear()
      : sim{weak_model().boundary(PeriodicCell{}),
            random_periodic_assembly({.count = 40, .seed = 4}), Rock{}} {
    parts.open(sim);
  }
  void step() {
    sim.boundary().set_rate(20, 20);
    sim.boundary().set_shear_rate(40);
    sim.step(parts);
  }

  Sim sim;
  EnergyLedger parts{};
};

}  // namespace

TEST_CASE("walls, a servo, loads and bodies that come and go are the same after a restart") {
  Walls walls;
  while (walls.sim.steps() < 3000) walls.step();
  CHECK(walls.sim.contacts().friction_loss() > 0);
  CHECK(walls.sim.work().added != 0);
  CHECK(walls.sim.work().load != 0);
  CHECK(walls.sim.force_on(1).force.y() > 0);
  check_restarts([] { return Walls{}; }, 3000);
}

TEST_CASE("a sheared periodic cell is the same after a restart") {
  SimpleShear shear;
  while (shear.sim.breaks().size() < 3) shear.step();
  CHECK(shear.sim.boundary().domain().shear_offset > 0);
  check_restarts([] { return SimpleShear{}; }, shear.sim.steps() + 100);
}
