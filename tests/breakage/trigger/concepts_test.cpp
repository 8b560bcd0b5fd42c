// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/conformance/loaded_sample.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::Trigger {
  void operator()() const {}
};
struct NotConst : archetype::Trigger {
  bool operator()(const FailureCount&) { return true; }
};
struct DecidesNothing : archetype::Trigger {
  void operator()(const FailureCount&) const {}
};
struct ChangesTheTally : archetype::Trigger {
  bool operator()(FailureCount&) const { return true; }
};
struct StrengthIsNotConst : archetype::Trigger {
  double strength_factor(ParticleId, double) { return 1; }
};
struct StrengthIsNoNumber : archetype::Trigger {
  Vec2 strength_factor(ParticleId, double) const { return {1, 1}; }
};
struct StrengthChangesTheId : archetype::Trigger {
  double strength_factor(ParticleId&, double) const { return 1; }
};
struct StrengthChangesTheArea : archetype::Trigger {
  double strength_factor(ParticleId, double&) const { return 1; }
};
struct NeededIsNotConst : archetype::Trigger {
  std::size_t failed_elements_needed(std::size_t) { return 1; }
};
struct NeededIsNoNumber : archetype::Trigger {
  Vec2 failed_elements_needed(std::size_t) const { return {1, 1}; }
};
struct NeededChangesTheElements : archetype::Trigger {
  std::size_t failed_elements_needed(std::size_t&) const { return 1; }
};
struct AreaNeeded : archetype::Trigger {
  double failed_area_needed() const { return 0.4; }
};
struct AreaNeededIsNotConst : archetype::Trigger {
  double failed_area_needed() { return 0.4; }
};
struct AreaNeededIsNoNumber : archetype::Trigger {
  Vec2 failed_area_needed() const { return {1, 1}; }
};

struct ByCountAndLoads : archetype::Copyable {
  bool operator()(archetype::Takes<FailureCount>, archetype::Takes<LoadedParticle>) const {
    return true;
  }
};
struct ByBoth : ByCountAndLoads {
  using ByCountAndLoads::operator();
  bool operator()(archetype::Takes<FailureCount>) const { return false; }
};
struct ByCountOrLoads : archetype::Trigger {
  using archetype::Trigger::operator();
  FailureMode operator()(const LoadedParticle&) const { return FailureMode::tension; }
};
struct LoadsGiveAFlag : archetype::Copyable {
  bool operator()(const LoadedParticle&) const { return true; }
};
struct LoadsNotConst : archetype::Copyable {
  FailureMode operator()(const LoadedParticle&) { return FailureMode::tension; }
};
struct LoadsNeedElements : archetype::LoadTrigger {
  std::size_t failed_elements_needed(std::size_t) const { return 1; }
};
struct LoadsNeedArea : archetype::LoadTrigger {
  double failed_area_needed() const { return 0.4; }
};
struct LoadsOverStrength : archetype::LoadTrigger {
  double strength_factor(ParticleId, double) const { return 1; }
};

static_assert(Trigger<archetype::Trigger>);
static_assert(!LoadTrigger<archetype::Trigger>);
static_assert(LoadTrigger<archetype::LoadTrigger>);
static_assert(LoadTrigger<LoadsOverStrength>);
static_assert(HasStrengthFactor<LoadsOverStrength>);
static_assert(!HasStrengthFactor<archetype::LoadTrigger>);
static_assert(!ScreenableTrigger<archetype::LoadTrigger>);
static_assert(Trigger<ByCountAndLoads>);
static_assert(!LoadTrigger<ByCountAndLoads>);
static_assert(Trigger<ByBoth>);
static_assert(Trigger<ByCountOrLoads>);
static_assert(!LoadTrigger<ByCountOrLoads>);
static_assert(!Trigger<LoadsGiveAFlag>);
static_assert(!Trigger<LoadsNotConst>);
static_assert(!Trigger<LoadsNeedElements>);
static_assert(!Trigger<LoadsNeedArea>);
static_assert(!Trigger<AreaNeededIsNotConst>);
static_assert(!Trigger<AreaNeededIsNoNumber>);
static_assert(!ScreenableTrigger<archetype::Trigger>);
static_assert(ScreenableTrigger<AreaNeeded>);
static_assert(!Trigger<NotCallable>);
static_assert(!Trigger<NotConst>);
static_assert(!Trigger<DecidesNothing>);
static_assert(!Trigger<ChangesTheTally>);
static_assert(!Trigger<StrengthIsNotConst>);
static_assert(!Trigger<StrengthIsNoNumber>);
static_assert(!Trigger<StrengthChangesTheId>);
static_assert(!Trigger<StrengthChangesTheArea>);
static_assert(!Trigger<NeededIsNotConst>);
static_assert(!Trigger<NeededIsNoNumber>);
static_assert(!Trigger<NeededChangesTheElements>);

}  // namespace

TEST_CASE("a lambda is a trigger, and so is a function") {
  const auto five = [](const FailureCount& failures) { return failures.failed >= 5; };
  CHECK(Trigger<decltype(five)>);
  CHECK(Trigger<bool (*)(const FailureCount&)>);
}

TEST_CASE("a generic lambda of failed elements is not asked about loads, nor one of loads about "
          "failures") {
  const auto five = [](const auto& failures) { return failures.failed >= 5; };
  CHECK(Trigger<decltype(five)>);
  CHECK_FALSE(LoadTrigger<decltype(five)>);
  const auto loaded = [](const LoadedParticle& particle) {
    return particle.loads().empty() ? FailureMode::intact : FailureMode::shear;
  };
  CHECK(LoadTrigger<decltype(loaded)>);
}

TEST_CASE("a trigger that takes the particle beside the count gets it") {
  internal::LoadedSample{}.particle([](const LoadedParticle& particle) {
    CHECK(fires(ByBoth{{archetype::Copyable{0}}}, FailureCount{}, particle));
    CHECK(fires(FailedElementRatio{}, {.elements = 10, .failed = 4}, particle));
    CHECK_FALSE(fires(FailedElementRatio{}, {.elements = 10, .failed = 3}, particle));
  });
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
