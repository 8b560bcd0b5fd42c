// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/core/vec2.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutStep : archetype::TimeStepRule {
  void time_step() const {}
};
struct WithoutScaling : archetype::TimeStepRule {
  void mass_scaling() const {}
};
struct NotConst : archetype::TimeStepRule {
  double time_step(double, double) { return 1; }
};
struct ChangesTheMass : archetype::TimeStepRule {
  double mass_scaling(double&, double) const { return 1; }
};
struct StepIsNoNumber : archetype::TimeStepRule {
  Vec2 time_step(double, double) const { return {0, 0}; }
};
struct StepChangesTheMass : archetype::TimeStepRule {
  double time_step(double&, double) const { return 1; }
};
struct StepChangesTheStiffness : archetype::TimeStepRule {
  double time_step(double, double&) const { return 1; }
};
struct ScalingIsNotConst : archetype::TimeStepRule {
  double mass_scaling(double, double) { return 1; }
};
struct ScalingIsNoNumber : archetype::TimeStepRule {
  Vec2 mass_scaling(double, double) const { return {1, 1}; }
};
struct ScalingChangesTheSmallest : archetype::TimeStepRule {
  double mass_scaling(double, double&) const { return 1; }
};

static_assert(TimeStepRule<archetype::TimeStepRule>);
static_assert(!TimeStepRule<WithoutStep>);
static_assert(!TimeStepRule<WithoutScaling>);
static_assert(!TimeStepRule<NotConst>);
static_assert(!TimeStepRule<ChangesTheMass>);
static_assert(!TimeStepRule<StepIsNoNumber>);
static_assert(!TimeStepRule<StepChangesTheMass>);
static_assert(!TimeStepRule<StepChangesTheStiffness>);
static_assert(!TimeStepRule<ScalingIsNotConst>);
static_assert(!TimeStepRule<ScalingIsNoNumber>);
static_assert(!TimeStepRule<ScalingChangesTheSmallest>);

}  // namespace

TEST_CASE("a fixed time step without mass scaling is a rule") {
  struct Fixed {
    double time_step(double, double) const { return 1e-6; }
    double mass_scaling(double, double) const { return 1; }
  };
  CHECK(TimeStepRule<Fixed>);
}
