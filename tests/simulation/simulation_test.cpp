// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/time_step/fixed_time_step.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <string>
#include <support/crushing.hpp>
#include <support/near.hpp>
#include <vector>

using namespace riprap;
using test::near_relative;

namespace {

// Platens at 0.2 m/s reach the breaking load of a few kN within some thousand steps.
constexpr double platen_speed = 0.2;
constexpr int most_steps = 20000;

auto crushing_model() { return Model{}.boundary(NoBoundary{}); }

template <class Sim, class... Observers>
void crush(Sim& sim, Observers&... observers) {
  for (int i = 0; i < most_steps && sim.breaks().empty(); ++i) sim.step(observers...);
}

struct Momentum {
  double mass = 0;
  Vec2 linear{0, 0};
  double angular = 0;
  double kinetic = 0;  // with true masses

  static Momentum of(const Particles& particles) {
    Momentum m;
    for (const Body& body : particles.bodies()) {
      if (!body.is_free()) continue;
      m.mass += body.mass;
      m.linear += body.mass * body.velocity;
      m.angular +=
          body.mass * cross(body.position, body.velocity) + body.inertia * body.angular_velocity;
      m.kinetic += 0.5 * body.mass * body.velocity.squaredNorm() +
                   0.5 * body.inertia * body.angular_velocity * body.angular_velocity;
    }
    return m;
  }
};

struct AroundSplits {
  Momentum before;
  Momentum after;
  std::vector<std::string> calls;
  template <class Sim>
  void before_forces(const Sim&) {
    if (calls.size() < 4) calls.emplace_back("before_forces");
  }
  template <class Sim>
  void after_forces(const Sim&) {
    if (calls.size() < 4) calls.emplace_back("after_forces");
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    before = Momentum::of(sim.particles());
    calls.emplace_back("before_splits");
  }
  template <class Sim>
  void on_break(const Sim&, const BreakEvent&) {
    calls.emplace_back("on_break");
  }
  template <class Sim>
  void after_splits(const Sim& sim) {
    after = Momentum::of(sim.particles());
    calls.emplace_back("after_splits");
  }
};

// A user's splitter that refuses everything and counts its calls.
struct CountingRefusal {
  int* asked;
  std::optional<CutRings> operator()(Ring, const Line&, double) const {
    ++*asked;
    return std::nullopt;
  }
};

}  // namespace

TEST_CASE("a square crushed between platens splits along the loading axis") {
  Simulation sim{crushing_model(), test::square_between_platens(platen_speed), Rock{}};
  AroundSplits around;
  crush(sim, around);
  REQUIRE(sim.breaks().size() == 1);
  const BreakEvent& event = sim.breaks()[0];

  // Diametral loading: the crack joins the loads. The mesh has elements of a tenth of the side, so
  // the line may lean and shift by about one of them over the height.
  CHECK(std::abs(event.line.direction.y()) > std::cos(0.2));
  CHECK(std::abs(event.line.left_distance(Vec2{0, 0})) < 0.0016);
  // From side to side of 16 mm, as steep as the line is at least.
  CHECK(event.crack_length >= 0.016 * (1 - 1e-9));
  CHECK(event.crack_length < 0.016 / std::cos(0.2));
  CHECK(event.failures.ratio() >= 0.4);
  // At most 0.07 is known to be gained in a step; the platens move slowly.
  CHECK(event.failures.ratio() < 0.47);
  CHECK(event.failures.lowest_safety_factor < 1);
  CHECK(event.mode != FailureMode::intact);

  SUBCASE("the pieces have new names and the parent's ancestry") {
    REQUIRE(sim.particles().size() == 4);
    CHECK(event.particle.id == 0);
    CHECK(event.particle.parent == no_particle);
    CHECK(event.pieces[0] == 3);
    CHECK(event.pieces[1] == 4);
    for (const BodyIndex i : {0u, 3u}) {
      CHECK(sim.particles().ancestry(i).parent == 0);
      CHECK(sim.particles().ancestry(i).root == 0);
      CHECK(sim.particles().ancestry(i).generation == 1);
      CHECK(sim.particles().body(i).is_free());
    }
  }
  SUBCASE("area, mass, momentum, angular momentum and kinetic energy are kept") {
    // Sums of a few terms: some units in the last place, against the scale of the motion.
    CHECK(event.areas[0] + event.areas[1] == near_relative(0.016 * 0.016, 1e-13));
    const double speed = platen_speed;
    const Momentum& p = around.before;
    const Momentum& q = around.after;
    CHECK(q.mass == near_relative(p.mass, 1e-13));
    CHECK((q.linear - p.linear).norm() <= 1e-13 * p.mass * speed);
    CHECK(std::abs(q.angular - p.angular) <= 1e-13 * p.mass * speed * 0.016);
    CHECK(std::abs(q.kinetic - p.kinetic) <= 1e-12 * p.mass * speed * speed);
  }
  SUBCASE("observers are called in the order of the step") {
    const std::vector<std::string> start(around.calls.begin(), around.calls.begin() + 4);
    CHECK(start == std::vector<std::string>{"before_forces", "after_forces", "before_forces",
                                            "after_forces"});
    const std::vector<std::string> end(around.calls.end() - 3, around.calls.end());
    CHECK(end == std::vector<std::string>{"before_splits", "after_splits", "on_break"});
  }
  SUBCASE("the pieces carry the load on: no force from nothing") {
    // Two pieces under the same platens: the sum of their loads is the parent's to within what the
    // cut takes away, and the next steps do not throw them about.
    for (int i = 0; i < 100; ++i) sim.step();
    for (const BodyIndex i : {0u, 3u}) CHECK(sim.particles().body(i).velocity.norm() < 20);
  }
}

