// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <riprap/output/displacement_picture.hpp>
#include <support/broken_sample.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::BrokenSample;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

/// Particle 0 goes 3 mm east and breaks; one piece goes on, the other stays. Particle 1 goes 5 mm
/// along a bent way, 4 mm of it to the west and 3 mm up.
struct Story {
  BrokenSample sample;
  DisplacementPaths paths;

  Story() {
    paths.record(sample.view());
    sample.move(0, {0.003, 0});
    sample.move(1, {-0.004, 0});
    paths.record(sample.view());
    paths.record_break(sample.view(), sample.split(0));
    sample.move(1, {0, 0.003});
    sample.move(2, {0.002, 0.001});
    paths.record(sample.view());
  }

  [[nodiscard]] std::vector<SvgElement> picture() const {
    return test::svg_elements(
        displacement_picture(sample.particles(), paths, "Displacement paths").document());
  }
  /// What the picture maps by: particles now, and every place they have been.
  [[nodiscard]] AssemblyView view() const {
    std::vector<Vec2> all;
    for (const auto& path : paths.paths())
      all.insert(all.end(), path.points.begin(), path.points.end());
    return AssemblyView(sample.particles(), all);
  }
};

void check_at(const Vec2& drawn, const Vec2& expected) {
  // Rounded to a tenth of a pixel.
  CHECK((drawn - expected).cwiseAbs().maxCoeff() <= 0.051);
}

}  // namespace

TEST_CASE("paths are drawn point by point to the scale of the particles") {
  const Story story;
  const AssemblyView view = story.view();
  const auto lines = test::named(story.picture(), "polyline");
  // Two intact particles first, then the two pieces.
  REQUIRE(lines.size() == 4);
  for (std::size_t id = 0; id < 4; ++id) {
    const auto& points = story.paths.paths()[id].points;
    const auto drawn = lines[id].points();
    REQUIRE(drawn.size() == points.size());
    for (std::size_t k = 0; k < points.size(); ++k) check_at(drawn[k], view(points[k]));
  }
  const auto bent = lines[1].points();
  REQUIRE(bent.size() == 3);
  CHECK((bent[1] - bent[0]).x() == near(-0.004 * view.scale(), 0.101));
  CHECK((bent[2] - bent[1]).y() == near(-0.003 * view.scale(), 0.101));
}

TEST_CASE("pieces have a colour of their own and a dotted branch from where their parent broke") {
  const Story story;
  const AssemblyView view = story.view();
  const auto all = story.picture();
  const auto lines = test::named(all, "polyline");
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].attribute("stroke") == lines[1].attribute("stroke"));
  CHECK(lines[2].attribute("stroke") == lines[3].attribute("stroke"));
  CHECK(lines[0].attribute("stroke") != lines[2].attribute("stroke"));

  std::vector<SvgElement> branches;
  for (const SvgElement& e : test::named(all, "line"))
    if (!e.attribute("stroke-dasharray").empty() && e.number("x1") < view.legend_left())
      branches.push_back(e);
  REQUIRE(branches.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    // 0.013 m is where the centroid of particle 0 was when it broke.
    check_at(branches[k].at("x1", "y1"), view({0.013, 0.005}));
    CHECK(branches[k].at("x2", "y2") == lines[2 + k].points().front());
    CHECK(branches[k].attribute("stroke") == lines[2].attribute("stroke"));
  }
}

TEST_CASE("a dot in the colour of its path marks every particle that is there now") {
  const Story story;
  const AssemblyView view = story.view();
  const auto all = story.picture();
  const auto lines = test::named(all, "polyline");
  std::vector<SvgElement> dots;
  for (const SvgElement& e : test::named(all, "circle"))
    if (e.number("cx") < view.legend_left()) dots.push_back(e);
  const Particles& particles = story.sample.particles();
  REQUIRE(dots.size() == particles.size());
  // The intact particle, then the pieces.
  const std::vector<BodyIndex> order{1, 0, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    check_at(dots[k].at("cx", "cy"), view(particles.body(order[k]).position));
    const SvgElement& line = lines.at(particles.ancestry(order[k]).id);
    CHECK(dots[k].attribute("fill") == line.attribute("stroke"));
    CHECK(dots[k].at("cx", "cy") == line.points().back());
  }
}

