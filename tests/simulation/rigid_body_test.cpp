// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <numbers>
#include <utility>
#include <vector>

#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

template <class Sim>
double depth_of_only_contact(const Sim& sim) {
  double depth = 0;
  int count = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    depth = c.geometry.depth;
    ++count;
  });
  CHECK(count <= 1);
  return depth;
}

/// Linear momentum [N s], angular momentum about the origin [N m s] and sums of contact wrenches.
struct Balance {
  Vec2 momentum{0, 0};
  double angular_momentum = 0;
  Vec2 force{0, 0};
  double moment = 0;
};

Balance balance(const Particles& particles) {
  Balance sum;
  for (const Body& b : particles.bodies()) {
    sum.momentum += b.mass * b.velocity;
    sum.angular_momentum += b.mass * cross(b.position, b.velocity) + b.inertia * b.angular_velocity;
    sum.force += b.contact.force;
    sum.moment += cross(b.position, b.contact.force) + b.contact.moment;
  }
  return sum;
}

bool same_bits(const Body& p, const Body& q) {
  const auto numbers = [](const Body& b) {
    return std::array<double, 11>{b.position.x(),
                                  b.position.y(),
                                  b.rotation.cosine,
                                  b.rotation.sine,
                                  b.velocity.x(),
                                  b.velocity.y(),
                                  b.angular_velocity,
                                  b.contact.force.x(),
                                  b.contact.force.y(),
                                  b.contact.moment,
                                  b.mass};
  };
  const auto x = numbers(p);
  const auto y = numbers(q);
  return std::memcmp(x.data(), y.data(), sizeof x) == 0;
}

}  // namespace

// --- Free flight --------------------------------------------------------------------------------

TEST_CASE("a falling body follows g t^2 / 2 exactly when its velocity starts half a step early") {
  const double g = 9.81;
  const int steps = 1000;
  const double dt = 1.0 / steps;
  Simulation sim{undamped(springs(2e7, 0)),
                 of({{rectangle({3, 7}, 1, 1), Motion::free, {0, 0.5 * g * dt}}}), rock_of(25)};
  sim.set_body_force({0, -g});
  sim.set_time_step(dt);
  for (int i = 0; i < steps; ++i) sim.step();
  // Leapfrog is exact for a constant force: only the round-off of 1000 additions is left.
  CHECK(7 - sim.particles().body(0).position.y() == near_relative(4.905, 1e-12));
  CHECK(sim.particles().body(0).position.x() == 3);
  CHECK(sim.time() == near_relative(1, 1e-12));
}

TEST_CASE("a falling body released at rest is ahead of g t^2 / 2 by just g t dt / 2") {
  const double g = 9.81;
  const int steps = 400;
  const double dt = 1.0 / steps;
  Simulation sim{undamped(springs(2e7, 0)), of({{rectangle({0, 0}, 1, 1)}}), rock_of(25)};
  sim.set_body_force({0, -g});
  sim.set_time_step(dt);
  for (int i = 0; i < steps; ++i) sim.step();
  CHECK(-sim.particles().body(0).position.y() == near_relative(4.905 + 0.5 * g * dt, 1e-12));
  // The body force has done the work that the body now carries.
  CHECK(sim.work().body_force == near_relative(kinetic_energy(sim.particles()), 1e-12));
}

TEST_CASE("with velocity Verlet a body released at rest falls g t^2 / 2 exactly") {
  const int steps = 1000;
  Simulation sim{undamped(springs(2e7, 0)).integrator(VelocityVerlet{}),
                 of({{rectangle({0, 0}, 1, 1)}}), rock_of(25)};
  sim.set_body_force({0, -9.81});
  sim.set_time_step(1.0 / steps);
  for (int i = 0; i < steps; ++i) sim.step();
  const Body& body = sim.particles().body(0);
  // Round-off of 1000 additions.
  CHECK(-body.position.y() == near_relative(4.905, 1e-12));
  CHECK(-body.velocity.y() == near_relative(9.81, 1e-12));
  CHECK(sim.work().body_force == near_relative(body.kinetic_energy(), 1e-12));
}