TEST_CASE("breakage can be switched off, and comes back where it was left") {
  Simulation sim{crushing_model(), test::square_between_platens(platen_speed), Rock{}};
  sim.set_breakage(false);
  Simulation twin{crushing_model(), test::square_between_platens(platen_speed), Rock{}};
  crush(twin);
  while (sim.steps() < twin.steps()) sim.step();
  CHECK(sim.breaks().empty());
  CHECK(sim.failed_ratios()[0] >= 0.4);
  sim.set_breakage(true);
  sim.step();
  CHECK(sim.breaks().size() == 1);
}

TEST_CASE("the stress check of every step does not move anything") {
  // Bit for bit the same poses with a check that never breaks and with no check at all.
  const auto poses = [](auto model) {
    Simulation sim{model, test::square_between_platens(platen_speed), Rock{}};
    for (int i = 0; i < 2000; ++i) sim.step();
    return sim.particles().body(0).position;
  };
  const Vec2 checked = poses(crushing_model().trigger(FailedElementRatio{1.1}));
  const Vec2 unchecked = poses(crushing_model().criterion(NeverFails{}));
  CHECK(checked.x() == unchecked.x());
  CHECK(checked.y() == unchecked.y());
}

TEST_CASE("checks fall on multiples of check_every") {
  Simulation every{crushing_model(), test::square_between_platens(platen_speed), Rock{}};
  crush(every);
  Simulation seldom{crushing_model().check_every(50), test::square_between_platens(platen_speed),
                    Rock{}};
  crush(seldom);
  REQUIRE(seldom.breaks().size() == 1);
  CHECK(seldom.breaks()[0].step % 50 == 0);
  CHECK(seldom.breaks()[0].step >= every.breaks()[0].step);
  CHECK(seldom.breaks()[0].step < every.breaks()[0].step + 50);
}

TEST_CASE("a particle of twice the strength breaks under twice the load") {
  // The platens approach at constant speed and chord contacts are linear: load grows with depth.
  struct TwiceAsStrong : FailedElementRatio {
    double factor = 1;
    double strength_factor(ParticleId, double) const { return factor; }
  };
  const auto depth_at_break = [](double factor) {
    TwiceAsStrong trigger;
    trigger.factor = factor;
    const auto model = crushing_model()
                           .narrow_phase(OverlapChord{})
                           .contact_law(LinearSpringCoulomb{})
                           .time_step(MassFloor{.fraction = 0.12})
                           .trigger(trigger);
    Simulation sim{model, test::square_between_platens(platen_speed), Rock{}};
    crush(sim);
    REQUIRE(sim.breaks().size() == 1);
    return platen_speed * sim.time();
  };
  // Loaded from both sides alike the particle rests; a check per step, some 1300 of them.
  CHECK(depth_at_break(2) / depth_at_break(1) == near_relative(2, 1e-3));
}

