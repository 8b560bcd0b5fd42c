// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using test::near;
using test::near_relative;
using test::of;
using test::rock_of;
using test::undamped;

namespace {

constexpr double degree = std::numbers::pi / 180;

// The damping ratio of a dashpot that never pulls, for a restitution e: Schwager and Poeschel 2007.
double damping_ratio(double e) {
  double low = 0;
  double high = 0.99;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    const double root = std::sqrt(1 - z * z);
    (std::exp(-z / root * std::atan2(2 * z * root, 2 * z * z - 1)) > e ? low : high) = z;
  }
  return 0.5 * (low + high);
}

// The data of a pair in rigid-body impact.
struct Surface {
  double friction = 0;
  double restitution = 1;
};

// A rhombus that stands on a corner below its centroid, `radius` away: the normal force has no
// moment, and the polar moment (radius^2 + a^2) / 6 per mass is what the other half diagonal a
// makes it. So it meets a wall as a disc or as a sphere of that radius does.
ConvexPolygon body_like(double polar_moment_over_m_r2, double radius) {
  const double a = radius * std::sqrt(6 * polar_moment_over_m_r2 - 1);
  return {{0, 0}, {a, radius}, {0, 2 * radius}, {-a, radius}};
}
constexpr double disc = 0.5;
constexpr double sphere = 0.4;

struct Rebound {
  Vec2 velocity{0, 0};  // along the wall, and away from it
  double spin = 0;
};

// The polygon's lowest corner is at the origin, on a fixed wall, and comes down with -velocity.y().
Rebound rebound(const ConvexPolygon& polygon, const Vec2& velocity, const Surface& surface,
                const Rotation& turn = {}, const Vec2& shift = {0, 0}) {
  const double size = diameter(polygon.ring());
  const double mass = area_properties(polygon.ring()).area;  // of 1 m thickness and 1 kg/m^3
  // Contact lasts as long as the body needs for about a hundred-thousandth of its size.
  const double contact_time = 1e-5 * size / velocity.norm();
  const double k = mass * std::pow(std::numbers::pi / contact_time, 2);
  // The stiffer the tangential spring, the sooner it slips.
  const SpringDashpot law{.normal_stiffness = k,
                          .tangential_stiffness = 100 * k,
                          .friction = surface.friction,
                          .damping_ratio = damping_ratio(surface.restitution)};
  const ConvexPolygon wall = test::shifted(test::rectangle(4 * size, size), {0, -0.5 * size});
  Simulation sim{undamped(law),
                 of({{wall.moved(turn, shift), Motion::prescribed},
                     {polygon.moved(turn, shift), Motion::free, turn * velocity}}),
                 rock_of(1)};
  sim.set_time_step(contact_time / 1000);
  const auto touching = [&] { return sim.particles().body(1).contact.force.norm() > 0; };
  for (int i = 0; i < 5 || touching(); ++i) sim.step();
  const Body& body = sim.particles().body(1);
  return {turn.inverse_times(body.velocity), body.angular_velocity};
}

}  // namespace

// Gross sliding: the wall gives a normal impulse m (1 + e) v_n and mu times that against the
// motion, which turns the body about its centroid. Walton 1993; Foerster, Louge, Chang and Allia
// 1994.

TEST_CASE("a disc that slides on a wall loses mu (1 + e) v_n along it and gains spin") {
  // mu = 0.3, e = 0.5, v_n = 1, R = 0.1: 0.45 m/s and 2 mu (1 + e) v_n / R = 9 rad/s.
  const Surface surface{0.3, 0.5};
  const ConvexPolygon body = body_like(disc, 0.1);
  // A contact of 1e-5 of the size moves the contact point by as much; 1000 steps resolve it.
  const double tolerance = 1e-3;
  for (const test::Pose& pose : test::poses(0.2)) {
    // Even a thousand sizes away, seven digits of a depth of a micrometre are left.
    const Rebound right = rebound(body, {2, -1}, surface, pose.rotation, pose.shift);
    CHECK(right.velocity.x() == near_relative(2 - 0.45, tolerance));
    CHECK(right.velocity.y() == near_relative(0.5, tolerance));
    CHECK(right.spin == near_relative(-9, tolerance));
    const Rebound left = rebound(body, {-2, -1}, surface, pose.rotation, pose.shift);
    CHECK(left.velocity.x() == near_relative(-2 + 0.45, tolerance));
    CHECK(left.spin == near_relative(9, tolerance));
  }
}

