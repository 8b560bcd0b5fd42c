// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/extreme_numbers.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/still_sample.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

/// Forces of 250, 400, 100 and 550 N in the order east, north, west, south.
const test::Cross uneven{.depths = {1.25e-5, 2e-5, 5e-6, 2.75e-5}, .slide = 1e-3};

std::vector<SvgElement> picture(const test::StillSample& sample, const ForceClasses& classes = {}) {
  return test::svg_elements(
      force_chain_picture(sample.particles(), sample.contacts(), "Forces", classes).document());
}

/// Lines of force in the picture, those of the legend left out.
std::vector<SvgElement> chains(const std::vector<SvgElement>& elements, const AssemblyView& view) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : test::named(elements, "line"))
    if (e.number("x1") < view.legend_left() && e.number("x2") < view.legend_left())
      out.push_back(e);
  return out;
}

/// The samples of the classes in the legend; the axes and the scale bar have no round ends.
std::vector<SvgElement> legend(const std::vector<SvgElement>& elements, const AssemblyView& view) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : test::named(elements, "line"))
    if (e.number("x1") > view.legend_left() && !e.attribute("stroke-linecap").empty())
      out.push_back(e);
  return out;
}

/// Of a stroke such as hsl(4,70%,50.00%).
double lightness(const SvgElement& line) {
  const std::string colour = line.attribute("stroke");
  const std::size_t begin = colour.rfind(',') + 1;
  return SvgElement::parsed(colour.substr(begin, colour.rfind('%') - begin));
}

void check_at(const Vec2& drawn, const Vec2& expected) {
  // Rounded to a tenth of a pixel.
  CHECK((drawn - expected).cwiseAbs().maxCoeff() <= 0.051);
}

}  // namespace

TEST_CASE("a chain runs from centroid to centroid through the contact point") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto lines = chains(picture(sample), view);
  REQUIRE(lines.size() == 8);
  // Weakest class first, and within a class in the order of the contacts: west, east, north, south.
  const std::vector<BodyIndex> driven{3, 1, 2, 4};
  sample.contacts().for_each_touching([&](const auto& c) {
    CAPTURE(c.b);
    const auto place = std::find(driven.begin(), driven.end(), c.b) - driven.begin();
    const SvgElement& first = lines.at(2 * static_cast<std::size_t>(place));
    const SvgElement& second = lines.at(2 * static_cast<std::size_t>(place) + 1);
    check_at(first.at("x1", "y1"), view(sample.particles().body(c.a).position));
    check_at(first.at("x2", "y2"), view(c.geometry.point));
    check_at(second.at("x1", "y1"), view(sample.particles().body(c.b).position));
    check_at(second.at("x2", "y2"), view(c.geometry.point));
    CHECK(first.attribute("stroke-width") == second.attribute("stroke-width"));
  });
}

TEST_CASE("across a periodic cell each half of a line stays with its particle") {
  // Two squares of 10 mm that meet through the sides of a cell of 40 mm, 0.01 mm deep.
  const Assembly assembly{.thickness = 0.016,
                          .particles = {{test::rectangle({0.00499, 0}, 0.01, 0.01)},
                                        {test::rectangle({0.035, 0}, 0.01, 0.01)}},
                          .period = {0.04, 0.04}};
  const Simulation sim{Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}), assembly, Rock{}};
  const AssemblyView view(sim.particles());
  const auto all =
      test::svg_elements(force_chain_picture(sim.particles(), sim.contacts(), "Forces").document());
  const auto lines = chains(all, view);
  REQUIRE(lines.size() == 2);
  CHECK(test::outside_canvas(all) == "");
  // Both halves are 5 mm, to the depth of the overlap.
  for (const SvgElement& line : lines)
    CHECK((line.at("x2", "y2") - line.at("x1", "y1")).norm() ==
          near(0.005 * view.scale(), 1e-5 * view.scale() + 0.02));
}

TEST_CASE("a chain ends at a platen") {
  const Assembly assembly{
      .thickness = 0.016,
      .particles = {{test::rectangle({0, 0}, 0.01, 0.01)},
                    {test::rectangle({0, 0.00999}, 0.03, 0.01), Motion::platen}}};
  const Simulation sim{Model{}.criterion(NeverFails{}).boundary(NoBoundary{}), assembly, Rock{}};
  const auto all =
      test::svg_elements(force_chain_picture(sim.particles(), sim.contacts(), "Forces").document());
  CHECK(chains(all, AssemblyView(sim.particles())).size() == 1);
}

TEST_CASE("a line looks like the legend's sample of its class of force") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto all = picture(sample);
  const auto lines = chains(all, view);
  REQUIRE(lines.size() == 8);
  const std::vector<SvgElement> samples = legend(all, view);
  REQUIRE(samples.size() == 6);
  for (std::size_t i = 0; i < 8; ++i) {
    // 100 N; 250 and 400 N; 550 N.
    const std::size_t expected = i < 2 ? 0 : i < 6 ? 1 : 2;
    CAPTURE(i);
    CHECK(lines[i].attribute("stroke-width") == samples[expected].attribute("stroke-width"));
    CHECK(lines[i].attribute("stroke") == samples[expected].attribute("stroke"));
  }
}

