// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <string>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using riprap::test::near_relative;
using riprap::test::rectangle;

namespace {

struct Loop {
  double net = 0;    ///< work of the normal force round the loop [J]
  double swing = 0;  ///< largest less smallest work on the way [J]
};

/// Leads a tilted corner round a closed loop of shifts and turns in a floor: the work of the normal
/// force is the trapezoid sum over the way of the contact point, taken as a point of the moved
/// body.
template <class Law>
Loop lead_round(const Law& law, int steps) {
  const ConvexPolygon floor = rectangle({0, -0.5}, 4, 1);
  const ConvexPolygon corner{{0, 0}, {0.9, 0.4}, {-0.3, 0.7}};
  const auto position = [](double phase) {
    return Vec2{0.02 * std::sin(phase), -0.05 + 0.01 * std::cos(phase)};
  };
  const auto angle = [](double phase) { return 0.05 * std::sin(phase + 1); };
  const double step = 2 * std::numbers::pi / steps;
  Loop loop;
  double low = 0;
  double high = 0;
  // Midpoint rule: force and contact point at the middle of each step.
  for (int i = 0; i < steps; ++i) {
    const double middle = (i + 0.5) * step;
    const ConvexPolygon placed =
        corner.moved(Rotation::from_angle(angle(middle)), position(middle));
    OverlapChord::Cache cache;
    const auto contact = OverlapChord{}(floor.ring(), placed.ring(), cache);
    REQUIRE(contact);
    typename Law::History history;
    const double force = law(*contact, {}, history).normal;
    const Vec2 way = position(middle + 0.5 * step) - position(middle - 0.5 * step);
    const double turn = angle(middle + 0.5 * step) - angle(middle - 0.5 * step);
    const Vec2 at_contact = way + turn * perpendicular(contact->point - position(middle));
    loop.net += force * contact->normal.dot(at_contact);
    low = std::min(low, loop.net);
    high = std::max(high, loop.net);
  }
  loop.swing = high - low;
  return loop;
}

constexpr OverlapAreaSpring smooth{
    .area_stiffness = 1e9, .tangential_stiffness = 0, .friction = 0, .largest_chord = 1};

}  // namespace

TEST_CASE("the area law does no net work round a closed path, turns included") {
  const Loop area = lead_round(smooth, 4000);
  CHECK(area.swing > 1);
  // The midpoint rule converges faster than any power round a smooth closed path, to round-off but
  // for the third-order terms of the turns.
  CHECK(std::abs(area.net) <= 1e-6 * area.swing);
  // The linear law does: that is why this one exists.
  const Loop linear = lead_round(LinearSpringCoulomb{.friction = 0}, 4000);
  CHECK(std::abs(linear.net) > 1e-3 * linear.swing);
}

TEST_CASE("the force of the area law is the slope of its energy against the depth") {
  ContactGeometry geometry;
  geometry.area = 0.03;
  geometry.chord = 0.4;
  OverlapAreaSpring::History history;
  const double force = smooth(geometry, {}, history).normal;
  CHECK(force == near_relative(1e9 * 0.03 * 0.4, 1e-15));
  ContactGeometry deeper = geometry;
  ContactGeometry shallower = geometry;
  const double way = 1e-4;
  deeper.area += way * geometry.chord;
  shallower.area -= way * geometry.chord;
  // A quadratic energy: the central difference is exact.
  CHECK((smooth.stored_energy(deeper, history) - smooth.stored_energy(shallower, history)) /
            (2 * way) ==
        near_relative(force, 1e-10));
}

namespace {

/// Slope of the normal force at a body that is pressed into a floor, its lowest point at `depth`,
/// by a central difference: exact for the quadratic and cubic forces of straight sides but for the
/// third order of its way.
double slope_at(const ConvexPolygon& body, double depth) {
  const ConvexPolygon floor = rectangle({0, -2}, 4, 4);
  const auto force = [&](double d) {
    OverlapChord::Cache cache;
    const auto contact = OverlapChord{}(floor.ring(), body.moved({}, {0, -d}).ring(), cache);
    REQUIRE(contact);
    REQUIRE(contact->chord <= smooth.largest_chord);
    OverlapAreaSpring::History history;
    return smooth(*contact, {}, history).normal;
  };
  const double way = 1e-5 * depth;
  return (force(depth + way) - force(depth - way)) / (2 * way);
}

}  // namespace

TEST_CASE("any corner whose chord has grown to the largest one has the peak stiffness") {
  for (const double half_angle : {0.3, 0.8, 1.2})
    for (const double tilt : {-0.2, 0.0, 0.25}) {
      CAPTURE(half_angle);
      CAPTURE(tilt);
      const double left = std::tan(tilt - half_angle);
      const double right = std::tan(tilt + half_angle);
      const ConvexPolygon corner{{0, 0}, {2 * right, 2}, {2 * left, 2}};
      const double depth = smooth.largest_chord / (right - left);
      // One way short of it, and the third order of the way.
      CHECK(slope_at(corner, (1 - 2e-5) * depth) == near_relative(smooth.peak_stiffness(), 5e-5));
    }
}

TEST_CASE("no body that is pressed into a floor is stiffer than the peak, faces by a third less") {
  const ConvexPolygon face = rectangle({0, 0.5}, smooth.largest_chord, 1);
  // Round-off of a coordinate of 1, over the way of 1e-8.
  CHECK(slope_at(face, 1e-3) == near_relative(smooth.peak_stiffness() / 1.5, 1e-7));
  for (const double foot : {0.01, 0.1, 0.5, 0.9}) {
    const ConvexPolygon blunt{{-0.5 * foot, 0}, {0.5 * foot, 0}, {0.5, 0.6}, {-0.5, 0.6}};
    for (const double depth : {0.05, 0.2, 0.4, 0.59}) {
      CAPTURE(foot);
      CAPTURE(depth);
      CHECK(slope_at(blunt, depth) < smooth.peak_stiffness());
    }
  }
}

TEST_CASE("a tangential spring stiffer than the normal force decides the peak stiffness") {
  OverlapAreaSpring sideways = smooth;
  sideways.tangential_stiffness = 5e9;
  CHECK(sideways.peak_stiffness() == 5e9);
}

TEST_CASE("the area law slips at its friction coefficient times the normal force") {
  OverlapAreaSpring rough = smooth;
  rough.tangential_stiffness = 2e7;
  rough.friction = 0.5;
  ContactGeometry geometry;
  geometry.area = 0.01;
  geometry.chord = 0.1;
  OverlapAreaSpring::History history;
  const ContactForce force = rough(geometry, {.tangential_velocity = -10, .time_step = 1}, history);
  CHECK(force.tangential == 0.5 * force.normal);
  CHECK(rough(geometry, {.tangential_velocity = 3}, history).tangential == force.tangential);
  CHECK(rough.stored_energy(geometry, history) ==
        near_relative(0.5 * 1e9 * 1e-4 + std::pow(force.tangential, 2) / 4e7, 1e-14));
}

TEST_CASE("an area law with parameters that cannot be is refused by name") {
  const auto message_of = [](const OverlapAreaSpring& law) -> std::string {
    try {
      law.validate();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message_of({}) == "");
  CHECK(message_of({.area_stiffness = 0}) ==
        "OverlapAreaSpring.area_stiffness = 0: must be a finite number above 0");
  CHECK(message_of({.friction = -1}) ==
        "OverlapAreaSpring.friction = -1: must be a finite number, 0 or above");
  CHECK(message_of({.largest_chord = -1}) ==
        "OverlapAreaSpring.largest_chord = -1: must be a finite number above 0");
}