TEST_CASE("a uniform body force gives light and heavy bodies the same acceleration, and no spin") {
  Simulation sim{undamped(springs(2e7, 0)),
                 of({{rectangle({0, 0}, 1, 1)}, {rectangle({9, 1}, 2, 5, 0.3)}}), rock_of(2500)};
  sim.set_body_force({2, -3});
  for (int i = 0; i < 10; ++i) sim.step();
  const double t = 10 * sim.time_step();
  for (const Body& body : sim.particles().bodies()) {
    CHECK((body.velocity - t * Vec2{2, -3}).norm() <= 1e-14 * 4);
    CHECK(body.angular_velocity == 0);
  }
}

// --- Bounces ------------------------------------------------------------------------------------

namespace {

constexpr double bounce_stiffness = 2e7;     // [N/m]
constexpr double bounce_mass = 25;           // [kg]
constexpr double omega = 894.4271909999159;  // sqrt(k / m) [1/s]

/// A block of 1 m x 1 m and 25 kg that starts flush on a fixed floor and moves into it with 1 m/s,
/// the whole set-up turned and shifted.
auto bounce(double dt, double angle = 0, const Vec2& shift = {0, 0}) {
  const Rotation turn = Rotation::from_angle(angle);
  Simulation sim{
      undamped(springs(bounce_stiffness, 0)),
      of({{rectangle({0, -0.5}, 3, 1).moved(turn, shift), Motion::prescribed},
          {rectangle({0, 0.5}, 1, 1).moved(turn, shift), Motion::free, turn * Vec2{0, -1}}}),
      rock_of(bounce_mass)};
  sim.set_time_step(dt);
  return sim;
}

struct Bounce {
  double contact_time = 0;
  double peak_depth = 0;
  double peak_force = 0;
};

/// Peak by the parabola through the three largest samples, time by interpolation of the position
/// where the block leaves: both errors are far below those of the scheme.
Bounce measure_bounce(double dt) {
  auto sim = bounce(dt);
  Bounce result;
  std::array<double, 3> depth{0, 0, 0};
  for (;;) {
    const double before = 0.5 - sim.particles().body(1).position.y();
    sim.step();
    const double after = 0.5 - sim.particles().body(1).position.y();
    depth = {depth[1], depth[2], depth_of_only_contact(sim)};
    const double bend = depth[0] - 2 * depth[1] + depth[2];
    if (depth[1] > depth[0] && depth[1] >= depth[2]) {
      result.peak_depth = depth[1] - std::pow(depth[2] - depth[0], 2) / (8 * bend);
      result.peak_force = bounce_stiffness * result.peak_depth;
    }
    if (after <= 0) {
      result.contact_time = sim.time() - dt * (-after) / (before - after);
      return result;
    }
  }
}

}  // namespace

TEST_CASE("an undamped bounce has the contact time, depth and peak force of half a sine wave") {
  // t = pi sqrt(m/k), d = v sqrt(m/k), F = v sqrt(m k).
  const Bounce fine = measure_bounce(0.02 / omega);
  // Leapfrog's frequency is off by (omega dt)^2 / 24, its amplitude by (omega dt)^2 / 8.
  const double tolerance = 0.02 * 0.02 / 4;
  CHECK(fine.contact_time == near_relative(3.512407e-3, tolerance));
  CHECK(fine.peak_depth == near_relative(1.118034e-3, tolerance));
  CHECK(fine.peak_force == near_relative(22360.680, tolerance));
}

TEST_CASE("the errors of a bounce fall with the square of the time step") {
  std::array<std::array<double, 2>, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Bounce result = measure_bounce(0.2 / omega / std::pow(2, static_cast<double>(i)));
    error[i] = {std::abs(result.contact_time - std::numbers::pi / omega),
                std::abs(result.peak_depth - 1 / omega)};
  }
  for (std::size_t quantity = 0; quantity < 2; ++quantity)
    for (std::size_t i = 0; i < 2; ++i) {
      const double order = std::log2(error[i][quantity] / error[i + 1][quantity]);
      CAPTURE(quantity);
      // The next term of the expansion is (omega dt)^2 smaller, 4 % at the coarsest step.
      CHECK(order == near_relative(2, 0.04));
    }
}

