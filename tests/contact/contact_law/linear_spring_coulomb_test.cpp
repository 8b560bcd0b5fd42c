// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

constexpr LinearSpringCoulomb law{
    .normal_stiffness = 2e7, .tangential_stiffness = 1.2e7, .friction = 0.5};
constexpr double depth = 5e-5;                          // [m], so N = 1000 N
constexpr double cap = 0.5 * 2e7 * depth;               // mu N = 500 N
constexpr double time_step = 1e-6;                      // [s]
constexpr double slip_way = 0.5 * 2e7 * depth / 1.2e7;  // where the spring reaches mu N [m]
constexpr double round_off = 1e-12;                     // relative, for sums of 1000 terms

ContactGeometry pressed(double penetration) {
  ContactGeometry geometry;
  geometry.depth = penetration;
  return geometry;
}

/// What a contact has done on its way.
struct Outcome {
  ContactForce last;
  double friction_loss = 0;  ///< [J]
  double work = 0;           ///< of the tangential force against the motion, trapezoid sum [J]
};

/// Shears a contact of constant depth by `way` [m] in equal steps.
Outcome shear(const LinearSpringCoulomb& spring, double penetration, double way, int steps,
              LinearSpringCoulomb::History& history) {
  Outcome outcome;
  const ContactMotion motion{.tangential_velocity = way / steps / time_step,
                             .time_step = time_step};
  for (int i = 0; i < steps; ++i) {
    const double before = history.tangential_force;
    outcome.last = spring(pressed(penetration), motion, history);
    outcome.friction_loss += outcome.last.friction_loss;
    outcome.work -= 0.5 * (before + outcome.last.tangential) * way / steps;
  }
  return outcome;
}

