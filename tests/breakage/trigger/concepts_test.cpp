#include <doctest/doctest.h>

#include <riprap/breakage/trigger/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::BreakageTrigger {
  void operator()() const {}
};
struct NotConst : archetype::BreakageTrigger {
  bool operator()(const FailureTally&) { return true; }
};
struct DecidesNothing : archetype::BreakageTrigger {
  void operator()(const FailureTally&) const {}
};
struct ChangesTheTally : archetype::BreakageTrigger {
  bool operator()(FailureTally&) const { return true; }
};
struct StrengthIsNotConst : archetype::BreakageTrigger {
  double strength_factor(ParticleId, double) { return 1; }
};
struct StrengthIsNoNumber : archetype::BreakageTrigger {
  Vec2 strength_factor(ParticleId, double) const { return {1, 1}; }
};
struct StrengthChangesTheId : archetype::BreakageTrigger {
  double strength_factor(ParticleId&, double) const { return 1; }
};
struct StrengthChangesTheArea : archetype::BreakageTrigger {
  double strength_factor(ParticleId, double&) const { return 1; }
};

static_assert(BreakageTrigger<archetype::BreakageTrigger>);
static_assert(!BreakageTrigger<NotCallable>);
static_assert(!BreakageTrigger<NotConst>);
static_assert(!BreakageTrigger<DecidesNothing>);
static_assert(!BreakageTrigger<ChangesTheTally>);
static_assert(!BreakageTrigger<StrengthIsNotConst>);
static_assert(!BreakageTrigger<StrengthIsNoNumber>);
static_assert(!BreakageTrigger<StrengthChangesTheId>);
static_assert(!BreakageTrigger<StrengthChangesTheArea>);

}  // namespace

TEST_CASE("a lambda is a trigger, and so is a function") {
  const auto five = [](const FailureTally& tally) { return tally.failed >= 5; };
  CHECK(BreakageTrigger<decltype(five)>);
  CHECK(BreakageTrigger<bool (*)(const FailureTally&)>);
}