TEST_CASE("a bounce follows leapfrog's own closed form to round-off, turned and far away too") {
  // x_n = v dt sin(n q) / sin(q) with cos(q) = 1 - (omega dt)^2 / 2.
  const double dt = 0.12 / omega;
  const double q = std::acos(1 - 0.5 * 0.12 * 0.12);
  for (const auto& [angle, shift] :
       {std::pair{0.0, Vec2{0, 0}}, std::pair{0.7, Vec2{1, 2}}, std::pair{-2.3, Vec2{-300, 800}}}) {
    auto sim = bounce(dt, angle, shift);
    // The last bits of coordinates, in lengths and over the depth of 1 mm.
    const double tolerance = 20 * 2.3e-16 * std::max(1.0, shift.norm());
    for (int n = 1; n < 26; ++n) {
      sim.step();
      const double expected = dt * std::sin(n * q) / std::sin(q);
      CHECK(std::abs(depth_of_only_contact(sim) - expected) <= tolerance);
      CHECK(sim.particles().body(1).contact.force.norm() ==
            near_relative(bounce_stiffness * expected, 1e3 * tolerance));
    }
  }
}

TEST_CASE("two blocks in a central elastic collision exchange their velocities") {
  const double k = 2e7;
  Simulation sim{undamped(springs(k, 0.5)),
                 of({{rectangle({0, 0}, 1, 1), Motion::free, {2, 0}},
                     {rectangle({1.001, 0}, 1, 1.2), Motion::free, {-1, 0}}}),
                 rock_of(25)};
  const Body first = sim.particles().body(0);
  const Body second = sim.particles().body(1);
  const double reduced = first.mass * second.mass / (first.mass + second.mass);
  const double fraction = 0.01;
  sim.set_time_step(fraction * std::sqrt(reduced / k));
  for (int i = 0; i < 500; ++i) sim.step();
  // Elastic: the relative velocity turns round while the centre of mass goes on. Where contact
  // begins and ends within a step, leapfrog's energy differs by at most (omega dt)^2 / 4 each time.
  const double tolerance = 0.5 * fraction * fraction;
  const double centre = (first.mass * 2 + second.mass * -1) / (first.mass + second.mass);
  CHECK(depth_of_only_contact(sim) == 0);
  CHECK(sim.particles().body(0).velocity.x() == near_relative(2 * centre - 2, tolerance * 10));
  CHECK(sim.particles().body(1).velocity.x() == near_relative(2 * centre + 1, tolerance * 10));
  const double energy = 0.5 * (first.mass * 4 + second.mass * 1);
  const double available = 0.5 * reduced * 9;
  CHECK(std::abs(kinetic_energy(sim.particles()) - energy) <= tolerance * available);
}

namespace {

struct CornerBounce {
  double velocity = 0;
  double spin = 0;
  double energy = 0;
};

/// A unit square of 1 kg, tilted by 15 degrees, falls with 1 m/s with its corner onto a
/// frictionless wall of the given stiffness.
CornerBounce corner_bounce(double stiffness, double wall_angle, bool wall_first) {
  const Rotation turn = Rotation::from_angle(wall_angle);
  const double tilt = std::numbers::pi / 12;
  const double corner = std::numbers::sqrt2 / 2 * std::sin(tilt + std::numbers::pi / 4);
  const PlacedParticle wall{rectangle({0, -0.5}, 4, 1).moved(turn, {0, 0}), Motion::prescribed};
  const PlacedParticle square{rectangle({0, corner}, 1, 1, tilt).moved(turn, {0, 0}), Motion::free,
                              turn * Vec2{0, -1}};
  Simulation sim{undamped(springs(stiffness, 0)),
                 wall_first ? of({wall, square}) : of({square, wall}), rock_of(1)};
  const Body& body = sim.particles().body(wall_first ? 1 : 0);
  sim.set_time_step(0.01 / std::sqrt(stiffness));
  bool touched = false;
  for (int i = 0; i < 2000; ++i) {
    sim.step();
    const bool touching = depth_of_only_contact(sim) > 0;
    if (touched && !touching) break;
    touched = touching;
  }
  return {turn.inverse_times(body.velocity).y(), body.angular_velocity, body.kinetic_energy()};
}

}  // namespace

