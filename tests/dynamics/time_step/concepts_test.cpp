// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/core/vec2.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutStep : archetype::TimeStep {
  void time_step() const {}
};
struct WithoutScaling : archetype::TimeStep {
  void mass_scaling() const {}
};
struct NotConst : archetype::TimeStep {
  double time_step(double, double) { return 1; }
};
struct ChangesTheMass : archetype::TimeStep {
  double mass_scaling(double&, double) const { return 1; }
};
struct StepIsNoNumber : archetype::TimeStep {
  Vec2 time_step(double, double) const { return {0, 0}; }
};
struct StepChangesTheMass : archetype::TimeStep {
  double time_step(double&, double) const { return 1; }
};
struct StepChangesTheStiffness : archetype::TimeStep {
  double time_step(double, double&) const { return 1; }
};
struct ScalingIsNotConst : archetype::TimeStep {
  double mass_scaling(double, double) { return 1; }
};
struct ScalingIsNoNumber : archetype::TimeStep {
  Vec2 mass_scaling(double, double) const { return {1, 1}; }
};
struct ScalingChangesTheSmallest : archetype::TimeStep {
  double mass_scaling(double, double&) const { return 1; }
};

static_assert(TimeStep<archetype::TimeStep>);
static_assert(!TimeStep<WithoutStep>);
static_assert(!TimeStep<WithoutScaling>);
static_assert(!TimeStep<NotConst>);
static_assert(!TimeStep<ChangesTheMass>);
static_assert(!TimeStep<StepIsNoNumber>);
static_assert(!TimeStep<StepChangesTheMass>);
static_assert(!TimeStep<StepChangesTheStiffness>);
static_assert(!TimeStep<ScalingIsNotConst>);
static_assert(!TimeStep<ScalingIsNoNumber>);
static_assert(!TimeStep<ScalingChangesTheSmallest>);

}  // namespace

TEST_CASE("a fixed time step without mass scaling is a rule") {
  struct Fixed {
    double time_step(double, double) const { return 1e-6; }
    double mass_scaling(double, double) const { return 1; }
  };
  CHECK(TimeStep<Fixed>);
}
