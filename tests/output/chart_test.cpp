// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/output/chart.hpp>
#include <support/extreme_numbers.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::PictureBox;
using riprap::test::SvgElement;

namespace {

/// Tick labels of one axis, read back from the picture.
struct Scale {
  std::vector<double> values;
  std::vector<double> pixels;

  [[nodiscard]] double step() const { return values[1] - values[0]; }
  [[nodiscard]] double pixels_per_step() const { return pixels[1] - pixels[0]; }
  /// The value that a reader of the chart finds at a pixel.
  [[nodiscard]] double read(double pixel) const {
    return values.front() + (pixel - pixels.front()) / (pixels.back() - pixels.front()) *
                                (values.back() - values.front());
  }
};

/// A chart read back from its picture.
struct Drawn {
  std::vector<SvgElement> elements;
  PictureBox frame;
  Scale x;
  Scale y;
  std::vector<std::vector<Vec2>> curves;

  explicit Drawn(const Chart& chart) {
    Svg svg(600, 380);
    chart.draw(svg, {0, 0}, {600, 380});
    elements = test::svg_elements(svg.document());
    frame = box_of(test::named(elements, "rect").at(1));
    for (const SvgElement& e : test::named(elements, "text")) {
      // Numbers stand below the frame, centred, or to its left.
      if (e.attribute("text-anchor") == "end") {
        y.values.push_back(SvgElement::parsed(e.text));
        y.pixels.push_back(e.number("y") - 4);
      } else if (e.number("font-size") == 12 && e.number("y") > frame.high.y() &&
                 e.attribute("fill").empty()) {
        x.values.push_back(SvgElement::parsed(e.text));
        x.pixels.push_back(e.number("x"));
      }
    }
    for (const SvgElement& e : test::named(elements, "polyline")) curves.push_back(e.points());
  }
};

Chart chart_of(std::vector<Vec2> points) {
  return {"title", "abscissa", "ordinate", {{"name", std::move(points)}}};
}

void check_ticks_are_round(const Scale& scale) {
  REQUIRE(scale.values.size() >= 3);
  CHECK(scale.values.size() <= 8);
  // Each label is off by the round-off of a double.
  const double largest = std::max(std::abs(scale.values.front()), std::abs(scale.values.back()));
  const double round_off = 4e-16 * largest;
  const double decade = std::pow(10, std::floor(std::log10(scale.step()) + 1e-6));
  const double leading = std::round(scale.step() / decade);
  const double step = leading * decade;
  CAPTURE(scale.step());
  CHECK((leading == 1 || leading == 2 || leading == 5));
  for (std::size_t i = 0; i < scale.values.size(); ++i) {
    const double v = scale.values[i];
    CHECK(v == near(step * std::round(v / step), round_off));
    if (i > 0) CHECK(v - scale.values[i - 1] == near(step, 2 * round_off));
  }
}

/// Both axes of a chart of random points of a given spread about a given centre.
void check_random_chart(Random& random, double centre, double spread) {
  CAPTURE(centre);
  CAPTURE(spread);
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i)
    points.push_back(
        {centre + random.uniform(-spread, spread), -centre + random.uniform(-spread, spread)});
  const Drawn drawn(chart_of(points));
  check_ticks_are_round(drawn.x);
  check_ticks_are_round(drawn.y);
  REQUIRE(drawn.curves.size() == 1);
  REQUIRE(drawn.curves[0].size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& p = drawn.curves[0][i];
    // All pixels are rounded to 0.005; the axis is at least three ticks long, and no tick is less
    // than 40 pixels, so that an interpolated place is off by less than 0.02.
    CHECK(drawn.x.read(p.x()) == near(points[i].x(), 0.02 / 40 * drawn.x.step()));
    CHECK(drawn.y.read(p.y()) == near(points[i].y(), 0.02 / 40 * drawn.y.step()));
    // A datum may lie by a fiftieth of a tick beyond the end of its axis.
    const Vec2 hair{0.0201 * std::abs(drawn.x.pixels_per_step()) + 0.01,
                    0.0201 * std::abs(drawn.y.pixels_per_step()) + 0.01};
    CHECK(PictureBox{drawn.frame.low - hair, drawn.frame.high + hair}.holds({p, p}));
  }
}

}  // namespace

TEST_CASE("ticks are 1, 2 or 5 times a power of ten and show where the data lie") {
  Random random(5);
  for (int decade = -6; decade <= 6; ++decade)
    for (int i = 0; i < 10; ++i) {
      const double spread = std::pow(10, decade) * random.uniform(1, 10);
      check_random_chart(random, 0, spread);
      check_random_chart(random, 300 * random.uniform(-1, 1) * spread, spread);
    }
}