TEST_CASE("a polygon of 64 corners bounces as the disc that it stands for") {
  const ConvexPolygon standing = test::shifted(test::regular_polygon(64, 0.1), {0, 0.1});
  const Rebound r = rebound(standing, {2, -1}, {0.3, 0.5});
  CHECK(r.velocity.x() == near_relative(2 - 0.45, 1e-3));
  // Its polar moment is m R^2 (2 + cos(2 pi / 64)) / 6, by 0.16 % below the disc's.
  const double moment = (2 + std::cos(2 * std::numbers::pi / 64)) / 6;
  CHECK(r.spin == near_relative(-0.45 / (moment * 0.1), 1e-3));
  CHECK(r.spin == near_relative(-9, 3e-3));
}

TEST_CASE("gross sliding ends at v_t / v_n = (1 + m R^2 / I) mu (1 + e)") {
  // There the contact point has just come to rest: 3 mu (1 + e) for a disc, 3.5 for a sphere.
  const Surface surface{0.3, 0.5};
  for (const double inertia : {disc, sphere}) {
    CAPTURE(inertia);
    const double limit = (1 + 1 / inertia) * 0.45;
    const ConvexPolygon body = body_like(inertia, 0.1);
    const Rebound above = rebound(body, {1.01 * limit, -1}, surface);
    CHECK(above.velocity.x() == near_relative(1.01 * limit - 0.45, 1e-3));
    CHECK(above.spin == near_relative(-0.45 / (inertia * 0.1), 1e-3));
    const Rebound below = rebound(body, {0.9 * limit, -1}, surface);
    CHECK(std::abs(below.spin) < 0.99 * 0.45 / (inertia * 0.1));
    // Whatever the tangential force was, it acted at R from the centroid.
    CHECK(below.spin * inertia * 0.1 == near(below.velocity.x() - 0.9 * limit, 1e-3));
  }
}

TEST_CASE("a sphere-like body rebounds from a wall at every angle of incidence as Coulomb has it") {
  // The fourth test of Chung and Ooi (2011): 3.9 m/s, radius 2.5 mm, mu = 0.092, e = 0.98, from 5
  // to 85 degrees off the normal. It slides all the way above atan(3.5 mu (1 + e)) = 32.52 degrees.
  const Surface surface{0.092, 0.98};
  const double radius = 2.5e-3;
  const ConvexPolygon body = body_like(sphere, radius);
  const double loss = 0.092 * 1.98;
  CHECK(std::atan(3.5 * loss) / degree == near(32.52, 0.005));
  for (int angle = 5; angle <= 85; angle += 5) {
    CAPTURE(angle);
    const Vec2 v = 3.9 * Vec2{std::sin(angle * degree), -std::cos(angle * degree)};
    const Rebound r = rebound(body, v, surface);
    const double sliding_spin = 2.5 * loss * -v.y() / radius;
    // As above: contacts that are short and well resolved. Comparisons with experiments and other
    // codes take 2 %.
    const double tolerance = 1e-3;
    CHECK(r.velocity.y() == near_relative(-0.98 * v.y(), tolerance));
    if (angle > 32.52) {
      CHECK(r.spin == near_relative(-sliding_spin, tolerance));
      CHECK(r.velocity.x() == near_relative(v.x() + loss * v.y(), tolerance));
    } else {
      CHECK(std::abs(r.spin) < 0.99 * sliding_spin);
    }
    if (angle == 60) CHECK(r.spin == near_relative(-355.21, tolerance));
  }
}

TEST_CASE("a disc slides where a sphere grips: at 30 degrees, between 28.66 and 32.52") {
  const Surface surface{0.092, 0.98};
  const double loss = 0.092 * 1.98;
  CHECK(std::atan(3 * loss) / degree == near(28.66, 0.005));
  const Vec2 v = 3.9 * Vec2{std::sin(30 * degree), -std::cos(30 * degree)};
  const double full = loss * v.y();
  CHECK(rebound(body_like(disc, 2.5e-3), v, surface).velocity.x() ==
        near_relative(v.x() + full, 1e-3));
  CHECK(rebound(body_like(sphere, 2.5e-3), v, surface).velocity.x() > v.x() + 0.99 * full);
}
