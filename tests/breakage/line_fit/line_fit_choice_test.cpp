// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/line_fit_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/line_fit/weighted_xy_by_mean_stress.hpp>
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
