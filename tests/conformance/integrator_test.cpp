// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/integrator.hpp>
#include <riprap/dynamics/integrator/frozen.hpp>
#include <riprap/dynamics/integrator/integrator_choice.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>

using namespace riprap;
using test::check_violated;

namespace {

/// Drift with the old velocity, then kick: unstable, but of the first order.
struct ForwardEuler {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = false;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    drift(body, time_step);
    kick(body, wrench, time_step);
  }
  void second_kick(Body&, const Wrench&, double) const {}
};

/// Bodies do not rotate: breaks the contract, though some programs need it.
struct WithoutTurning {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = false;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, {wrench.force, 0}, time_step);
    drift(body, time_step);
  }
  void second_kick(Body&, const Wrench&, double) const {}
};

struct ClaimsSecondOrder : SymplecticEuler {
  static constexpr int order = 2;
};

/// Verlet whose first kick has the whole impulse of the moment and the second none.
struct TurnsToFirstOrder {
  static constexpr int order = 2;
  static constexpr bool has_second_kick = true;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, {0.5 * wrench.force, wrench.moment}, time_step);
    drift(body, time_step);
  }
  void second_kick(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, {0.5 * wrench.force, 0}, time_step);
  }
};

/// All of the kick at the end of the step, where half of it is expected.
struct LateKick {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = true;
  void advance(Body& body, const Wrench&, double time_step) const { drift(body, time_step); }
  void second_kick(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, wrench, time_step);
  }
};

/// The same, with a first_kick_fraction that states it.
struct DriftThenKick : LateKick {
  double first_kick_fraction() const { return 0; }
};

struct TrueMass {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = false;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    const double scaling = body.mass_scaling;
    kick(body, {scaling * wrench.force, scaling * wrench.moment}, time_step);
    drift(body, time_step);
  }
  void second_kick(Body&, const Wrench&, double) const {}
};

/// The default, and then `change` of the body at the end of the step.
template <class Change>
struct Altered : SymplecticEuler {
  Change change;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    SymplecticEuler::advance(body, wrench, time_step);
    change(body);
  }
};

template <class Change>
Violations violations_of(Change change) {
  return integrator_violations(Altered<Change>{{}, change});
}

}  // namespace

TEST_CASE("the integrators of riprap obey the axioms") {
  CHECK(to_text(integrator_violations(SymplecticEuler{})) == "");
  CHECK(to_text(integrator_violations(VelocityVerlet{})) == "");
}

TEST_CASE("a choice of integrators obeys the axioms with each, but for those of a higher order") {
  using Choice = IntegratorChoice<SymplecticEuler, VelocityVerlet>;
  CHECK(to_text(integrator_violations(Choice{SymplecticEuler{}})) == "");
  CHECK(to_text(integrator_violations(IntegratorChoice<VelocityVerlet>{})) == "");
  // The order, a constant of the type, is the lowest of theirs.
  const Violations better = integrator_violations(Choice{VelocityVerlet{}});
  check_violated(better, "motion has the declared order");
  check_violated(better, "turning has the declared order");
  CHECK(better.size() == 2);
}

// Frozen sets all velocities to zero, so kinetic energy is lost without work.
TEST_CASE("Frozen breaks the axioms of free motion and of work, and no other") {
  const Violations violations = integrator_violations(Frozen{});
  check_violated(violations, "a body without load keeps its velocity");
  check_violated(violations, "a body without load keeps its spin");
  check_violated(violations, "a body without load moves straight on");
  check_violated(violations, "a body without load turns evenly");
  check_violated(violations, "kinetic energy changes by the work over the mean velocity");
  CHECK(violations.size() == 5);
}

TEST_CASE("users' integrators obey the axioms") {
  CHECK(to_text(integrator_violations(ForwardEuler{})) == "");
  CHECK(to_text(integrator_violations(DriftThenKick{})) == "");
}

TEST_CASE("an integrator that leaves out turning breaks that axiom, and no other") {
  const Violations violations = integrator_violations(WithoutTurning{});
  check_violated(violations, "turning has the declared order");
  check_violated(violations, "kinetic energy changes by the work over the mean velocity");
  CHECK(violations.size() == 2);
}

TEST_CASE("an integrator of another order than it declares is reported") {
  check_violated(integrator_violations(ClaimsSecondOrder{}), "motion has the declared order");
  check_violated(integrator_violations(TurnsToFirstOrder{}), "turning has the declared order");
  // The same error in every step, however short.
  check_violated(violations_of([](Body& b) { b.position *= 0.9999; }),
                 "motion has the declared order");
}

TEST_CASE("an integrator that pushes or turns bodies on its own is reported") {
  check_violated(violations_of([](Body& b) { b.velocity *= 0.999; }),
                 "a body without load keeps its velocity");
  check_violated(violations_of([](Body& b) { b.angular_velocity *= 0.999; }),
                 "a body without load keeps its spin");
  check_violated(violations_of([](Body& b) {
                   b.position += Vec2{1e-9, 0};
                 }),
                 "a body without load moves straight on");
  check_violated(violations_of([](Body& b) { b.rotation = b.rotation.turned(1e-9); }),
                 "a body without load turns evenly");
  check_violated(violations_of([](Body& b) { b.rotation.cosine *= 1 + 1e-9; }),
                 "a rotation stays one");
}

TEST_CASE("an integrator whose work is not what is booked for it is reported") {
  const std::string_view work = "kinetic energy changes by the work over the mean velocity";
  check_violated(integrator_violations(LateKick{}), work);
  check_violated(violations_of([](Body& b) { b.velocity *= 0.999; }), work);
}

TEST_CASE("an integrator that ignores the mass scaling is reported") {
  const Violations violations = integrator_violations(TrueMass{});
  check_violated(violations, "scaled mass is mass in motion");
  check_violated(violations, "scaled inertia is inertia in turning");
}

TEST_CASE("an integrator that changes the mass of a body is reported") {
  check_violated(violations_of([](Body& b) { b.mass *= b.mass_scaling; }), "the true mass stays");
  check_violated(violations_of([](Body& b) { b.inertia *= b.mass_scaling; }),
                 "the true inertia stays");
}