TEST_CASE("the ends of an axis are the ticks next to the data and no further") {
  const Drawn drawn(chart_of({{0, -0.31}, {20, 0.62}}));
  CHECK(drawn.x.values == std::vector<double>{0, 5, 10, 15, 20});
  CHECK(drawn.y.values.front() == -0.4);
  CHECK(drawn.y.values.back() == 0.8);
  CHECK(drawn.y.step() == near(0.2, 1e-15));
  // The axes run along the frame: first and last tick at its sides, larger ordinates further up.
  CHECK(drawn.x.pixels.front() == drawn.frame.low.x());
  CHECK(drawn.x.pixels.back() == near(drawn.frame.high.x(), 0.01));
  CHECK(drawn.y.pixels.front() == near(drawn.frame.high.y(), 0.01));
  CHECK(drawn.y.pixels.back() == near(drawn.frame.low.y(), 0.01));
}

TEST_CASE("round-off beyond a tick does not lengthen an axis") {
  const Drawn drawn(chart_of({{0.1 - 1e-15, 0}, {20 + 1e-12, 1 + 1e-12}}));
  CHECK(drawn.x.values == std::vector<double>{0, 5, 10, 15, 20});
  CHECK(drawn.y.values.back() == 1);
}

TEST_CASE("zero is never labelled as minus zero") {
  const Drawn drawn(chart_of({{-0.3, -0.3}, {0.1, 0.7}}));
  for (const SvgElement& e : test::named(drawn.elements, "text")) CHECK(e.text != "-0.0");
  CHECK(std::count(drawn.y.values.begin(), drawn.y.values.end(), 0.0) == 1);
  CHECK(std::count(drawn.x.values.begin(), drawn.x.values.end(), 0.0) == 1);
}

TEST_CASE("a single point, constant data and no data at all have axes of unit length") {
  for (const std::vector<Vec2>& points :
       {std::vector<Vec2>{{3, 2}}, std::vector<Vec2>{{3, 2}, {3, 2}, {3, 2}}, std::vector<Vec2>{},
        std::vector<Vec2>{{0, 0}}}) {
    const Drawn drawn(chart_of(points));
    check_ticks_are_round(drawn.x);
    check_ticks_are_round(drawn.y);
    CHECK(drawn.x.values.back() - drawn.x.values.front() == near(1, 0.5));
    REQUIRE(drawn.curves.size() == (points.empty() ? 0 : 1));
    for (const Vec2& p : points.empty() ? points : drawn.curves[0]) {
      CHECK(drawn.frame.holds({p, p}));
      CHECK(drawn.x.read(p.x()) == near(points[0].x(), 1e-3));
      CHECK(drawn.y.read(p.y()) == near(points[0].y(), 1e-3));
    }
  }
}

TEST_CASE("data that are constant in one direction only keep the scale of the other") {
  const Drawn drawn(chart_of({{0, 2e6}, {10, 2e6}, {20, 2e6}}));
  CHECK(drawn.x.values == std::vector<double>{0, 5, 10, 15, 20});
  check_ticks_are_round(drawn.y);
  for (const Vec2& p : drawn.curves.at(0)) CHECK(drawn.y.read(p.y()) == near(2e6, 1e-3));
}

TEST_CASE("all series of a chart share its axes") {
  Chart chart = chart_of({{0, 0}, {1, 1}});
  chart.series.push_back({"second", {{5, -40}, {10, 20}}, "#d9661f"});
  const Drawn drawn(chart);
  CHECK(drawn.x.values.back() == 10);
  CHECK(drawn.y.values.front() == -40);
  CHECK(drawn.y.values.back() == 20);
  REQUIRE(drawn.curves.size() == 2);
  CHECK(drawn.x.read(drawn.curves[1][0].x()) == near(5, 0.01));
  CHECK(drawn.y.read(drawn.curves[1][0].y()) == near(-40, 0.1));
}