TEST_CASE("a corner that strikes a frictionless wall leaves with the impulse of rigid bodies") {
  // J = (1 + e) v / (1/m + r^2/I) with e = 1, r = sqrt(2)/2 cos 60 degrees: J = 8/7. The corner
  // lies r to the right of the centroid (tilted by 15 degrees, lowest corner at -30 from below),
  // so the square turns with J r / I, counter-clockwise for a corner on the right.
  const double tolerance = 1e-3;  // contact takes 2e-5 s, and 1e-5 of the square's size in depth
  for (const auto& [angle, wall_first] :
       {std::pair{0.0, true}, std::pair{0.0, false}, std::pair{2.1, true}}) {
    const CornerBounce result = corner_bounce(1e10, angle, wall_first);
    CHECK(result.velocity == near_relative(0.142857, tolerance));
    CHECK(std::abs(result.spin) == near_relative(2.424363, tolerance));
    CHECK(result.energy == near_relative(0.5, tolerance));
  }
}

TEST_CASE("a corner bounce nears that of rigid bodies as the wall gets stiffer") {
  // Depth, and with it the shift of the contact point, falls with the root of the stiffness.
  const double soft = std::abs(corner_bounce(1e6, 0, true).energy - 0.5);
  const double stiff = std::abs(corner_bounce(1e8, 0, true).energy - 0.5);
  // Where in a step the contact begins and ends adds some per cent to either.
  CHECK(soft / stiff == near_relative(10, 0.2));
}

// --- Equilibrium --------------------------------------------------------------------------------

namespace {

/// Settles a block on a block on a floor and checks both contacts.
/// @param width of the lower block [m]; the upper one is 1 m wide
/// @param floor_width [m]
void check_stack(double width, double floor_width) {
  CAPTURE(width);
  const double k = 2e7;
  const double g = 9.81;
  Simulation sim{damped(springs(k, 0.5)),
                 of({{rectangle({0, -0.5}, floor_width, 1), Motion::prescribed},
                     {rectangle({0, 0.5}, width, 1), Motion::free},
                     {rectangle({0, 1.4}, 1, 0.8), Motion::free}}),
                 rock_of(2500)};
  sim.set_body_force({0, -g});
  for (int i = 0; i < 6000; ++i) sim.step();
  const double lower = width * 1 * 2500 * g;
  const double upper = 1 * 0.8 * 2500 * g;
  // Forces converge exponentially under damping, to the round-off of depths over 1 m of size.
  const double tolerance = 1e-9;
  int contacts = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    ++contacts;
    const double load = c.b == 2 ? upper : lower + upper;
    CHECK(c.force.normal == near_relative(load, tolerance));
    CHECK(c.geometry.depth == near_relative(load / k, tolerance));
    CHECK((c.geometry.normal - Vec2{0, 1}).norm() <= tolerance);
    CHECK(c.geometry.chord == near_relative(c.b == 2 ? 1 : width, tolerance));
    CHECK(std::abs(c.force.tangential) <= tolerance * load);
  });
  CHECK(contacts == 2);
  CHECK((sim.particles().body(0).contact.force - Vec2{0, -lower - upper}).norm() <=
        tolerance * (lower + upper));
}

}  // namespace

TEST_CASE("in a stack every contact carries the weight above it") { check_stack(2, 4); }

TEST_CASE("in a stack of flush blocks every contact carries the weight above it") {
  check_stack(1, 1);  // all side faces in line: no two boundaries cross properly
  check_stack(1, 4);
}

// --- Newton's third law and conservation --------------------------------------------------------

namespace {

/// Loose random polygons thrown at the centre: many collisions with friction.
Assembly random_rush(std::uint64_t seed) {
  Assembly assembly = random_assembly({.count = 40, .seed = seed, .solid_fraction = 0.4});
  Random random(seed + 100);
  for (PlacedParticle& p : assembly.particles) {
    p.motion = Motion::free;
    const Vec2 centre = area_properties(p.polygon.ring()).centroid;
    p.velocity = -20 * centre + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
    p.angular_velocity = random.uniform(-50, 50);
  }
  return assembly;
}

/// A packing of 80 particles, quickly pressed together by its boundary.
auto quick_packing(std::uint64_t seed) {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 80, .seed = seed}),
                 Rock{}};
  sim.boundary().set_rate(80, 80);
  for (int i = 0; i < 2300; ++i) sim.step();
  int touching = 0;
  sim.contacts().for_each_touching([&](const auto&) { ++touching; });
  CHECK(touching > 50);  // no longer a gas
  return sim;
}

}  // namespace

