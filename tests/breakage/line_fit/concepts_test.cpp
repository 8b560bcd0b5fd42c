// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/breakage/line_fit/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::LineFit {
  void operator()() const {}
};
struct NotConst : archetype::LineFit {
  Line operator()(std::span<const WeightedPoint>, const FailurePlanes&) { return {}; }
};
struct BareDirection : archetype::LineFit {
  Vec2 operator()(std::span<const WeightedPoint>, const FailurePlanes&) const { return {1, 0}; }
};
struct ChangesThePoints : archetype::LineFit {
  Line operator()(std::span<WeightedPoint>, const FailurePlanes&) const { return {}; }
};
struct ChangesThePlanes : archetype::LineFit {
  Line operator()(std::span<const WeightedPoint>, FailurePlanes&) const { return {}; }
};
struct ChangesTheSpan : archetype::LineFit {
  Line operator()(std::span<const WeightedPoint>&, const FailurePlanes&) const { return {}; }
};

static_assert(LineFit<archetype::LineFit>);
static_assert(!LineFit<NotCallable>);
static_assert(!LineFit<NotConst>);
static_assert(!LineFit<BareDirection>);
static_assert(!LineFit<ChangesThePoints>);
static_assert(!LineFit<ChangesThePlanes>);
static_assert(!LineFit<ChangesTheSpan>);

}  // namespace

TEST_CASE("a line fit that always has a line need not make it optional") {
  const auto upright = [](std::span<const WeightedPoint> points, const FailurePlanes&) {
    return Line{points.front().position, Vec2{0, 1}};
  };
  CHECK(LineFit<decltype(upright)>);
}