TEST_CASE("a refused cut is not tried again while the contact partners stay the same") {
  int asked = 0;
  Simulation sim{crushing_model().splitter(CountingRefusal{&asked}),
                 test::square_between_platens(platen_speed), Rock{}};
  for (int i = 0; i < most_steps && asked == 0; ++i) sim.step();
  REQUIRE(asked == 1);
  for (int i = 0; i < 200; ++i) sim.step();
  CHECK(asked == 1);
  CHECK(sim.breaks().empty());
  // A platen is taken away: one partner fewer, the load is gone, nothing to ask.
  sim.set_velocity(1, Vec2{0, 50});
  for (int i = 0; i < 200; ++i) sim.step();
  sim.set_velocity(1, Vec2{0, -50});
  for (int i = 0; i < 400 && asked == 1; ++i) sim.step();
  CHECK(asked >= 2);
}

TEST_CASE("pieces lighter than the smallest intact particle move with its mass") {
  Simulation sim{crushing_model(), test::square_between_platens(platen_speed), Rock{}};
  crush(sim);
  REQUIRE(sim.breaks().size() == 1);
  for (const BodyIndex i : {0u, 3u}) {
    const Body& piece = sim.particles().body(i);
    CHECK(piece.mass_scaling * piece.mass == near_relative(sim.smallest_mass(), 1e-14));
    CHECK(piece.mass < sim.smallest_mass());
  }
}

TEST_CASE("the time step follows from the lightest free particle and the contact stiffness") {
  Simulation sim{crushing_model(), test::square_between_platens(0), Rock{}};
  const double mass = 2500 * 0.016 * 0.016 * 0.016;
  CHECK(sim.smallest_mass() == near_relative(mass, 1e-12));
  CHECK(sim.time_step() == near_relative(0.24 * std::sqrt(mass / 4e7), 1e-12));
}

TEST_CASE("two runs give the same bytes") {
  const auto run = [] {
    Simulation sim{Model{}, random_assembly({.count = 60, .seed = 5}), Rock{}};
    sim.boundary().set_rate(40, 40);
    for (int i = 0; i < 5000; ++i) sim.step();
    std::vector<double> state;
    for (const Body& b : sim.particles().bodies())
      for (double v : {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(),
                       b.angular_velocity, b.contact.moment})
        state.push_back(v);
    return state;
  };
  const std::vector<double> first = run();
  const std::vector<double> second = run();
  REQUIRE(first.size() == second.size());
  CHECK(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)) == 0);
}

TEST_CASE("a simulation that diverges is an error that names the particle") {
  Simulation sim{crushing_model(), test::square_between_platens(0), Rock{}};
  sim.set_velocity(0, Vec2{1e300, 0});
  try {
    sim.step();
    FAIL("no error");
  } catch (const SimulationError& error) {
    CHECK(std::string(error.what()).find("particle 0") != std::string::npos);
  }
}

TEST_CASE("bad input is refused before anything is computed") {
  CHECK_THROWS_WITH_AS((Simulation{Model{}, Assembly{}, Rock{}}), "Assembly.particles is empty",
                       InvalidInput);
  CHECK_THROWS_WITH_AS((Simulation{Model{}, test::square_between_platens(0), Rock{.poisson = 0.5}}),
                       "Rock.poisson = 0.5: must lie in [0, 0.5)", InvalidInput);
  Assembly fast = test::square_between_platens(0);
  fast.particles[2].velocity.x() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS((Simulation{Model{}, fast, Rock{}}), "particle 2: velocity must be finite",
                       InvalidInput);
}

TEST_CASE("velocities, body forces and bodies that do not exist are refused by name") {
  Simulation sim{crushing_model(), test::square_between_platens(0), Rock{}};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    CHECK_THROWS_AS(sim.set_velocity(1, {bad, 0}), InvalidInput);
    CHECK_THROWS_AS(sim.set_velocity(0, {0, 0}, bad), InvalidInput);
    CHECK_THROWS_AS(sim.set_body_force({0, bad}), InvalidInput);
  }
  CHECK_THROWS_WITH_AS(sim.set_velocity(2, {0, infinity}),
                       "particle 2: velocity (0, inf) m/s, spin 0 rad/s: must be finite",
                       InvalidInput);
  CHECK_THROWS_WITH_AS(sim.set_velocity(3, {0, 0}), "body = 3: must be in the simulation",
                       InvalidInput);
  CHECK_THROWS_AS(sim.set_motion(3, Motion::free), InvalidInput);
  CHECK_THROWS_AS((void)sim.element_stress(3), InvalidInput);
  CHECK_THROWS_AS((void)sim.mesh(3), InvalidInput);
  CHECK_NOTHROW(sim.step());
}

