// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <optional>
#include <span>
#include <support/violated.hpp>

#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/line_fit_choice.hpp>
#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/line_fit/mean_stress_failure_plane.hpp>
#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/breakage/line_fit/mean_tension_line.hpp>
#include <riprap/breakage/line_fit/no_line.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/line_fit/weighted_x.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/breakage/line_fit/weighted_xy_by_mean_stress.hpp>
#include <riprap/breakage/line_fit/weighted_y.hpp>
#include <riprap/conformance/line_fit.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct AlongBedding {
  double angle = 0.4;
  std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                 const FailurePlanes& /*planes*/) const {
    if (points.empty()) return std::nullopt;
    return Line{weighted_moments(points).mean, Vec2{std::cos(angle), std::sin(angle)}};
  }
};

using Choice = LineFitChoice<TotalLeastSquares, WeightedXY, WeightedXYByMeanStress, NoLine>;

using MixedChoice = LineFitChoice<MeanStressLine, WeightedXY>;
using LoadChoice = LineFitChoice<MeanStressLine, LoadedDiameter>;

/// Through a corner's neighbourhood, beside the particle.
struct Beside {
  std::optional<Line> operator()(const LoadedParticle& particle) const {
    std::optional<Line> line = MeanStressLine{}(particle);
    if (line) line->point += 2 * perpendicular(line->direction);
    return line;
  }
};

/// The principal axis, spoilt by `change`.
template <class Change>
struct Altered : TotalLeastSquares {
  Change change;
  std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                 const FailurePlanes& planes) const {
    std::optional<Line> line = TotalLeastSquares::operator()(points, planes);
    change(*line, points);
    return line;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return line_fit_violations(Altered<Change>{{}, change});
}

}  // namespace

TEST_CASE("the line fits of riprap obey the axioms") {
  CHECK(to_text(line_fit_violations(WeightedXY{})) == "");
  CHECK(to_text(line_fit_violations(WeightedX{})) == "");
  CHECK(to_text(line_fit_violations(WeightedY{})) == "");
  CHECK(to_text(line_fit_violations(TotalLeastSquares{})) == "");
  CHECK(to_text(line_fit_violations(FailurePlaneThroughCentroid{})) == "");
  CHECK(to_text(line_fit_violations(MeanTensionLine{})) == "");
  CHECK(to_text(line_fit_violations(WeightedXYByMeanStress{})) == "");
  CHECK(to_text(line_fit_violations(NoLine{})) == "");
  CHECK(to_text(line_fit_violations(Choice{TotalLeastSquares{}})) == "");
  CHECK(to_text(line_fit_violations(Choice{WeightedXY{}})) == "");
  CHECK(to_text(line_fit_violations(Choice{WeightedXYByMeanStress{}})) == "");
  CHECK(to_text(line_fit_violations(Choice{NoLine{}})) == "");
}

TEST_CASE("line fits by the loads obey the axioms and turn with the particle") {
  const auto check = [](const auto& fit) {
    CHECK(to_text(line_fit_violations(fit)) == "");
    CHECK(to_text(line_fit_rotation_violations(fit)) == "");
  };
  check(LoadedDiameter{});
  check(MeanStressLine{});
  check(MeanStressFailurePlane{});
  check(LoadChoice{LoadedDiameter{}});
  check(MixedChoice{MeanStressLine{}});
  check_violated(line_fit_violations(Beside{}),
                 "the line runs through the particle: reach on its other side");
}

TEST_CASE("a user's line fit obeys the axioms") {
  CHECK(to_text(line_fit_violations(AlongBedding{})) == "");
}

TEST_CASE("least squares are exact on points on a straight line, given directions are not") {
  CHECK(to_text(line_fit_collinear_violations(WeightedXY{})) == "");
  CHECK(to_text(line_fit_collinear_violations(WeightedX{})) == "");
  CHECK(to_text(line_fit_collinear_violations(WeightedY{})) == "");
  CHECK(to_text(line_fit_collinear_violations(WeightedXYByMeanStress{})) == "");
  CHECK(to_text(line_fit_collinear_violations(TotalLeastSquares{})) == "");
  CHECK(to_text(line_fit_collinear_violations(NoLine{})) == "");
  CHECK(to_text(line_fit_collinear_violations(Choice{WeightedXY{}})) == "");
  const std::string_view exact = "points on a straight line lie on their line";
  check_violated(line_fit_collinear_violations(FailurePlaneThroughCentroid{}), exact);
  check_violated(line_fit_collinear_violations(MeanTensionLine{}), exact);
  check_violated(line_fit_collinear_violations(AlongBedding{}), exact);
}

TEST_CASE("fits without preferred axes turn with the points, those of X and Y do not") {
  CHECK(to_text(line_fit_rotation_violations(TotalLeastSquares{})) == "");
  CHECK(to_text(line_fit_rotation_violations(FailurePlaneThroughCentroid{})) == "");
  CHECK(to_text(line_fit_rotation_violations(MeanTensionLine{})) == "");
  CHECK(to_text(line_fit_rotation_violations(NoLine{})) == "");
  CHECK(to_text(line_fit_rotation_violations(Choice{TotalLeastSquares{}})) == "");
  const std::string_view turned = "turned points have the turned line";
  check_violated(line_fit_rotation_violations(WeightedXY{}), turned);
  check_violated(line_fit_rotation_violations(WeightedX{}), turned);
  check_violated(line_fit_rotation_violations(WeightedY{}), turned);
  check_violated(line_fit_rotation_violations(WeightedXYByMeanStress{}), turned);
  check_violated(line_fit_rotation_violations(Choice{WeightedXY{}}), turned);
  check_violated(line_fit_rotation_violations(AlongBedding{}), turned);
}

TEST_CASE("a line fit whose line is none, or beside the points, is reported") {
  check_violated(violations_of([](Line& line, auto) { line.direction *= 2; }),
                 "the direction is a unit vector");
  check_violated(
      violations_of([](Line& line, auto) { line.point += perpendicular(line.direction); }),
      "the line runs among the points: reach on its other side");
}

TEST_CASE("a line fit that depends on place or unit of length is reported") {
  check_violated(violations_of([](Line& line, auto) { line.point *= 1.001; }),
                 "shifted points have the shifted line");
  check_violated(
      violations_of([](Line& line, auto) { line.point += 1e-3 * perpendicular(line.direction); }),
      "in other units of length the line is the same");
}

TEST_CASE("a line fit that depends on the unit of stress is reported") {
  check_violated(violations_of([](Line& line, auto points) {
                   line.point += 1e-12 * points[0].stress.s11 * perpendicular(line.direction);
                 }),
                 "in other units of stress the line is the same");
}

TEST_CASE("a line fit that depends on the size of the weights or on order is reported") {
  check_violated(violations_of([](Line& line, auto points) {
                   line.point += 1e-6 * points[0].weight * perpendicular(line.direction);
                 }),
                 "only the ratios of the weights matter");
  check_violated(violations_of([](Line& line, auto points) { line.point = points[0].position; }),
                 "the order of the points does not matter");
}
