// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/dot_picture.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

const DotLegend shares{
    .quantity = "failed share", .samples = {0.1, 0.4}, .full_value = 0.5, .critical = 0.4};

std::vector<SvgElement> picture(const test::StillSample& sample, const std::vector<double>& values,
                                const DotLegend& legend = shares) {
  return test::svg_elements(dot_picture(sample.particles(), values, legend, "Dots").document());
}

/// Circles on the sample, or in the legend.
std::vector<SvgElement> dots(const std::vector<SvgElement>& all, const AssemblyView& view,
                             bool in_legend) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : test::named(all, "circle"))
    if ((e.number("cx") > view.legend_left()) == in_legend) out.push_back(e);
  return out;
}

}  // namespace

TEST_CASE("a dot's diameter is proportional to the value, and its place is the particle's") {
  const test::StillSample sample;
  const Particles& particles = sample.particles();
  const AssemblyView view(particles);
  const std::vector<double> values{0.1, 0.2, 0.3, 0.05, 0.39};
  const auto drawn = dots(picture(sample, values), view, false);
  REQUIRE(drawn.size() == 5);
  // A square of a side of 16 mm and four of 8.02 mm: the mean side is the full value's diameter.
  const double unit = 0.5 * (0.016 + 4 * 0.00802) / 5 * view.scale() / 0.5;
  for (BodyIndex i = 0; i < 5; ++i) {
    CHECK(drawn[i].number("r") == near(unit * values[i], 0.0051));
    // Rounded to a tenth of a pixel.
    const Vec2 off = drawn[i].at("cx", "cy") - view(particles.body(i).position);
    CHECK(off.cwiseAbs().maxCoeff() <= 0.051);
  }
}

TEST_CASE("nothing is drawn for zero, less, and what is no number") {
  const test::StillSample sample;
  const AssemblyView view(sample.particles());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(dots(picture(sample, {0, -1, nan, 0.1, 0}), view, false).size() == 1);
  CHECK(dots(picture(sample, {}), view, false).empty());
}

TEST_CASE("critical values have another colour, from the bound on, and lie on top") {
  const test::StillSample sample;
  const AssemblyView view(sample.particles());
  const auto all = picture(sample, {0.4, 0.1, 0.3999, 0.9, 0});
  const auto drawn = dots(all, view, false);
  REQUIRE(drawn.size() == 4);
  const auto samples = dots(all, view, true);
  REQUIRE(samples.size() == 2);
  CHECK(samples[0].attribute("fill") != samples[1].attribute("fill"));
  for (const std::size_t k : {0u, 1u}) {
    CHECK(drawn[k].attribute("fill") == samples[0].attribute("fill"));
    CHECK(drawn[2 + k].attribute("fill") == samples[1].attribute("fill"));
  }
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "red: 0.4 or more")));
}

TEST_CASE("the legend has a dot of its size for each sample, beside its value") {
  const test::StillSample sample;
  const AssemblyView view(sample.particles());
  const DotLegend legend{.quantity = "contacts", .samples = {1, 2, 8}, .full_value = 8};
  const auto all = picture(sample, {4, 0, 0, 0, 0}, legend);
  const double unit = dots(all, view, false).at(0).number("r") / 4;
  const auto samples = dots(all, view, true);
  REQUIRE(samples.size() == 3);
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "contacts")));
  for (std::size_t k = 0; k < 3; ++k) {
    // Both radii are rounded to a hundredth, one of them before it was divided and multiplied.
    CHECK(samples[k].number("r") == near(unit * legend.samples[k], 0.0151));
    const SvgElement text = test::text_element(all, to_text(legend.samples[k]));
    CHECK(text.number("y") - 5 == near(samples[k].number("cy"), 0.051));
  }
  // Nothing is critical where nothing is said to be.
  for (const SvgElement& e : test::named(all, "text")) CHECK(e.text.find("red") == e.text.npos);
}

TEST_CASE("a full value that is not positive is refused") {
  const test::StillSample sample;
  DotLegend legend;
  for (const double value : {0.0, -1.0}) {
    legend.full_value = value;
    CHECK_THROWS_AS(static_cast<void>(picture(sample, {}, legend)), InvalidInput);
  }
}

TEST_CASE("everything is on the sheet") {
  // Dots no larger than the particles at the edge of the picture.
  CHECK(test::outside_canvas(picture(test::StillSample(), {0.5, 0.3, 0.3, 0.3, 0.3})) == "");
}

TEST_CASE("any values have a picture") {
  const test::StillSample sample;
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    const std::vector<double> values{0.1, bad, bad, bad, bad};
    DotLegend legend = shares;
    legend.samples = {0.1, bad};
    legend.critical = bad;
    const std::string document = dot_picture(sample.particles(), values, legend, "Dots").document();
    const std::size_t left_out = test::left_out_of(document);
    if (bad >= 1e18) CHECK(left_out >= 4);
  }
}
