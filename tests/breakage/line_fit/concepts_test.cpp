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

struct TakesTheMeanStress {
  Line operator()(std::span<const WeightedPoint>, const FailurePlanes&, const Stress2& mean) const {
    return {{mean.s11, mean.s22}, {1, 0}};
  }
};
struct ChangesTheMeanStress {
  Line operator()(std::span<const WeightedPoint>, const FailurePlanes&, Stress2&) const {
    return {};
  }
};
struct TakesBoth : TakesTheMeanStress {
  using TakesTheMeanStress::operator();
  Line operator()(std::span<const WeightedPoint>, const FailurePlanes&) const { return {}; }
};

static_assert(LineFit<TakesTheMeanStress>);
static_assert(LineFit<TakesBoth>);
static_assert(!LineFit<ChangesTheMeanStress>);
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

TEST_CASE("a line fit that takes the mean stress gets it, others do without") {
  const Stress2 mean{3, 4, 0};
  CHECK(fit_line(TakesTheMeanStress{}, {}, {}, mean)->point == Vec2{3, 4});
  CHECK(fit_line(TakesBoth{}, {}, {}, mean)->point == Vec2{3, 4});
  const auto upright = [](std::span<const WeightedPoint>, const FailurePlanes&) {
    return Line{Vec2{1, 2}, Vec2{0, 1}};
  };
  CHECK(fit_line(upright, {}, {}, mean)->point == Vec2{1, 2});
}