TEST_CASE("a chart carries its title, the names of its axes and its series") {
  Chart chart{"Mobilised friction", "axial strain [%]", "sin phi < 1 & more", {}};
  chart.series.push_back({"measured", {{0, 0}, {1, 1}}, "#1f6fb4"});
  chart.series.push_back({"eq. 14", {{0, 0}, {1, 0.5}}, "#d9661f", true});
  chart.series.push_back({"", {{0, 0}, {1, 0.2}}, "#777777"});
  const Drawn drawn(chart);
  const auto text = [&](const std::string& content) {
    return test::text_element(drawn.elements, content);
  };
  // Over the frame, below its numbers, and turned on its left.
  CHECK(text("Mobilised friction").number("y") < drawn.frame.low.y());
  CHECK(text("axial strain [%]").number("y") > drawn.frame.high.y() + 18);
  CHECK(text("sin phi < 1 & more").attribute("transform").starts_with("rotate(-90.00 "));
  CHECK(text("sin phi < 1 & more").number("x") < drawn.frame.low.x());
  // Beside each name a sample of its line, to the right of the frame.
  for (const std::string name : {"measured", "eq. 14"}) {
    const SvgElement label = text(name);
    CHECK(label.number("x") > drawn.frame.high.x());
    int samples = 0;
    for (const SvgElement& line : test::named(drawn.elements, "line"))
      if (line.number("y1") == label.number("y") - 4 && line.number("x1") > drawn.frame.high.x()) {
        ++samples;
        const bool first = name == "measured";
        CHECK(line.attribute("stroke") == (first ? "#1f6fb4" : "#d9661f"));
        CHECK(line.attribute("stroke-dasharray").empty() == first);
      }
    CHECK(samples == 1);
  }
  CHECK(text("measured").number("y") < text("eq. 14").number("y"));
  // A series without a name has a curve and no entry in the legend.
  const auto curves = test::named(drawn.elements, "polyline");
  REQUIRE(curves.size() == 3);
  CHECK(curves[1].attribute("stroke-dasharray") == "6 4");
  CHECK(curves[2].attribute("stroke") == "#777777");
  int legend_lines = 0;
  for (const SvgElement& line : test::named(drawn.elements, "line"))
    legend_lines += line.number("x1") > drawn.frame.high.x() + 1;
  CHECK(legend_lines == 2);
}

TEST_CASE("marks stand at the points, with or without a line through them") {
  Chart chart = chart_of({{0, 0}, {2, 10}});
  chart.series[0].mark = Mark::circle;
  chart.series.push_back({"squares", {{1, 2}}, "#d9661f"});
  chart.series[1].mark = Mark::square;
  chart.series[1].line = false;
  chart.series.push_back({"triangles", {{1, 4}, {2, 6}}, "#2e8b57"});
  chart.series[2].mark = Mark::triangle;
  chart.series[2].line = false;
  const Drawn drawn(chart);
  REQUIRE(drawn.curves.size() == 1);
  // The last of each kind belongs to the legend.
  const auto circles = test::named(drawn.elements, "circle");
  REQUIRE(circles.size() == 3);
  for (std::size_t i = 0; i < 2; ++i) CHECK(circles[i].at("cx", "cy") == drawn.curves[0][i]);
  CHECK(circles[2].number("cy") == test::text_element(drawn.elements, "name").number("y") - 4);
  const auto rects = test::named(drawn.elements, "rect");  // canvas, frame, mark, legend
  REQUIRE(rects.size() == 4);
  const PictureBox square = box_of(rects[2]);
  CHECK(drawn.x.read(0.5 * (square.low + square.high).x()) == near(1, 1e-3));
  CHECK(drawn.y.read(0.5 * (square.low + square.high).y()) == near(2, 1e-2));
  CHECK(rects[3].attribute("fill") == "#d9661f");
  const auto triangles = test::named(drawn.elements, "polygon");
  REQUIRE(triangles.size() == 3);
  CHECK(drawn.x.read(triangles[1].points()[0].x()) == near(2, 1e-3));
  CHECK(triangles[1].attribute("fill") == "#2e8b57");
  // In the legend only the first series has a line.
  int samples = 0;
  for (const SvgElement& line : test::named(drawn.elements, "line"))
    samples += line.number("x1") > drawn.frame.high.x() + 1;
  CHECK(samples == 1);
}

TEST_CASE("error bars reach as far as they say, and the axis with them") {
  Chart chart = chart_of({{0, 10}, {1, 20}, {2, 15}});
  chart.series[0].y_errors = {1, 5.5, 0};
  const Drawn drawn(chart);
  // From 9 to 25.5 in steps of 5; the points alone would end at 20.
  CHECK(drawn.y.values == std::vector<double>{5, 10, 15, 20, 25, 30});
  std::vector<SvgElement> bars;
  for (const SvgElement& line : test::named(drawn.elements, "line"))
    if (line.attribute("stroke") == "#1f6fb4" && line.number("x1") == line.number("x2"))
      bars.push_back(line);
  REQUIRE(bars.size() == 2);  // none where the error is zero
  const std::vector<Vec2> ends{{9, 11}, {14.5, 25.5}};
  for (std::size_t i = 0; i < 2; ++i) {
    // All pixels are rounded to 0.005.
    CHECK(bars[i].number("x1") == near(drawn.curves[0][i].x(), 0.011));
    CHECK(drawn.y.read(bars[i].number("y1")) == near(ends[i].x(), 0.002));
    CHECK(drawn.y.read(bars[i].number("y2")) == near(ends[i].y(), 0.002));
  }
}

