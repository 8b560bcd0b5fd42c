// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>

#include <riprap/breakage/trigger/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::BreakageTrigger {
  void operator()() const {}
};
struct NotConst : archetype::BreakageTrigger {
  bool operator()(const FailureCount&) { return true; }
};
struct DecidesNothing : archetype::BreakageTrigger {
  void operator()(const FailureCount&) const {}
};
struct ChangesTheTally : archetype::BreakageTrigger {
  bool operator()(FailureCount&) const { return true; }
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
struct NeededIsNotConst : archetype::BreakageTrigger {
  std::size_t failed_elements_needed(std::size_t) { return 1; }
};
struct NeededIsNoNumber : archetype::BreakageTrigger {
  Vec2 failed_elements_needed(std::size_t) const { return {1, 1}; }
};
struct NeededChangesTheElements : archetype::BreakageTrigger {
  std::size_t failed_elements_needed(std::size_t&) const { return 1; }
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
static_assert(!BreakageTrigger<NeededIsNotConst>);
static_assert(!BreakageTrigger<NeededIsNoNumber>);
static_assert(!BreakageTrigger<NeededChangesTheElements>);

}  // namespace

TEST_CASE("a lambda is a trigger, and so is a function") {
  const auto five = [](const FailureCount& failures) { return failures.failed >= 5; };
  CHECK(BreakageTrigger<decltype(five)>);
  CHECK(BreakageTrigger<bool (*)(const FailureCount&)>);
}

// All ratios of whole numbers up to 130, and numbers just beside them.
TEST_CASE("the fewest elements for a ratio are those at which the comparison turns") {
  for (std::size_t elements = 0; elements <= 130; ++elements)
    for (std::size_t part = 1; part <= elements + 1; ++part)
      for (const double beside : {1 - 1e-15, 1.0, 1 + 1e-15}) {
        const double critical = beside * static_cast<double>(part) /
                                static_cast<double>(std::max<std::size_t>(elements, 1));
        const std::size_t needed = failed_elements_for_ratio(elements, critical);
        const auto reached = [&](std::size_t failed) {
          return FailureCount{.elements = elements, .failed = failed}.ratio() >= critical;
        };
        if (needed <= elements) CHECK(reached(needed));
        if (needed > 0) CHECK_FALSE(reached(needed - 1));
      }
}