TEST_CASE("a stronger class is wider and darker, and drawn over the weaker ones") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto all = picture(sample);
  const auto samples = legend(all, view);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    CHECK(samples[k].number("stroke-width") > samples[k - 1].number("stroke-width") + 0.5);
    CHECK(lightness(samples[k]) < lightness(samples[k - 1]));
  }
  const auto lines = chains(all, view);
  for (std::size_t i = 1; i < lines.size(); ++i)
    CHECK(lines[i].number("stroke-width") >= lines[i - 1].number("stroke-width"));
}

TEST_CASE("classes of one's own are drawn and named; in disorder they are refused") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto all = picture(sample, {{150, 450}});
  const auto samples = legend(all, view);
  REQUIRE(samples.size() == 3);
  for (const char* name : {"below 150 N", "150 to 450 N", "from 450 N"})
    CHECK_NOTHROW(static_cast<void>(test::text_element(all, name)));
  const auto lines = chains(all, view);
  REQUIRE(lines.size() == 8);
  CHECK(lines[0].attribute("stroke") == samples[0].attribute("stroke"));
  CHECK(lines[2].attribute("stroke") == samples[1].attribute("stroke"));
  CHECK(lines[5].attribute("stroke") == samples[1].attribute("stroke"));
  CHECK(lines[7].attribute("stroke") == samples[2].attribute("stroke"));
  CHECK_THROWS_AS(static_cast<void>(picture(sample, {{450, 150}})), InvalidInput);
}

TEST_CASE("tangential forces do not change the picture") {
  test::StillSample sample(uneven);
  const auto before = force_chain_picture(sample.particles(), sample.contacts(), "").document();
  sample.slide(3e-6);
  CHECK(force_chain_picture(sample.particles(), sample.contacts(), "").document() == before);
}

TEST_CASE("the legend names the classes of the paper's Fig. 11, each beside its sample") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto all = picture(sample);
  const auto samples = legend(all, view);
  const std::vector<std::string> names{"below 200 N",   "200 to 500 N",   "500 to 700 N",
                                       "700 to 1000 N", "1000 to 1400 N", "from 1400 N"};
  REQUIRE(samples.size() == names.size());
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "normal force")));
  for (std::size_t k = 0; k < names.size(); ++k) {
    const SvgElement text = test::text_element(all, names[k]);
    CHECK(text.number("y") - 5 == near(samples[k].number("y1"), 0.01));
    // Not over the sample, whose round end reaches half a width further.
    CHECK(text.number("x") > samples[k].number("x2") + 0.5 * samples[k].number("stroke-width"));
  }
}

TEST_CASE("every particle is outlined, driven ones in another tone than free ones") {
  const test::StillSample sample(uneven);
  const auto outlines = test::named(picture(sample), "polygon");
  REQUIRE(outlines.size() == 5);
  for (std::size_t i = 1; i < 5; ++i) {
    CHECK(outlines[i].attribute("fill") == outlines[1].attribute("fill"));
    CHECK(outlines[i].attribute("fill") != outlines[0].attribute("fill"));
  }
}

TEST_CASE("a sample without contacts has outlines and a legend, and no lines") {
  const test::StillSample apart(test::Cross{.depths = {-1e-4, -1e-4, -1e-4, -1e-4}});
  const AssemblyView view(apart.particles());
  const auto all = picture(apart);
  CHECK(chains(all, view).empty());
  CHECK(legend(all, view).size() == 6);
  CHECK(test::named(all, "polygon").size() == 5);
}

TEST_CASE("particles that touch without force leave no line and no broken number") {
  // So small that k_n times depth rounds to zero.
  const test::StillSample sample(uneven, {.normal_stiffness = 1e-320});
  std::size_t touching = 0;
  sample.contacts().for_each_touching([&](const auto& c) {
    ++touching;
    CHECK(c.force.normal == 0);
  });
  REQUIRE(touching == 4);
  const std::string document =
      force_chain_picture(sample.particles(), sample.contacts(), "").document();
  CHECK(document.find("nan") == std::string::npos);
  CHECK(chains(test::svg_elements(document), AssemblyView(sample.particles())).empty());
}

TEST_CASE("everything is on the sheet, and so is the title") {
  const auto all = picture(test::StillSample(uneven));
  CHECK(test::outside_canvas(all) == "");
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "Forces")));
}

TEST_CASE("any forces at any places have a picture") {
  const test::StillSample sample;
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    const test::FakeContacts contacts{
        {test::fake_contact(0, 1, {0, 0}, {0.012, 0}, {1, 0}, bad, bad),
         test::fake_contact(0, 2, {0, 0}, {0, bad}, {0, 1}, 300, 0)}};
    const std::string document =
        force_chain_picture(sample.particles(), contacts, "Forces").document();
    const std::size_t left_out = test::left_out_of(document);
    if (std::isnan(bad)) CHECK(left_out == 3);
    if (std::abs(bad) >= 1e10) CHECK(left_out == 2);
  }
}