template <class Change>
std::string message_of(Change change) {
  LinearSpringCoulomb wrong;
  change(wrong);
  try {
    wrong.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the normal force is stiffness times depth, and never pulls") {
  LinearSpringCoulomb::History history;
  CHECK(law(pressed(depth), {}, history).normal == near_relative(1000, 1e-15));
  CHECK(law(pressed(2 * depth), {}, history).normal == near_relative(2000, 1e-15));
  // Bodies that part quickly are not held back: the law has no dashpot and no tension.
  const ContactMotion parting{.normal_velocity = 100, .time_step = time_step};
  CHECK(law(pressed(1e-9), parting, history).normal == near_relative(0.02, 1e-15));
}

TEST_CASE("zero depth gives zero force, however fast the bodies slide") {
  LinearSpringCoulomb::History history;
  const ContactForce force =
      law(pressed(0), {.tangential_velocity = 3, .time_step = time_step}, history);
  CHECK(force.normal == 0);
  CHECK(force.tangential == 0);
  CHECK(force.friction_loss == 0);
  CHECK(law.stored_energy(pressed(0), history) == 0);
}

TEST_CASE("the tangential spring loads and unloads along its stiffness while it sticks") {
  LinearSpringCoulomb::History history;
  const double way = 0.9 * slip_way;
  const Outcome there = shear(law, depth, way, 100, history);
  // Body b moves along the tangent, so the force on it points backwards.
  CHECK(there.last.tangential == near_relative(-1.2e7 * way, round_off));
  CHECK(there.friction_loss == 0);
  const Outcome back = shear(law, depth, -way, 100, history);
  CHECK(std::abs(back.last.tangential) <= round_off * cap);
  CHECK(back.friction_loss == 0);
}

TEST_CASE("what a sticking contact takes up it stores") {
  LinearSpringCoulomb::History history;
  const double before = law.stored_energy(pressed(depth), history);
  CHECK(before == near_relative(0.5 * 2e7 * depth * depth, 1e-15));
  const double way = 0.7 * slip_way;
  const Outcome outcome = shear(law, depth, way, 100, history);
  const double stored = law.stored_energy(pressed(depth), history) - before;
  CHECK(stored == near_relative(0.5 * 1.2e7 * way * way, round_off));
  CHECK(outcome.work == near_relative(stored, round_off));
}

TEST_CASE("a sliding contact resists with the friction coefficient times the normal force") {
  for (const double direction : {1.0, -1.0}) {
    CAPTURE(direction);
    LinearSpringCoulomb::History history;
    CHECK(shear(law, depth, direction * 1.01 * slip_way, 10, history).last.tangential ==
          -direction * cap);
    CHECK(shear(law, depth, direction * 20 * slip_way, 10, history).last.tangential ==
          -direction * cap);
  }
}

TEST_CASE("steady sliding dissipates the friction force times the slip") {
  LinearSpringCoulomb::History history;
  shear(law, depth, 2 * slip_way, 100, history);
  const double way = 30 * slip_way;
  const Outcome steady = shear(law, depth, way, 1000, history);
  CHECK(steady.friction_loss == near_relative(cap * way, round_off));
  CHECK(steady.work == near_relative(steady.friction_loss, round_off));
}

TEST_CASE("stored plus slipped energy is the work done, through stick, slip and reversal") {
  LinearSpringCoulomb::History history;
  double work = 0;
  double friction_loss = 0;
  const double start = law.stored_energy(pressed(depth), history);
  // No step is longer than the slip from one friction limit to the other.
  for (const double way : {0.3, 2.1, -1.7, -3.3, 0.4}) {
    const Outcome part = shear(law, depth, way * slip_way, 37, history);
    work += part.work;
    friction_loss += part.friction_loss;
  }
  const double stored = law.stored_energy(pressed(depth), history) - start;
  // In the one step of each leg in which slip sets in, the law books the slipped part of the way
  // against the mean force, and so does the trapezoid rule: the balance is exact.
  CHECK(work == near_relative(stored + friction_loss, round_off));
  CHECK(friction_loss > 0);
}

TEST_CASE("slip in a closed cycle is the area of the hysteresis loop") {
  LinearSpringCoulomb::History history;
  const double amplitude = 3 * slip_way;
  shear(law, depth, amplitude, 300, history);
  const Outcome forth = shear(law, depth, -2 * amplitude, 600, history);
  const Outcome back = shear(law, depth, 2 * amplitude, 600, history);
  // A parallelogram of height 2 mu N and width 2 (amplitude - slip_way).
  const double loop = 4 * cap * (amplitude - slip_way);
  CHECK(forth.friction_loss + back.friction_loss == near_relative(loop, round_off));
}

TEST_CASE("a tangential spring cut by a falling normal force loses just what it had stored") {
  LinearSpringCoulomb::History history;
  shear(law, depth, 0.8 * slip_way, 10, history);
  const double tangential_before = history.tangential_force;
  const double stored_before = std::pow(tangential_before, 2) / (2 * 1.2e7);
  const ContactForce cut = law(pressed(0.3 * depth), {.time_step = time_step}, history);
  CHECK(cut.tangential == near_relative(-0.3 * cap, 1e-14));
  const double stored_after = std::pow(cut.tangential, 2) / (2 * 1.2e7);
  CHECK(cut.friction_loss == near_relative(stored_before - stored_after, round_off));
  // When the contact opens everything is lost.
  const ContactForce open = law(pressed(0), {.time_step = time_step}, history);
  CHECK(open.friction_loss == near_relative(stored_after, round_off));
  CHECK(history.tangential_force == 0);
}

TEST_CASE("evaluating the law again with a time step of zero repeats the force and loses nothing") {
  for (const double way : {0.5, 5.0}) {
    CAPTURE(way);
    LinearSpringCoulomb::History history;
    const ContactForce first = shear(law, depth, way * slip_way, 10, history).last;
    for (int again = 0; again < 3; ++again) {
      const ContactForce repeated =
          law(pressed(depth), {.normal_velocity = -2, .tangential_velocity = 7}, history);
      CHECK(repeated.normal == first.normal);
      CHECK(repeated.tangential == first.tangential);
      CHECK(repeated.friction_loss == 0);
      CHECK(repeated.viscous_loss == 0);
    }
  }
}

TEST_CASE("the force depends on the displacement, not on its division into steps") {
  LinearSpringCoulomb::History coarse;
  LinearSpringCoulomb::History fine;
  for (const double way : {0.6, -1.1, 0.9}) {
    shear(law, depth, way * slip_way, 1, coarse);
    shear(law, depth, way * slip_way, 1000, fine);
    CHECK(coarse.tangential_force == near_relative(fine.tangential_force, round_off));
  }
}

TEST_CASE("without friction there is neither tangential force nor slip energy") {
  LinearSpringCoulomb smooth = law;
  smooth.friction = 0;
  LinearSpringCoulomb::History history;
  const Outcome outcome = shear(smooth, depth, 3 * slip_way, 10, history);
  CHECK(outcome.last.tangential == 0);
  CHECK(outcome.friction_loss == 0);
}

TEST_CASE("without a tangential spring there is no tangential force and no division by zero") {
  LinearSpringCoulomb loose = law;
  loose.tangential_stiffness = 0;
  LinearSpringCoulomb::History history;
  const Outcome outcome = shear(loose, depth, slip_way, 10, history);
  CHECK(outcome.last.tangential == 0);
  CHECK(outcome.friction_loss == 0);
  CHECK(loose.stored_energy(pressed(depth), history) ==
        near_relative(0.5 * 2e7 * depth * depth, 1e-15));
}

TEST_CASE("the linear law keeps its meaning in other units") {
  // Lengths in mm, masses in t, times in s: forces stay in N, stiffness turns into N/mm.
  const LinearSpringCoulomb in_mm{
      .normal_stiffness = 2e4, .tangential_stiffness = 1.2e4, .friction = 0.5};
  LinearSpringCoulomb::History si;
  LinearSpringCoulomb::History mm;
  const Outcome a = shear(law, depth, 1.7 * slip_way, 10, si);
  const Outcome b = shear(in_mm, 1e3 * depth, 1.7e3 * slip_way, 10, mm);
  CHECK(b.last.normal == near_relative(a.last.normal, 1e-14));
  CHECK(b.last.tangential == near_relative(a.last.tangential, 1e-14));
  CHECK(b.friction_loss == near_relative(1e3 * a.friction_loss, round_off));
}

TEST_CASE("the stiffer of the two springs sets the time step") {
  CHECK(law.peak_stiffness() == 2e7);
  LinearSpringCoulomb sideways = law;
  sideways.tangential_stiffness = 3e7;
  CHECK(sideways.peak_stiffness() == 3e7);
}

TEST_CASE("a linear law with a stiffness or friction that cannot be is refused by name") {
  CHECK(message_of([](auto&) {}) == "");
  CHECK(message_of([](auto& l) { l.normal_stiffness = 0; }) ==
        "LinearSpringCoulomb.normal_stiffness = 0: must be a finite number above 0");
  CHECK(message_of([](auto& l) { l.tangential_stiffness = -1; }) ==
        "LinearSpringCoulomb.tangential_stiffness = -1: must be a finite number, 0 or above");
  CHECK(message_of([](auto& l) { l.friction = -0.1; }) ==
        "LinearSpringCoulomb.friction = -0.1: must be a finite number, 0 or above");
  CHECK(message_of([](auto& l) {
          l.friction = std::numeric_limits<double>::quiet_NaN();
        }).starts_with("LinearSpringCoulomb.friction = nan"));
  CHECK(message_of([](auto& l) {
          l.normal_stiffness = std::numeric_limits<double>::infinity();
        }).starts_with("LinearSpringCoulomb.normal_stiffness = inf"));
}
