// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>
#include <utility>

#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

constexpr double stiffness = 2e7;  // [N/m]
constexpr double mass = 25;        // effective [kg]
// The dashpot's part is of first order in omega dt = 1e-5.
constexpr double tolerance = 1e-4;

/// What is left of a head-on collision with 1 m/s.
struct Collision {
  double restitution = 0;
  double viscous_loss = 0;  ///< energy [J]
  double lowest_force = 0;  ///< [N]
};

/// Follows the collision with the velocity of each half step, O(dt) in the dashpot's part.
Collision collide(double damping_ratio, bool may_pull) {
  const SpringDashpot law{
      .normal_stiffness = stiffness, .damping_ratio = damping_ratio, .may_pull = may_pull};
  SpringDashpot::History history;
  const double dt = 1e-5 * std::sqrt(mass / stiffness);
  double depth = 0;
  double velocity = -1;  // closing
  Collision result;
  do {
    ContactGeometry geometry;
    geometry.depth = depth;
    const ContactForce force = law(
        geometry, {.normal_velocity = velocity, .time_step = dt, .effective_mass = mass}, history);
    result.viscous_loss += force.viscous_loss;
    result.lowest_force = std::min(result.lowest_force, force.normal);
    velocity += dt * force.normal / mass;
    depth -= dt * velocity;
  } while (depth > 0);
  result.restitution = velocity;
  return result;
}

}  // namespace

TEST_CASE("a dashpot that may pull restores exp(-pi zeta / sqrt(1 - zeta^2)) of the velocity") {
  for (const auto& [ratio, restitution] :
       {std::pair{0.05, 0.854468}, std::pair{0.1, 0.729248}, std::pair{0.2, 0.526621},
        std::pair{0.3, 0.372326}, std::pair{0.5, 0.163034}}) {
    CAPTURE(ratio);
    const Collision collision = collide(ratio, true);
    CHECK(collision.restitution == near_relative(restitution, tolerance));
    CHECK(collision.lowest_force < 0);
    const double lost = 0.5 * mass * (1 - restitution * restitution);
    CHECK(collision.viscous_loss == near_relative(lost, tolerance));
  }
}

TEST_CASE("a dashpot that never pulls restores more, as Schwager and Poeschel have found") {
  for (const auto& [ratio, restitution] :
       {std::pair{0.05, 0.858758}, std::pair{0.1, 0.744079}, std::pair{0.2, 0.571740},
        std::pair{0.3, 0.450975}, std::pair{0.5, 0.298436}}) {
    CAPTURE(ratio);
    const Collision collision = collide(ratio, false);
    CHECK(collision.restitution == near_relative(restitution, tolerance));
    CHECK(collision.lowest_force == 0);
    // What the spring still holds when the bodies part is booked as lost, too.
    const double lost = 0.5 * mass * (1 - restitution * restitution);
    CHECK(collision.viscous_loss == near_relative(lost, tolerance));
  }
}

TEST_CASE("without damping the dashpot law is the linear spring") {
  const Collision collision = collide(0, false);
  // Second order in omega dt = 1e-5.
  CHECK(collision.restitution == near_relative(1, 1e-9));
  CHECK(collision.viscous_loss == 0);
}

TEST_CASE("friction is cut at what the whole normal force allows, dashpot included") {
  const SpringDashpot law{
      .normal_stiffness = stiffness, .friction = 0.5, .damping_ratio = 0.2, .may_pull = true};
  ContactGeometry geometry;
  geometry.depth = 1e-4;
  const double viscosity = 2 * 0.2 * std::sqrt(stiffness * mass);
  for (const double normal_velocity : {-0.3, 0.0, 0.1, 5.0}) {
    SpringDashpot::History history;
    const ContactForce force = law(geometry,
                                   {.normal_velocity = normal_velocity,
                                    .tangential_velocity = 100,
                                    .time_step = 1,
                                    .effective_mass = mass},
                                   history);
    const double expected = stiffness * 1e-4 - viscosity * normal_velocity;
    CHECK(force.normal == near_relative(expected, 1e-14));
    CHECK(force.tangential == near_relative(-0.5 * std::max(expected, 0.0), 1e-14));
    CHECK(force.viscous_loss >= 0);
  }
}

TEST_CASE("a dashpot evaluated again without time gives the same force and loses nothing") {
  const SpringDashpot law;
  ContactGeometry geometry;
  geometry.depth = 1e-4;
  SpringDashpot::History history;
  ContactMotion motion{.normal_velocity = -0.1,
                       .tangential_velocity = 0.2,
                       .time_step = 1e-5,
                       .effective_mass = mass};
  const ContactForce first = law(geometry, motion, history);
  CHECK(first.viscous_loss > 0);
  motion.time_step = 0;
  const ContactForce again = law(geometry, motion, history);
  CHECK(again.normal == first.normal);
  CHECK(again.tangential == first.tangential);
  CHECK(again.viscous_loss == 0);
  CHECK(again.friction_loss == 0);
}

TEST_CASE("a damping ratio outside [0, 1) is refused by name") {
  const auto message_of = [](const SpringDashpot& law) -> std::string {
    try {
      law.validate();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message_of({}) == "");
  CHECK(message_of({.damping_ratio = 1}) == "SpringDashpot.damping_ratio = 1: must lie in [0, 1)");
  CHECK(message_of({.damping_ratio = -0.2}) ==
        "SpringDashpot.damping_ratio = -0.2: must lie in [0, 1)");
  CHECK(message_of({.normal_stiffness = 0}) ==
        "SpringDashpot.normal_stiffness = 0: must be a finite number above 0");
}
