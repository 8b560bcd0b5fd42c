// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/output/assembly_view.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;
using riprap::test::PictureBox;
using riprap::test::rectangle;
using riprap::test::SvgElement;

namespace {

/// Three particles whose common box is `width` by `height`, with a corner of it at `low`.
Particles triad(double width, double height, const Vec2& low = {0, 0}) {
  Particles particles(0.016, 2500);
  const Vec2 side{width / 5, height / 5};
  for (const Vec2& share : {Vec2{0.1, 0.1}, Vec2{0.9, 0.5}, Vec2{0.3, 0.9}})
    particles.add(rectangle(low + Vec2{share.x() * width, share.y() * height}, side.x(), side.y()),
                  Motion::free);
  return particles;
}

std::vector<SvgElement> annotated(const AssemblyView& view) {
  Svg svg = view.canvas();
  view.annotate(svg, "An assembly");
  return test::svg_elements(svg.document());
}

/// Length [px] of the scale bar and what its label says [m].
struct ScaleBar {
  double pixels = 0;
  double metres = 0;
  std::string label;
};

ScaleBar scale_bar(const std::vector<SvgElement>& elements) {
  ScaleBar bar;
  for (const SvgElement& e : elements) {
    if (e.name == "line" && e.attribute("stroke-width") == "3")
      bar.pixels = e.number("x2") - e.number("x1");
    const std::size_t space = e.text.find(' ');
    if (e.name != "text" || space == std::string::npos) continue;
    const std::map<std::string, double> units{
        {"um", 1e-6}, {"mm", 1e-3}, {"m", 1}, {"km", 1e3}, {"Mm", 1e6}};
    if (const auto unit = units.find(e.text.substr(space + 1)); unit != units.end()) {
      bar.metres = unit->second * SvgElement::parsed(e.text.substr(0, space));
      bar.label = e.text;
    }
  }
  return bar;
}

}  // namespace

TEST_CASE("a picture keeps the shape of what it shows and has axis 2 upwards") {
  const AssemblyView view(triad(0.3, 0.2));
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec2 p{random.uniform(0, 0.3), random.uniform(0, 0.2)};
    const Vec2 q{random.uniform(0, 0.3), random.uniform(0, 0.2)};
    const Vec2 d = view(q) - view(p);
    // Lengths to scale, to the round-off of pixels below a thousand.
    CHECK(d.x() == near(view.scale() * (q - p).x(), 1e-11));
    CHECK(d.y() == near(-view.scale() * (q - p).y(), 1e-11));
  }
}

TEST_CASE("the larger side of an assembly is 900 pixels, in whatever units") {
  for (const double size : {1e-3, 0.3, 1.0, 50.0}) {
    CHECK(AssemblyView(triad(size, 0.4 * size)).scale() == near(900 / size, 1e-9 / size));
    CHECK(AssemblyView(triad(0.4 * size, size)).scale() == near(900 / size, 1e-9 / size));
  }
}