TEST_CASE("contact forces and their moments about any point sum to zero") {
  const auto sim = quick_packing(3);
  double scale = 0;
  sim.contacts().for_each_touching([&](const auto& c) { scale += c.force_on_b().norm(); });
  const Balance sum = balance(sim.particles());
  // Round-off of some hundred additions; arms are measured in the assembly's size of 0.1 m.
  CHECK(sum.force.norm() <= 1e-14 * scale);
  CHECK(std::abs(sum.moment) <= 1e-14 * scale * 0.1);
}

TEST_CASE("momentum and angular momentum of free bodies are conserved in collisions") {
  Simulation sim{undamped(springs(2e7, 0.5)), random_rush(5), Rock{}};
  const Balance start = balance(sim.particles());
  double momentum = 0;
  for (const Body& b : sim.particles().bodies()) momentum += b.mass * b.velocity.norm();
  const double energy = kinetic_energy(sim.particles());
  for (int i = 0; i < 3000; ++i) sim.step();
  const Balance end = balance(sim.particles());
  // Kick and drift conserve both exactly; what is left is round-off over 3000 steps.
  CHECK((end.momentum - start.momentum).norm() <= 1e-12 * momentum);
  CHECK(std::abs(end.angular_momentum - start.angular_momentum) <= 1e-12 * momentum * 0.1);
  // The collisions did happen: friction has taken energy.
  CHECK(sim.contacts().friction_loss() > 0.01 * energy);
}

TEST_CASE("a free pair in an oblique collision keeps momentum and angular momentum") {
  Simulation sim{undamped(springs(2e7, 0.3)),
                 of({{rectangle({100, 50}, 1, 1, 0.2), Motion::free, {1, 0.3}, 0.5},
                     {rectangle({101.2, 50.3}, 1, 0.7, 0.9), Motion::free, {-2, 0}, -1}}),
                 rock_of(2500)};
  const Balance start = balance(sim.particles());
  const Vec2 before = sim.particles().body(0).velocity;
  for (int i = 0; i < 20000; ++i) sim.step();
  const Balance end = balance(sim.particles());
  CHECK((sim.particles().body(0).velocity - before).norm() > 0.5);  // they have met
  CHECK((end.momentum - start.momentum).norm() <= 1e-12 * 2500 * 2);
  CHECK(std::abs(end.angular_momentum - start.angular_momentum) <= 1e-12 * 2500 * 2 * 100);
}

// --- Driven bodies ------------------------------------------------------------------------------

TEST_CASE("a prescribed body keeps its velocity whatever pushes it") {
  Simulation sim{undamped(springs(2e7, 0.5)),
                 of({{rectangle({0, 0}, 1, 1), Motion::prescribed, {0.1, 0.02}, 0.3},
                     {rectangle({1.2, 0.1}, 1, 1, 0.4), Motion::free, {-5, 0}}}),
                 rock_of(2500)};
  sim.set_body_force({0, -10});
  bool pushed = false;
  while (sim.time() < 0.2) {
    sim.step();
    pushed = pushed || sim.particles().body(0).contact.force.norm() > 0;
  }
  const Body& wall = sim.particles().body(0);
  CHECK(pushed);
  CHECK(wall.velocity == Vec2{0.1, 0.02});
  CHECK(wall.angular_velocity == 0.3);
  CHECK((wall.position - sim.time() * Vec2{0.1, 0.02}).norm() <= 1e-12);
  // Cayley's form turns by 2 atan(w dt / 2), short of w dt by (w dt)^2 / 12.
  const double turn = 2 * std::atan(0.5 * 0.3 * sim.time_step());
  CHECK(wall.rotation.angle() == near_relative(static_cast<double>(sim.steps()) * turn, 1e-12));
}