TEST_CASE("a logarithmic axis gives every decade the same length") {
  Chart chart = chart_of({{0.5, 1}, {5, 2}, {14, 3}});
  chart.x_scale = AxisScale::logarithmic;
  const Drawn drawn(chart);
  CHECK(drawn.x.values == std::vector<double>{0.5, 1, 2, 5, 10, 20});
  CHECK(drawn.x.pixels.front() == drawn.frame.low.x());
  CHECK(drawn.x.pixels.back() == near(drawn.frame.high.x(), 0.01));
  const double decade = drawn.x.pixels[4] - drawn.x.pixels[1];
  CHECK(drawn.x.pixels[3] - drawn.x.pixels[0] == near(decade, 0.02));
  CHECK(drawn.x.pixels[2] - drawn.x.pixels[1] == near(decade * std::log10(2.0), 0.02));
  CHECK(drawn.curves[0][1].x() == near(drawn.x.pixels[3], 0.011));
  check_ticks_are_round(drawn.y);

  Chart upright = chart_of({{1, 0.5}, {2, 14}});
  upright.y_scale = AxisScale::logarithmic;
  CHECK(Drawn(upright).y.values == std::vector<double>{0.5, 1, 2, 5, 10, 20});
}

TEST_CASE("charts that cannot be drawn are refused") {
  using test::message_of;
  Chart chart = chart_of({{0, 1}, {1, 2}});
  chart.series[0].y_errors = {1};
  CHECK(message_of([&] { (void)Drawn(chart); }) ==
        "number of error bars of series \"name\" = 1: must be 0 or the number of points");
}

TEST_CASE("charts stand in rows of two, each in its own cell") {
  for (const std::size_t count : {1u, 2u, 3u, 6u}) {
    CAPTURE(count);
    const std::vector<Chart> charts(count, chart_of({{0, -12345}, {20, 100}}));
    const Svg sheet = chart_sheet(charts);
    CHECK(sheet.width() == (count == 1 ? 600 : 1200));
    CHECK(sheet.height() == 380 * std::ceil(static_cast<double>(count) / 2));
    const auto all = test::svg_elements(sheet.document());
    CHECK(test::outside_canvas(all) == "");
    const auto rects = test::named(all, "rect");
    REQUIRE(rects.size() == count + 1);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 corner{600 * static_cast<double>(i % 2), 380 * static_cast<double>(i / 2)};
      CHECK(PictureBox{corner, corner + Vec2{600, 380}}.holds(box_of(rects[i + 1])));
    }
  }
}

TEST_CASE("a chart is the same wherever it stands on the sheet") {
  const Chart chart = chart_of({{0, 3}, {20, 100}, {30, 50}});
  const auto all = test::svg_elements(chart_sheet({chart, chart, chart, chart}).document());
  const auto curves = test::named(all, "polyline");
  REQUIRE(curves.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 shift{600 * static_cast<double>(i % 2), 380 * static_cast<double>(i / 2)};
      const Vec2 off = curves[i].points()[k] - curves[0].points()[k] - shift;
      // Both places are rounded to a hundredth of a pixel.
      CHECK(off.cwiseAbs().maxCoeff() <= 0.0101);
    }
}

TEST_CASE("a chart of any numbers is drawn: what has no place is left out, and the chart says so") {
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic})
    for (const double bad : test::extreme_numbers) {
      CAPTURE(bad);
      Chart chart = chart_of({{1, 2}, {bad, 3}, {3, bad}, {bad, bad}, {4, 5}});
      chart.x_scale = chart.y_scale = scale;
      chart.series[0].mark = Mark::triangle;
      chart.series[0].y_errors = {1, 0.5, bad, bad, 1};
      Svg svg(600, 380);
      chart.draw(svg, {0, 0}, {600, 380});
      const std::size_t left_out = test::left_out_of(svg.document());
      CHECK(left_out == svg.left_out());
      if (!ChartAxis::has_place(scale, bad)) CHECK(left_out > 0);
    }
}

TEST_CASE("what is not finite does not move the axes and leaves a gap in the curve") {
  const double nan = std::nan("");
  const Drawn plain(chart_of({{0, 1}, {1, 3}}));
  const Drawn drawn(chart_of({{0, 1}, {nan, 2}, {0.5, HUGE_VAL}, {1, 3}}));
  CHECK(drawn.x.values == plain.x.values);
  CHECK(drawn.y.values == plain.y.values);
  CHECK(drawn.curves.size() == 2);
}

TEST_CASE("numbers that are all equal, and none at all, make a chart") {
  for (const double value : {0.0, 1e300, -1e300, 1e18}) {
    CAPTURE(value);
    Svg svg(600, 380);
    chart_of({{value, value}, {value, value}}).draw(svg, {0, 0}, {600, 380});
    CHECK(test::left_out_of(svg.document()) == 0);
  }
  const double nan = std::nan("");
  Svg svg(600, 380);
  chart_of({{nan, nan}}).draw(svg, {0, 0}, {600, 380});
  CHECK(test::left_out_of(svg.document()) == 1);
}
