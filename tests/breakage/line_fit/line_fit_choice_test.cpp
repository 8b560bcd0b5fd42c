// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/line_fit_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/line_fit/weighted_xy_by_mean_stress.hpp>
#include <riprap/conformance/loaded_sample.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

using Choice = LineFitChoice<WeightedXY, WeightedX, WeightedY>;
static_assert(LineFit<Choice>);

// A fit of one's own: the failure plane of the first failed element through the first point.
struct AlongPlane {
  std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                 const FailurePlanes& planes) const {
    if (points.empty() || planes.count == 0) return std::nullopt;
    return Line{points[0].position, planes.directions[0]};
  }
};
struct ForgetsThePlanes {
  std::optional<Line> operator()(std::span<const WeightedPoint>) const { return std::nullopt; }
};

static_assert(LineFit<AlongPlane>);
static_assert(!LineFit<ForgetsThePlanes>);

// By the loads alone.
struct AcrossTheMeanStress {
  std::optional<Line> operator()(const LoadedParticle& particle) const {
    return Line{particle.centroid(), particle.mean_stress().principal().major_direction};
  }
};
struct ToTheFirstLoad {
  std::optional<Line> operator()(const LoadedParticle& particle) const {
    return Line{particle.centroid(), particle.loads()[0].arm_lab.normalized()};
  }
};
using LoadChoice = LineFitChoice<AcrossTheMeanStress, ToTheFirstLoad>;
using MixedChoice = LineFitChoice<WeightedXYByMeanStress, ToTheFirstLoad>;
static_assert(!LineFitOfParticle<Choice>);
static_assert(LoadLineFit<LoadChoice>);
static_assert(LineFitOfParticle<MixedChoice>);
static_assert(!LoadLineFit<MixedChoice>);

template <class Fit>
void check_same(const Fit& fit) {
  FailurePlanes planes;
  planes.directions[0] = Vec2{0.1, 1}.normalized();
  planes.count = 1;
  const Stress2 mean{-1, 3, 0.5};
  const LineFitChoice<WeightedXY, WeightedX, WeightedY, AlongPlane, WeightedXYByMeanStress> choice{
      fit};
  for (const Cloud& cloud :
       {three_points(), scattered_points(), Cloud{{{2, 0}, 1}, {{2, 1}, 1}}, Cloud{}}) {
    const auto chosen = choice(cloud, planes, mean);
    const auto direct = fit_line(fit, cloud, planes, mean);
    REQUIRE(chosen.has_value() == direct.has_value());
    if (!chosen) continue;
    CHECK(chosen->point == direct->point);
    CHECK(chosen->direction == direct->direction);
  }
}

}  // namespace

TEST_CASE("a chosen line fit gives the same bits as the fit itself") {
  check_same(WeightedXY{});
  check_same(WeightedX{});
  check_same(WeightedY{});
  check_same(AlongPlane{});
  check_same(WeightedXYByMeanStress{});
}

TEST_CASE("a choice among fits by loads needs no elements, a mixed one passes both on") {
  const internal::LoadedSample sample = internal::loaded_samples(0.016, 1)[0];
  sample.particle([](const LoadedParticle& particle) {
    const auto first = ToTheFirstLoad{}(particle);
    const auto across = AcrossTheMeanStress{}(particle);
    CHECK(LoadChoice{ToTheFirstLoad{}}(particle)->direction == first->direction);
    CHECK(LoadChoice{AcrossTheMeanStress{}}(particle)->direction == across->direction);
    FailurePlanes planes;
    const Cloud cloud = scattered_points();
    const Stress2 mean{-1, 3, 0.5};
    const auto fitted = WeightedXYByMeanStress{}(cloud, planes, mean);
    CHECK(MixedChoice{ToTheFirstLoad{}}(cloud, planes, mean, particle)->direction ==
          first->direction);
    CHECK(MixedChoice{WeightedXYByMeanStress{}}(cloud, planes, mean, particle)->point ==
          fitted->point);
  });
}
