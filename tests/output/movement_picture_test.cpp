// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/movement_picture.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <support/broken_sample.hpp>
#include <support/extreme_numbers.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::BrokenSample;
using riprap::test::near;
using riprap::test::SvgElement;

namespace {

const std::vector<Move> two_moves{{{0.01, 0.005}, {0.014, 0.008}, true},
                                  {{0.04, 0.005}, {0.034, 0.005}, false}};

AssemblyView view_of(const BrokenSample& sample, const std::vector<Move>& moves) {
  std::vector<Vec2> ends;
  for (const Move& move : moves) {
    ends.push_back(move.from);
    ends.push_back(move.to);
  }
  return AssemblyView(sample.particles(), ends);
}

std::vector<SvgElement> picture(const BrokenSample& sample, const std::vector<Move>& moves) {
  return test::svg_elements(movement_picture(sample.particles(), moves, "Movement").document());
}

/// Shafts, or heads, of the arrows on the sample, without those of the legend.
std::vector<SvgElement> arrows(const std::vector<SvgElement>& all, const AssemblyView& view,
                               const std::string& name) {
  std::vector<SvgElement> out;
  for (const SvgElement& e : test::named(all, name))
    if (box_of(e).high.x() < view.legend_left() && e.attribute("stroke-width").empty())
      out.push_back(e);
  return out;
}

}  // namespace

TEST_CASE("an arrow begins where the move does, ends where it does, and points along it") {
  const BrokenSample sample;
  const AssemblyView view = view_of(sample, two_moves);
  const auto all = picture(sample, two_moves);
  const auto shafts = arrows(all, view, "line");
  const auto heads = arrows(all, view, "polygon");
  REQUIRE(shafts.size() == 2);
  REQUIRE(heads.size() == 2);
  // The boundary's arrows lie below those of the free particles.
  for (std::size_t k = 0; k < 2; ++k) {
    const Move& move = two_moves[1 - k];
    const auto corners = heads[k].points();
    REQUIRE(corners.size() == 3);
    // Rounded to a tenth of a pixel.
    CHECK((shafts[k].at("x1", "y1") - view(move.from)).cwiseAbs().maxCoeff() <= 0.051);
    CHECK((corners[0] - view(move.to)).cwiseAbs().maxCoeff() <= 0.051);
    CHECK((0.5 * (corners[1] + corners[2]) - shafts[k].at("x2", "y2")).norm() <= 0.15);
  }
}

TEST_CASE("free and driven particles have arrows of the colours that the legend names") {
  const BrokenSample sample;
  const AssemblyView view = view_of(sample, two_moves);
  const auto all = picture(sample, two_moves);
  const auto shafts = arrows(all, view, "line");
  REQUIRE(shafts.size() == 2);
  CHECK(shafts[0].attribute("stroke") != shafts[1].attribute("stroke"));
  for (const auto& [name, k] : {std::pair{"boundary", 0u}, {"free particle", 1u}}) {
    const SvgElement text = test::text_element(all, name);
    std::size_t found = 0;
    for (const SvgElement& e : test::named(all, "line"))
      if (e.number("x1") > view.legend_left() && e.number("y1") == near(text.number("y") - 5, 0.01))
        found += e.attribute("stroke") == shafts[k].attribute("stroke");
    CHECK(found == 1);
  }
}

TEST_CASE("the legend has the longest move of a free particle") {
  const BrokenSample sample;
  // By Pythagoras; the boundary's 6 mm do not count.
  CHECK_NOTHROW(static_cast<void>(test::text_element(picture(sample, two_moves), "5 mm")));
}

TEST_CASE("a particle that has not moved has no arrow") {
  const BrokenSample sample;
  const std::vector<Move> still{{{0.01, 0.005}, {0.01, 0.005}, true}};
  const AssemblyView view = view_of(sample, still);
  const auto all = picture(sample, still);
  CHECK(arrows(all, view, "line").empty());
  CHECK(arrows(all, view, "polygon").empty());
  CHECK_NOTHROW(static_cast<void>(test::text_element(all, "0 m")));
}

TEST_CASE("everything is on the sheet, places left behind too") {
  const BrokenSample sample;
  for (const Vec2& from : {Vec2{0.3, 0}, Vec2{-0.3, 0}, Vec2{0, 0.3}, Vec2{0, -0.3}})
    CHECK(test::outside_canvas(picture(sample, {{from, {0.01, 0.005}, true}})) == "");
  CHECK(test::outside_canvas(picture(sample, {})) == "");
}

TEST_CASE("moves to any place have a picture") {
  const BrokenSample sample;
  for (const double bad : test::extreme_numbers) {
    CAPTURE(bad);
    const std::vector<Move> moves{{{0.01, bad}, {bad, 0.008}, true}, {{0, 0}, {bad, bad}, false}};
    const std::string document = movement_picture(sample.particles(), moves, "Movement").document();
    const std::size_t left_out = test::left_out_of(document);
    if (!(std::abs(bad) <= 1e100)) CHECK(left_out == 2);
  }
}