TEST_CASE("the picture depends neither on the units nor on the distance from the origin") {
  const double size = 0.3;
  const Particles here = triad(size, 0.7 * size);
  const AssemblyView view(here);
  for (const double unit : {1.0, 1e3}) {
    const Vec2 low = size * unit * Vec2{800, -600};
    const Particles there = triad(unit * size, 0.7 * unit * size, low);
    const AssemblyView far(there);
    CHECK(far.canvas().width() == near(view.canvas().width(), 1e-9));
    CHECK(far.canvas().height() == near(view.canvas().height(), 1e-9));
    for (BodyIndex i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        // Round-off of coordinates a thousand sizes away, in pixels.
        CHECK((view(here.ring(i)[k]) - far(there.ring(i)[k])).norm() <= 1e-9);
  }
}

TEST_CASE("a ring is mapped vertex by vertex") {
  const Particles particles = triad(0.3, 0.2);
  const AssemblyView view(particles);
  const std::vector<Vec2> mapped = view(particles.ring(1));
  REQUIRE(mapped.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(mapped[k] == view(particles.ring(1)[k]));
}

TEST_CASE("every particle lies on the sheet, below the title and left of the legend") {
  for (const Vec2& size : {Vec2{1, 1}, Vec2{1, 0.05}, Vec2{0.05, 1}}) {
    const Particles particles = triad(size.x(), size.y());
    const AssemblyView view(particles);
    const PictureBox room{{0, 30}, {view.legend_left(), view.canvas().height()}};
    for (BodyIndex i = 0; i < 3; ++i)
      for (const Vec2& v : view(particles.ring(i))) CHECK(room.holds({v, v}));
  }
}

TEST_CASE("the scale bar is as long as its label says: 1, 2 or 5 times a power of ten") {
  for (double size = 1e-4; size < 1e5; size *= 1.07) {
    CAPTURE(size);
    const AssemblyView view(triad(size, size));
    const ScaleBar bar = scale_bar(annotated(view));
    // Both ends are rounded to a tenth of a pixel.
    CHECK(bar.pixels == near(bar.metres * view.scale(), 0.101));
    const double leading = bar.metres / std::pow(10, std::floor(std::log10(bar.metres) + 1e-9));
    CHECK((leading == near(1, 1e-9) || leading == near(2, 1e-9) || leading == near(5, 1e-9)));
    // Half the legend is 95 pixels; the next longer bar, at most 2.5 times this one, would not fit.
    CHECK(bar.pixels <= 95.01);
    CHECK(2.5 * bar.pixels >= 94.9);
  }
}

TEST_CASE("the label of the scale bar has the unit that suits its length") {
  const auto label = [](double size) {
    return scale_bar(annotated(AssemblyView(triad(size, size)))).label;
  };
  // The bar is at most 95 of the 900 pixels that the assembly has.
  CHECK(label(1e-4) == "10 um");
  CHECK(label(6e-3) == "500 um");
  CHECK(label(1e-2) == "1 mm");
  CHECK(label(0.3) == "20 mm");
  CHECK(label(9.4) == "500 mm");
  CHECK(label(10) == "1 m");
  CHECK(label(9.4e3) == "500 m");
  CHECK(label(1e4) == "1 km");
}

TEST_CASE("points beside the particles widen the picture") {
  const Particles particles = triad(0.3, 0.2);
  const std::vector<Vec2> inside{{0.1, 0.1}};
  CHECK(AssemblyView(particles, inside).scale() == AssemblyView(particles).scale());
  const std::vector<Vec2> beyond{{-0.1, 0.1}, {0.2, 0.25}};
  const AssemblyView view(particles, beyond);
  CHECK(view.scale() == near(900 / 0.4, 1e-9));
  CHECK(view(beyond[0]).x() == near(20, 1e-9));  // the margin on the left
  CHECK(view(beyond[1]).y() == near(50, 1e-9));  // margin and header
}

TEST_CASE("outlines show every particle, driven ones in another tone than free ones") {
  Particles particles = triad(0.3, 0.2);
  particles.body(1).motion = Motion::prescribed;
  const AssemblyView view(particles);
  Svg svg = view.canvas();
  view.outlines(svg, particles);
  const auto shapes = test::named(test::svg_elements(svg.document()), "polygon");
  REQUIRE(shapes.size() == 3);
  CHECK(shapes[0].attribute("fill") == shapes[2].attribute("fill"));
  CHECK(shapes[0].attribute("fill") != shapes[1].attribute("fill"));
  for (BodyIndex i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      // Rounded to a tenth of a pixel.
      CHECK((shapes[i].points()[k] - view(particles.ring(i)[k])).cwiseAbs().maxCoeff() <= 0.051);
}

TEST_CASE("title, axes, scale bar and its label stay on the sheet for assemblies of any size") {
  for (double size = 1e-4; size < 1e5; size *= 1.31)
    for (const Vec2& shape : {Vec2{1, 1}, Vec2{1, 0.1}, Vec2{0.1, 1}}) {
      CAPTURE(size);
      CAPTURE(shape.x());
      const auto all = annotated(AssemblyView(triad(size * shape.x(), size * shape.y())));
      CHECK(test::outside_canvas(all) == "");
    }
}

TEST_CASE("the two axes are named and point right and up") {
  const auto all = annotated(AssemblyView(triad(1, 1)));
  const auto lines = test::named(all, "line");
  REQUIRE(lines.size() == 3);
  const SvgElement& first = lines[0];
  const SvgElement& second = lines[1];
  CHECK(first.number("x2") > first.number("x1"));
  CHECK(first.number("y2") == first.number("y1"));
  CHECK(second.number("x2") == second.number("x1"));
  CHECK(second.number("y2") < second.number("y1"));
  // Each name stands at the end of its axis.
  const auto distance = [&](const std::string& name, const SvgElement& line) {
    return (test::text_element(all, name).at("x", "y") - line.at("x2", "y2")).norm();
  };
  CHECK(distance("axis 1", first) < 10);
  CHECK(distance("axis 2", second) < 10);
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "An assembly")));
}

