// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

// The rocking of a rigid block, G. W. Housner, The behavior of inverted pendulum structures during
// earthquakes (1963). R is the half diagonal, tan(alpha) = width / height, p^2 = 3 g / (4 R).

namespace {

constexpr double g = 9.81;
constexpr double width = 1;
constexpr double height = 4;
constexpr double alpha = 0.24497866312686414;  // atan(1/4), 14.0362 degrees
constexpr double p = 1.889156;                 // [1/s]

struct Rocking {
  double quarter_period = 0;  // from rest at alpha / 2 until the block is upright [s]
  double spin_before = 0;     // of the first impact [rad/s]
  double spin_after = 0;
  double next_peak = 0;  // largest angle after it over alpha
};

// The spin that a block turning about a corner has when upright, from what it has at an angle.
double upright_spin(double spin, double angle) {
  return std::sqrt(spin * spin + 2 * p * p * (std::cos(alpha - angle) - std::cos(alpha)));
}

// The time from rest at an angle until a block that turns about its corner is upright,
// theta'' = -p^2 sin(alpha - theta) [s].
double fall_time(double angle) {
  constexpr double dt = 1e-6;
  double spin = 0;
  double time = 0;
  for (; angle > 0; time += dt) {
    spin -= p * p * std::sin(alpha - angle) * dt;
    angle += spin * dt;
  }
  return time;
}

// Two floors that leave a hundredth of the width under each corner: on one floor a contact with
// OverlapChord acts in the middle of the base, and not at the corner that comes down.
std::vector<PlacedParticle> feet() {
  const double foot = 0.01 * width;
  std::vector<PlacedParticle> floors;
  for (const double x : {-1.0, 1.0})
    floors.push_back(
        {rectangle({x * (0.75 * width - foot), -0.5}, 0.5 * width, 1), Motion::prescribed});
  return floors;
}

// @param side 1: released on its left corner; -1: on its right one
template <class Narrow>
Rocking rock(double side, const Narrow& narrow, const std::vector<PlacedParticle>& floors) {
  const double k = 1e8;
  const Rotation tilt = Rotation::from_angle(0.5 * side * alpha);
  const Vec2 corner{-0.5 * side * width, 0};
  const Vec2 centre = corner + tilt * (Vec2{0.5 * side * width, 0.5 * height});
  std::vector<PlacedParticle> bodies{
      {rectangle(centre, width, height, 0.5 * side * alpha), Motion::free}};
  bodies.insert(bodies.end(), floors.begin(), floors.end());
  // The dashpots leave next to no rebound.
  const SpringDashpot law{
      .normal_stiffness = k, .tangential_stiffness = k, .friction = 0.5, .damping_ratio = 0.9};
  Simulation sim{undamped(law).narrow_phase(narrow), of(bodies), rock_of(1)};
  sim.set_body_force({0, -g});
  sim.set_time_step(0.05 * std::sqrt(width * height / k));

  Rocking result;
  const Body& block = sim.particles().body(0);
  const auto angle = [&] { return 0.5 * alpha + side * block.rotation.angle(); };
  // Away from the impact, at a fiftieth of a radian on either side of upright.
  const double away = 0.02;
  while (angle() > away) sim.step();
  result.spin_before = upright_spin(block.angular_velocity, angle());
  while (angle() > 0) sim.step();
  result.quarter_period = sim.time();
  while (angle() > -away) sim.step();
  result.spin_after = upright_spin(block.angular_velocity, -angle());
  while (side * block.angular_velocity < 0) sim.step();
  result.next_peak = -angle() / alpha;
  return result;
}

}  // namespace

TEST_CASE("a rocking block has the period and loses the spin that Housner found") {
  CHECK(std::sqrt(3 * g / (4 * 0.5 * std::hypot(width, height))) == near_relative(p, 1e-6));
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    const Rocking r = rock(side, OverlapChord{}, feet());
    // T = 4/p acosh(1 / (1 - theta_0 / alpha)) = 2.788457 s takes the sine for its angle, which is
    // alpha^2 / 6 = 1 %.
    CHECK(4 * r.quarter_period == near_relative(2.788457, 0.01));
    CHECK(r.quarter_period == near_relative(fall_time(0.5 * alpha), 1e-4));
    // Angular momentum about the corner that comes down: 1 - 3/2 sin^2 alpha. Feet of a hundredth
    // of the width change it by 0.2 %.
    const double ratio = r.spin_after / r.spin_before;
    CHECK(ratio == near_relative(0.911765, 0.002));
    CHECK(ratio * ratio == near_relative(0.831315, 0.004));
    // (1 - theta_1 / alpha)^2 = 1 - ratio^2 (1 - (1 - theta_0 / alpha)^2), linear in the angles
    // again.
    CHECK(r.next_peak == near_relative(1 - std::sqrt(1 - 0.831315 * 0.75), 0.01));
  }
}

TEST_CASE("a block rocks on its own base where the contact acts at the corner that bears") {
  const std::vector<PlacedParticle> floor{{rectangle({0, -0.5}, 4 * width, 1), Motion::prescribed}};
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    const Rocking r = rock(side, OverlapMoments{}, floor);
    CHECK(r.quarter_period == near_relative(fall_time(0.5 * alpha), 1e-4));
    // Spring and dashpot act over the whole base while it comes down, and not at its corner alone:
    // 0.5 % more spin is left, whatever the stiffness from 1e8 to 1e10.
    CHECK(r.spin_after / r.spin_before == near_relative(0.911765, 0.006));
    CHECK(r.next_peak == near_relative(1 - std::sqrt(1 - 0.831315 * 0.75), 0.02));
  }
}
