#include <doctest/doctest.h>

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

static_assert(TimeStepRule<archetype::TimeStepRule>);
static_assert(!TimeStepRule<WithoutStep>);
static_assert(!TimeStepRule<WithoutScaling>);
static_assert(!TimeStepRule<NotConst>);
static_assert(!TimeStepRule<ChangesTheMass>);

}  // namespace

TEST_CASE("a fixed time step without mass scaling is a rule") {
  struct Fixed {
    double time_step(double, double) const { return 1e-6; }
    double mass_scaling(double, double) const { return 1; }
  };
  CHECK(TimeStepRule<Fixed>);
}