TEST_CASE("bodies that pass into each other, or start so, are an error with their overlap") {
  const ConvexPolygon fragment{{0, 0}, {0.001, 0}, {0.001, 0.001}, {0, 0.001}};
  const ConvexPolygon plate{{-0.02, -0.002}, {0.02, -0.002}, {0.02, 0}, {-0.02, 0}};
  const auto model = crushing_model().criterion(NeverFails{});
  // At 1000 m/s the spring of the plate, 2 mm thick, does not stop the fragment.
  const Assembly shot{.particles = {{fragment.moved({}, {0, 0.0005}), Motion::free, {0, -1000}},
                                    {plate, Motion::prescribed}}};
  Simulation sim{model, shot, Rock{}};
  const auto run = [&] {
    for (int i = 0; i < 200; ++i) sim.step();
  };
  CHECK_THROWS_WITH_AS(run(), doctest::Contains("particle 0 and particle 1 overlap in"),
                       SimulationError);
  const Assembly twice{.particles = {{fragment}, {fragment}}};
  CHECK_THROWS_WITH_AS((Simulation{model, twice, Rock{}}),
                       "particle 0 and particle 1 overlap in 1 of the area of the smaller one: at "
                       "most 0.75 makes a contact",
                       InvalidInput);
}

TEST_CASE(
    "a time step far above the critical one is an error before velocities are without sense") {
  const auto model = crushing_model().criterion(NeverFails{}).time_step(FixedTimeStep{1e-4});
  const ConvexPolygon square{{0, 0}, {0.005, 0}, {0.005, 0.005}, {0, 0.005}};
  const Assembly pair{.particles = {{square}, {square.moved({}, {0.001, 0.00499})}}};
  Simulation sim{model, pair, Rock{}};
  double fastest = 0;
  const auto run = [&] {
    for (int i = 0; i < 10'000; ++i) {
      sim.step();
      fastest = std::max(fastest, sim.particles().body(0).velocity.norm());
    }
  };
  CHECK_THROWS_WITH_AS(run(), doctest::Contains("in a time step of 1e-04 s by more than half its"),
                       SimulationError);
  CHECK(fastest < 100);
}

TEST_CASE("a square rests on a floor at its weight over twice the stiffness, however stiff") {
  const double side = 0.005;
  const ConvexPolygon square{{-side / 2, 0}, {side / 2, 0}, {side / 2, side}, {-side / 2, side}};
  const ConvexPolygon floor{{-0.05, -0.01}, {0.05, -0.01}, {0.05, 0}, {-0.05, 0}};
  for (const double stiffness : {1e7, 1e10, 1e12})
    for (const double place : {0.0, 0.3}) {
      CAPTURE(stiffness);
      const EnergyConservingSpring law{.normal_stiffness = stiffness,
                                       .tangential_stiffness = stiffness};
      const Assembly resting{.particles = {{square.moved({}, {place, 0})},
                                           {floor.moved({}, {place, 0}), Motion::prescribed}}};
      Simulation sim{crushing_model().criterion(NeverFails{}).contact_law(law), resting, Rock{}};
      sim.set_body_force({0, -9.81});
      for (int i = 0; i < 20'000; ++i) sim.step();
      const double weight = 9.81 * sim.particles().body(0).mass;
      // Coordinates below 10 mm are rounded to 1e-18 m, the depth is 5e-15 m at 1e12 N/m.
      CHECK(-sim.particles().ring(0)[0].y() == near_relative(weight / (2 * stiffness), 1e-3));
      CHECK(sim.particles().body(0).contact.force.y() == near_relative(weight, 1e-3));
      CHECK(sim.particles().body(0).velocity.norm() < 1e-9);
    }
}