TEST_CASE("of platens a rim round the sample is seen, and their ends are cut off") {
  Particles particles(1, 1);
  particles.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Motion::free);
  particles.add({{1, -5}, {1.5, -5}, {1.5, 6}, {1, 6}}, Motion::platen);
  const AssemblyView view(particles);
  // The square and a rim of 4 % of its side on all sides are 900 pixels.
  CHECK(view.scale() == near_relative(900 / 1.08, 1e-12));
  const std::vector<Vec2> seen = view(particles.ring(1));
  REQUIRE(seen.size() == 4);
  for (const Vec2& v : seen) {
    CHECK(v.x() <= view(Vec2{1.04, 0}).x() + 1e-9);
    CHECK(v.y() >= view(Vec2{0, 1.04}).y() - 1e-9);
    CHECK(v.y() <= view(Vec2{0, -0.04}).y() + 1e-9);
  }
}

TEST_CASE("what has no place in a picture does not widen it, and is left out") {
  const double plain = AssemblyView(triad(2, 1)).scale();
  for (const double bad : test::extreme_numbers) {
    if (std::abs(bad) <= 1e100) continue;
    CAPTURE(bad);
    Particles particles = triad(2, 1);
    particles.add(rectangle({1, 0.5}, 0.1, 0.1), Motion::free);
    particles.body(3).position.y() = bad;
    particles.update_ring(3);
    const std::vector<Vec2> also{{bad, 0.5}, {0.5, bad}};
    const AssemblyView view(particles, also);
    CHECK(view.scale() == plain);
    Svg svg = view.canvas();
    view.outlines(svg, particles);
    view.annotate(svg, "title");
    CHECK(test::left_out_of(svg.document()) == 1);
  }
}

TEST_CASE("an assembly without extent, or without particles, has a picture") {
  const Particles none(0.016, 2500);
  const std::vector<Vec2> point{{3, 4}};
  for (const AssemblyView& view : {AssemblyView(none), AssemblyView(none, point)}) {
    Svg svg = view.canvas();
    view.annotate(svg, "title");
    CHECK(test::left_out_of(svg.document()) == 0);
    CHECK(view.scale() == 900);
  }
}

TEST_CASE("particles farther apart than any sample have a picture") {
  for (const double far : {1e10, 1e18, 1e90}) {
    CAPTURE(far);
    Particles particles = triad(2, 1);
    particles.body(0).position.x() = far;
    particles.update_ring(0);
    particles.add(rectangle({0, -1}, 4, 1), Motion::platen);
    const AssemblyView view(particles);
    Svg svg = view.canvas();
    view.outlines(svg, particles);
    view.annotate(svg, "title");
    CHECK_NOTHROW(static_cast<void>(test::left_out_of(svg.document())));
  }
}
