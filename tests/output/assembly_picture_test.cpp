// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <riprap/output/assembly_picture.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::rectangle;
using riprap::test::SvgElement;

namespace {

/// Squares of side 0.9 in rows of twenty, all whole and free.
Particles field(int count) {
  Particles particles(1, 2500);
  for (int i = 0; i < count; ++i)
    particles.add(rectangle({i % 20, i / 20}, 0.9, 0.9), Motion::free);
  return particles;
}

/// Puts two halves of the particle stored at i in its place.
void halve(Particles& particles, BodyIndex i) {
  const Vec2 c = particles.body(i).position;
  const Vec2 size = particles.ring(i)[2] - particles.ring(i)[0];
  const Vec2 off{0.25 * size.x(), 0};
  const Ancestry parent = particles.ancestry(i);
  particles.replace(i, rectangle(c - off, 0.5 * size.x(), size.y()), Motion::free, parent);
  particles.add(rectangle(c + off, 0.5 * size.x(), size.y()), Motion::free, &parent);
}

std::vector<SvgElement> picture(const Particles& particles, const std::vector<double>& ratios) {
  return test::svg_elements(assembly_picture(particles, ratios, "An assembly").document());
}

/// The polygon drawn for particle i, found by its place.
SvgElement polygon_of(const std::vector<SvgElement>& elements, const Particles& particles,
                      BodyIndex i) {
  const auto ring = AssemblyView(particles)(particles.ring(i));
  for (const SvgElement& e : test::named(elements, "polygon")) {
    const auto points = e.points();
    bool same = points.size() == ring.size();
    for (std::size_t k = 0; same && k < ring.size(); ++k)
      // Rounded to a tenth of a pixel.
      same = (points[k] - ring[k]).cwiseAbs().maxCoeff() <= 0.0501;
    if (same) return e;
  }
  throw std::runtime_error("no polygon for " + particle_text(i));
}

std::string fill_of(const std::vector<SvgElement>& elements, const Particles& particles,
                    BodyIndex i) {
  return polygon_of(elements, particles, i).attribute("fill");
}

/// The colour in the legend beside a name.
std::string legend_colour(const std::vector<SvgElement>& elements, const std::string& name) {
  const SvgElement text = test::text_element(elements, name);
  for (const SvgElement& e : test::named(elements, "rect"))
    if (e.attribute("width") != "100%" && std::abs(e.number("y") + 12 - text.number("y")) < 1)
      return e.attribute("fill");
  return {};
}

/// Hue [degrees] of a colour written as hsl(...).
double hue_of(const std::string& colour) {
  double hue = -1;
  CHECK(std::sscanf(colour.c_str(), "hsl(%lf,", &hue) == 1);
  return hue;
}

}  // namespace

TEST_CASE("every particle is one polygon with its own vertices in its own place") {
  Particles particles = field(30);
  particles.add(rectangle({22, 0}, 1, 0.5, 0.3), Motion::strain_field);
  halve(particles, 4);
  const auto all = picture(particles, {});
  CHECK(test::named(all, "polygon").size() == particles.size());
  for (BodyIndex i = 0; i < particles.size(); ++i)
    CHECK_NOTHROW(static_cast<void>(polygon_of(all, particles, i)));
}

TEST_CASE("polygons follow the poses of the bodies") {
  Particles particles = field(20);
  particles.body(7).position += Vec2{0.02, 0.3};
  particles.body(7).rotation = Rotation::from_angle(0.4);
  particles.update_ring(7);
  CHECK_NOTHROW(static_cast<void>(polygon_of(picture(particles, {}), particles, 7)));
}

TEST_CASE("boundary, intact particles and pieces are distinguished, as in the legend") {
  Particles particles = field(21);
  particles.add(rectangle({21, 0}, 1, 1), Motion::strain_field);
  particles.add(rectangle({22, 0}, 1, 1), Motion::prescribed);
  halve(particles, 3);
  const auto all = picture(particles, {});
  const std::string boundary = legend_colour(all, "boundary");
  const std::string intact = legend_colour(all, "intact");
  CHECK(boundary != intact);
  CHECK(fill_of(all, particles, 21) == boundary);
  CHECK(fill_of(all, particles, 22) == boundary);
  for (const BodyIndex i : {0u, 1u, 2u, 4u, 20u}) CHECK(fill_of(all, particles, i) == intact);
  const std::string piece = fill_of(all, particles, 3);
  CHECK(piece != intact);
  CHECK(piece != boundary);
  CHECK(legend_colour(all, "pieces: a colour") != "");
}