TEST_CASE("the work of a wall that lifts a block is its force times its way") {
  const double k = 2e7;
  const double g = 9.81;
  const double weight = 1 * 1 * 2500 * g;
  const double v = 0.05;
  Simulation sim{undamped(springs(k, 0.5)),
                 of({{rectangle({0, -0.5}, 3, 1), Motion::prescribed, {0, v}},
                     {rectangle({0, 0.5 - weight / k}, 1, 1), Motion::free, {0, v}}}),
                 rock_of(2500)};
  sim.set_body_force({0, -g});
  for (int i = 0; i < 1000; ++i) sim.step();
  const double way = v * sim.time();
  // The block starts in equilibrium at the wall's velocity and stays there, to round-off in depth
  // (1e-16 m over a depth of 1 mm).
  CHECK(sim.work().boundary == near_relative(weight * way, 1e-10));
  CHECK(sim.work().body_force == near_relative(-weight * way, 1e-10));
  CHECK(sim.work().damping == 0);
}

TEST_CASE("the work of a wall that pushes a block up to speed is the energy the block has gained") {
  const double k = 2e7;
  Simulation sim{undamped(springs(k, 0)),
                 of({{rectangle({-0.5, 0}, 1, 3), Motion::prescribed, {1, 0}},
                     {rectangle({0.5, 0}, 1, 1), Motion::free}}),
                 rock_of(25)};
  const double fraction = 0.01;
  sim.set_time_step(fraction * std::sqrt(25 / k));
  double pushed = 0;
  for (int i = 0; i < 500; ++i) {
    const double force = -sim.particles().body(0).contact.force.x();
    sim.step();
    pushed += force * 1 * sim.time_step();
  }
  CHECK(depth_of_only_contact(sim) == 0);
  CHECK(sim.work().boundary == near_relative(pushed, 1e-14));
  // The block leaves at twice the wall's speed: m v (2 v) of work, 1/2 m (2 v)^2 of energy. The
  // ends of the contact fall within a step, which costs at most (omega dt)^2 / 4 of energy each.
  CHECK(sim.work().boundary == near_relative(50, fraction * fraction));
  CHECK(kinetic_energy(sim.particles()) == near_relative(50, fraction * fraction));
}

TEST_CASE("a turning wall does work with the moment it exerts") {
  // A bar that turns about its centroid strikes the corner of a block with its upper side.
  const double k = 2e9;
  Simulation sim{undamped(springs(k, 0)),
                 of({{rectangle({0, 0}, 4, 0.2), Motion::prescribed, {0, 0}, 1.0},
                     {rectangle({1.5, 0.85}, 1, 1, 0.25 * std::numbers::pi), Motion::free}}),
                 rock_of(25)};
  sim.set_time_step(0.01 * std::sqrt(25 / k));
  while (sim.time() < 0.1) sim.step();
  CHECK(depth_of_only_contact(sim) == 0);
  const double gained = kinetic_energy(sim.particles());
  CHECK(gained > 50);
  // The force acts in the middle of the chord and not at the corner: an error of the order of depth
  // over size, 2e-4 here.
  CHECK(sim.work().boundary == near_relative(gained, 1e-3));
}

// --- Determinism and independence ---------------------------------------------------------------

TEST_CASE("a far body changes nothing in the motion of the others, to the last bit") {
  const Assembly near = random_rush(7);
  Assembly with_far = near;
  with_far.particles.push_back({rectangle({5, -3}, 0.02, 0.02, 0.3), Motion::free});
  Simulation sim{undamped(springs(2e7, 0.5)), near, Rock{}};
  Simulation other{undamped(springs(2e7, 0.5)), with_far, Rock{}};
  other.set_time_step(sim.time_step());
  for (int i = 0; i < 2000; ++i) {
    sim.step();
    other.step();
  }
  for (BodyIndex i = 0; i < near.particles.size(); ++i)
    CHECK(same_bits(sim.particles().body(i), other.particles().body(i)));
  CHECK(sim.contacts().friction_loss() == other.contacts().friction_loss());
}

TEST_CASE("two runs of the same packing agree to the last bit") {
  const auto first = quick_packing(11);
  const auto second = quick_packing(11);
  for (BodyIndex i = 0; i < first.particles().size(); ++i)
    CHECK(same_bits(first.particles().body(i), second.particles().body(i)));
  CHECK(first.work().boundary == second.work().boundary);
  CHECK(first.contacts().friction_loss() == second.contacts().friction_loss());
}