TEST_CASE("particles lie below as they are now") {
  const Story story;
  const AssemblyView view = story.view();
  const auto shapes = test::named(story.picture(), "polygon");
  REQUIRE(shapes.size() == 3);
  for (BodyIndex i = 0; i < 3; ++i)
    check_at(shapes[i].points()[0], view(story.sample.particles().ring(i)[0]));
}

TEST_CASE("the legend has a sample for each kind of path and the largest displacement") {
  const Story story;
  const AssemblyView view = story.view();
  const auto all = story.picture();
  const auto lines = test::named(all, "polyline");
  const auto sample = [&](const std::string& name) {
    const SvgElement text = test::text_element(all, name);
    std::vector<SvgElement> found;
    for (const SvgElement& e : test::named(all, "line"))
      if (e.number("x1") > view.legend_left() && e.number("y1") == near(text.number("y") - 5, 0.01))
        found.push_back(e);
    REQUIRE(found.size() == 1);
    return found[0];
  };
  CHECK(sample("intact particle").attribute("stroke") == lines[0].attribute("stroke"));
  CHECK(sample("piece").attribute("stroke") == lines[2].attribute("stroke"));
  CHECK(!sample("parent to piece").attribute("stroke-dasharray").empty());
  // The straight way from start to end, by Pythagoras.
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "5 mm")));
}

TEST_CASE("a platen has no path and no dot, and its way is not the largest displacement") {
  BrokenSample sample;
  sample.add_platen();
  DisplacementPaths paths;
  paths.record(sample.view());
  sample.move(0, {0.003, 0});
  sample.move(2, {0, 0.007});
  paths.record(sample.view());
  const auto all = test::svg_elements(
      displacement_picture(sample.particles(), paths, "Displacement paths").document());
  CHECK(test::named(all, "polyline").size() == 2);
  // Those of the two particles, and two in the legend.
  CHECK(test::named(all, "circle").size() == 4);
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "3 mm")));
}

TEST_CASE("places left behind stay on the sheet, whatever the way") {
  for (const Vec2& way : {Vec2{0.1, 0}, Vec2{-0.1, 0}, Vec2{0, 0.1}, Vec2{0, -0.1}}) {
    BrokenSample sample;
    DisplacementPaths paths;
    paths.record(sample.view());
    sample.move(0, way);
    paths.record(sample.view());
    const auto all = test::svg_elements(
        displacement_picture(sample.particles(), paths, "Displacement paths").document());
    CHECK(test::outside_canvas(all) == "");
  }
  CHECK(test::outside_canvas(Story().picture()) == "");
}

TEST_CASE("a sample that has not moved, or has no record, has a picture too") {
  BrokenSample sample;
  DisplacementPaths paths;
  for (int records = 0; records < 2; ++records) {
    const std::string document =
        displacement_picture(sample.particles(), paths, "Displacement paths").document();
    CHECK(document.find("nan") == std::string::npos);
    CHECK_NOTHROW(static_cast<void>(test::text_element(test::svg_elements(document), "0 m")));
    paths.record(sample.view());
  }
}

TEST_CASE("the same paths give the same bytes") {
  const Story one;
  const Story two;
  CHECK(displacement_picture(one.sample.particles(), one.paths, "").document() ==
        displacement_picture(two.sample.particles(), two.paths, "").document());
}

TEST_CASE("paths to any place have a picture") {
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    Story story;
    story.sample.move(1, {bad, 0});
    story.paths.record(story.sample.view());
    const std::string document =
        displacement_picture(story.sample.particles(), story.paths, "Paths").document();
    const std::size_t left_out = test::left_out_of(document);
    if (!(std::abs(bad) <= 1e100)) CHECK(left_out > 0);
  }
}