TEST_CASE("all pieces of one intact particle have one colour, however often they broke again") {
  Particles particles = field(25);
  halve(particles, 5);                                             // 5 and 25
  halve(particles, 5);                                             // 5 and 26
  halve(particles, static_cast<BodyIndex>(particles.size() - 2));  // 25 and 27
  halve(particles, 6);                                             // 6 and 28
  REQUIRE(particles.size() == 29);
  const auto all = picture(particles, {});
  const std::string first = fill_of(all, particles, 5);
  for (const BodyIndex i : {25u, 26u, 27u}) CHECK(fill_of(all, particles, i) == first);
  CHECK(fill_of(all, particles, 6) != first);
  CHECK(fill_of(all, particles, 28) == fill_of(all, particles, 6));
}

TEST_CASE("five hundred families have five hundred colours, those of near ids far apart") {
  constexpr BodyIndex count = 500;
  Particles particles = field(count);
  for (BodyIndex i = 0; i < count; ++i) halve(particles, i);
  const auto all = test::named(picture(particles, {}), "polygon");
  REQUIRE(all.size() == 2 * count);
  std::set<std::string> colours;
  std::vector<double> hues;
  for (BodyIndex i = 0; i < count; ++i) {
    // Family by family, in the order of the parents.
    colours.insert(all[2 * i].attribute("fill"));
    hues.push_back(hue_of(all[2 * i].attribute("fill")));
  }
  CHECK(colours.size() == count);
  for (std::size_t i = 2; i < count; ++i)
    for (const std::size_t back : {1u, 2u}) {
      const double turn = std::abs(hues[i] - hues[i - back]);
      // The golden angle is 137.5 degrees; twice that is 85 short of a full turn.
      CHECK(std::min(turn, 360 - turn) > 80);
    }
}

TEST_CASE("the radius of a dot at the centroid is the share of failed elements") {
  const Particles particles = field(40);
  const AssemblyView view(particles);
  std::vector<double> ratios(40, 0);
  ratios[3] = 0.1;
  ratios[7] = 0.4;
  ratios[8] = 0.8;
  ratios[9] = 0.005;  // too small to be seen
  const auto all = picture(particles, ratios);
  std::map<int, double> radii;
  for (const SvgElement& e : test::named(all, "circle")) {
    if (e.number("cx") > view.legend_left()) continue;
    for (BodyIndex i = 0; i < 40; ++i)
      if ((view(particles.body(i).position) - e.at("cx", "cy")).cwiseAbs().maxCoeff() <= 0.051)
        radii[static_cast<int>(i)] = e.number("r");
  }
  REQUIRE(radii.size() == 3);
  // A share of 1 is 0.45 of the side of the square that has the mean area, here 0.9 m.
  const double unit = 0.45 * 0.9 * view.scale();
  CHECK(radii.at(3) == near(0.1 * unit, 0.0051));
  CHECK(radii.at(7) == near(0.4 * unit, 0.0051));
  CHECK(radii.at(8) == near(0.8 * unit, 0.0051));
}

TEST_CASE("the legend shows dots to the scale of the picture, and only where there are dots") {
  const Particles particles = field(400);
  const auto all = picture(particles, std::vector<double>(400, 0));
  const double unit = 0.45 * 0.9 * AssemblyView(particles).scale();
  const auto dots = test::named(all, "circle");
  REQUIRE(dots.size() == 3);
  const std::vector<double> ratios{0.1, 0.2, 0.4};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(dots[i].number("r") == near(ratios[i] * unit, 0.0051));
    const SvgElement label = test::text_element(all, to_text(ratios[i]));
    CHECK(label.number("y") - 5 == near(dots[i].number("cy"), 0.011));
  }
  CHECK(test::text_element(all, "failed share Rat").at("x", "y").y() < dots[0].number("cy"));
  const auto bare = picture(particles, {});
  CHECK(test::named(bare, "circle").empty());
  CHECK_THROWS(static_cast<void>(test::text_element(bare, "failed share Rat")));
}

TEST_CASE("everything is on the sheet: round, flat and tall assemblies") {
  for (const auto& [columns, rows] : {std::pair{20, 20}, {30, 2}, {4, 30}}) {
    Particles particles(1, 2500);
    for (int i = 0; i < columns * rows; ++i)
      particles.add(rectangle({i % columns, i / columns}, 0.9, 0.9), Motion::free);
    CAPTURE(columns);
    CHECK(test::outside_canvas(picture(particles, std::vector<double>(particles.size(), 0.5))) ==
          "");
  }
}

TEST_CASE("a picture has its title") {
  CHECK_NOTHROW(static_cast<void>(test::text_element(picture(field(3), {}), "An assembly")));
}

TEST_CASE("an assembly with any positions and any shares has a picture") {
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    Particles particles = field(20);
    particles.body(7).position = {bad, 0};
    particles.update_ring(7);
    const std::vector<double> ratios(20, bad);
    const std::string document = assembly_picture(particles, ratios, "An assembly").document();
    const std::size_t left_out = test::left_out_of(document);
    if (!(std::abs(bad) <= 1e100)) CHECK(left_out > 0);
  }
}
