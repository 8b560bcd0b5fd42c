#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <riprap/output/force_chain_picture.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

/// Forces of 200, 400, 100 and 500 N in the order east, north, west, south.
const test::Cross uneven{.depths = {1e-5, 2e-5, 5e-6, 2.5e-5}, .slide = 1e-3};

std::vector<SvgElement> picture(const test::StillSample& sample) {
  return test::svg_elements(
      force_chain_picture(sample.particles(), sample.contacts(), "Forces").document());
}

/// Lines of force in the picture, those of the legend left out.
std::vector<SvgElement> chains(const std::vector<SvgElement>& elements, const AssemblyView& view) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : test::named(elements, "line"))
    if (e.number("x1") < view.legend_left() && e.number("x2") < view.legend_left())
      out.push_back(e);
  return out;
}

void check_at(const Vec2& drawn, const Vec2& expected) {
  // Rounded to a hundredth of a pixel.
  CHECK((drawn - expected).cwiseAbs().maxCoeff() <= 0.0051);
}

}  // namespace

TEST_CASE("a chain runs from centroid to centroid through the contact point") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto lines = chains(picture(sample), view);
  REQUIRE(lines.size() == 8);
  std::size_t k = 0;
  sample.contacts().for_each_touching([&](const auto& c) {
    const SvgElement& first = lines.at(k++);
    const SvgElement& second = lines.at(k++);
    check_at(first.at("x1", "y1"), view(sample.particles().body(c.a).position));
    check_at(first.at("x2", "y2"), view(c.geometry.point));
    CHECK(first.at("x2", "y2") == second.at("x1", "y1"));
    check_at(second.at("x2", "y2"), view(sample.particles().body(c.b).position));
    CHECK(first.attribute("stroke-width") == second.attribute("stroke-width"));
  });
  CHECK(k == 8);
}

TEST_CASE("lines are as wide as normal forces are large, 2.2 pixels for the mean") {
  const test::StillSample sample(uneven);
  const auto lines = chains(picture(sample), AssemblyView(sample.particles()));
  REQUIRE(lines.size() == 8);
  const std::vector<double> forces{200, 400, 100, 500};
  for (std::size_t i = 0; i < 4; ++i)
    // Their mean is 300 N; widths are rounded to a hundredth.
    CHECK(lines[2 * i].number("stroke-width") == near(2.2 * forces[i] / 300, 0.0051));
}

TEST_CASE("widths depend on ratios of forces only") {
  const test::StillSample sample(uneven);
  const test::StillSample soft(uneven, {.normal_stiffness = 2e4});
  const auto lines = chains(picture(sample), AssemblyView(sample.particles()));
  const auto soft_lines = chains(picture(soft), AssemblyView(soft.particles()));
  REQUIRE(lines.size() == soft_lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    CHECK(lines[i].attribute("stroke-width") == soft_lines[i].attribute("stroke-width"));
}

TEST_CASE("tangential forces do not change the picture") {
  test::StillSample sample(uneven);
  const auto before = force_chain_picture(sample.particles(), sample.contacts(), "").document();
  sample.slide(3e-6);
  CHECK(force_chain_picture(sample.particles(), sample.contacts(), "").document() == before);
}

TEST_CASE("the legend names forces that have the width shown") {
  const test::StillSample sample(uneven);
  const AssemblyView view(sample.particles());
  const auto all = picture(sample);
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "normal force")));
  std::vector<double> forces;
  for (const SvgElement& text : test::named(all, "text")) {
    if (!text.text.ends_with(" N")) continue;
    forces.push_back(SvgElement::parsed(text.text.substr(0, text.text.size() - 2)));
    int samples = 0;
    for (const SvgElement& line : test::named(all, "line"))
      if (line.number("x1") > view.legend_left() &&
          std::abs(line.number("y1") - text.number("y") + 5) < 0.1) {
        ++samples;
        CHECK(line.number("stroke-width") == near(2.2 * forces.back() / 300, 0.0051));
      }
    CHECK(samples == 1);
  }
  // 300 N is round already.
  CHECK(forces == std::vector<double>{150, 300, 600, 1200});
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

TEST_CASE("a sample without contacts has outlines, no lines and no numbers of force") {
  const test::StillSample apart(test::Cross{.depths = {-1e-4, -1e-4, -1e-4, -1e-4}});
  const auto all = picture(apart);
  CHECK(chains(all, AssemblyView(apart.particles())).empty());
  CHECK(test::named(all, "polygon").size() == 5);
  for (const SvgElement& text : test::named(all, "text")) CHECK(!text.text.ends_with(" N"));
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
