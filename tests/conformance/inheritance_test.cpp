// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/breakage/inheritance/at_rest.hpp>
#include <riprap/breakage/inheritance/rigid_field.hpp>
#include <riprap/conformance/inheritance.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct WithoutSpin {
  void operator()(const Body& parent, Body& piece) const {
    piece.velocity = parent.velocity_at(piece.position - parent.position);
    piece.angular_velocity = 0;
  }
};

/// The default and something else.
template <class Change>
struct Altered {
  Change change;
  void operator()(const Body& parent, Body& piece) const {
    RigidField{}(parent, piece);
    change(parent, piece);
  }
};

template <class Change>
Violations violations_of(Change change) {
  return inheritance_violations(Altered<Change>{change});
}

}  // namespace

TEST_CASE("the inheritance of riprap obeys the axioms and conserves momentum") {
  CHECK(to_text(inheritance_violations(RigidField{})) == "");
  CHECK(to_text(inheritance_momentum_violations(RigidField{})) == "");
}

TEST_CASE("AtRest obeys the axioms, and leaves the pieces at rest") {
  CHECK(to_text(inheritance_violations(AtRest{})) == "");
  const Violations stopped = inheritance_momentum_violations(AtRest{});
  check_violated(stopped, "the momentum of the pieces is the parent's: difference [N s]");
  check_violated(stopped, "the angular momentum of the pieces is the parent's: difference [N m s]");
  check_violated(stopped, "a velocity added to the parent is added to the pieces");
  CHECK(stopped.size() == 3);
}

TEST_CASE("a user's inheritance obeys the axioms, and may lose angular momentum") {
  CHECK(to_text(inheritance_violations(WithoutSpin{})) == "");
  const Violations lost = inheritance_momentum_violations(WithoutSpin{});
  check_violated(lost, "the angular momentum of the pieces is the parent's: difference [N m s]");
  CHECK(lost.size() == 1);
}

TEST_CASE("an inheritance that makes energy is reported") {
  check_violated(violations_of([](const Body&, Body& piece) { piece.angular_velocity *= 1.001; }),
                 "pieces have no more kinetic energy than their parent: gain [J]");
}

TEST_CASE("an inheritance that changes more than velocities is reported") {
  check_violated(violations_of([](const Body& parent, Body& piece) {
                   piece.position += 1e-9 * parent.velocity;
                 }),
                 "a piece stays where it is");
  check_violated(violations_of([](const Body&, Body& piece) { piece.mass *= 0.999; }),
                 "a piece keeps its mass");
  check_violated(violations_of([](const Body&, Body& piece) { piece.inertia *= 0.999; }),
                 "a piece keeps its inertia");
}
