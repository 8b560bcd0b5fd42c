// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/conformance/loaded_sample.hpp>
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

struct TakesTheParticle : TakesTheMeanStress {
  using TakesTheMeanStress::operator();
  Line operator()(std::span<const WeightedPoint>, const FailurePlanes&, const Stress2&,
                  const LoadedParticle& particle) const {
    return {particle.ring()[0], {1, 0}};
  }
};
struct ChangesTheParticle {
  Line operator()(LoadedParticle&) const { return {}; }
};
struct PointsOrLoads : archetype::LineFit {
  using archetype::LineFit::operator();
  Line operator()(const LoadedParticle&) const { return {}; }
};

static_assert(LoadLineFit<archetype::LoadLineFit>);
static_assert(LineFitOfParticle<archetype::LoadLineFit>);
static_assert(!LoadLineFit<archetype::LineFit>);
static_assert(!LineFitOfParticle<archetype::LineFit>);
static_assert(LineFit<TakesTheParticle>);
static_assert(!LoadLineFit<TakesTheParticle>);
static_assert(LineFitOfParticle<TakesTheParticle>);
static_assert(!LineFit<ChangesTheParticle>);
static_assert(LineFit<PointsOrLoads>);
static_assert(!LoadLineFit<PointsOrLoads>);
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

TEST_CASE("each line fit gets what it takes of points, mean stress and particle") {
  internal::LoadedSample{}.particle([](const LoadedParticle& particle) {
    const Stress2 mean{3, 4, 0};
    CHECK(fit_line(TakesTheParticle{}, {}, {}, mean, particle)->point == particle.ring()[0]);
    CHECK(fit_line(TakesTheMeanStress{}, {}, {}, mean, particle)->point == Vec2{3, 4});
    const auto centre = [](const LoadedParticle& p) { return Line{p.centroid(), Vec2{0, 1}}; };
    CHECK(fit_line(centre, {}, {}, mean, particle)->point == particle.centroid());
  });
}
