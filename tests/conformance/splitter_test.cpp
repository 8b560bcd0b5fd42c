// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <doctest/doctest.h>
#include <optional>
#include <support/violated.hpp>
#include <utility>

#include <riprap/breakage/splitter/no_split.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/conformance/splitter.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct FairCut {
  double least = 0.2;
  std::optional<CutRings> operator()(Ring ring, const Line& line, double /*mean_area*/) const {
    std::optional<CutRings> parts = cut(ring, line, 1e-3);
    if (!parts) return std::nullopt;
    const double smaller =
        std::min(area_properties(parts->left).area, area_properties(parts->right).area);
    if (smaller < least * area_properties(ring).area) return std::nullopt;
    return parts;
  }
  void validate() const {}
};

/// The default with one thing done to its pieces.
template <class Change>
struct Altered : StraightCut {
  Change change;
  std::optional<CutRings> operator()(Ring ring, const Line& line, double mean_area) const {
    std::optional<CutRings> parts = StraightCut::operator()(ring, line, mean_area);
    if (parts) change(*parts);
    return parts;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return splitter_violations(Altered<Change>{{}, change});
}

/// Refuses small pieces on the left only.
struct OneSided {
  double least = 8e-5;  // [m^2]
  std::optional<CutRings> operator()(Ring ring, const Line& line, double /*mean_area*/) const {
    std::optional<CutRings> parts = cut(ring, line);
    if (parts && area_properties(parts->left).area < least) return std::nullopt;
    return parts;
  }
  void validate() const {}
};

/// Cuts a thousandth of the diameter, or a given width, to the left of the line.
struct CutsBeside {
  double width = 0;  // [m]
  std::optional<CutRings> operator()(Ring ring, Line line, double /*mean_area*/) const {
    const double aside = width > 0 ? width : 1e-3 * diameter(ring);
    line.point += aside * perpendicular(line.direction);
    return cut(ring, line);
  }
  void validate() const {}
};

}  // namespace

TEST_CASE("the splitters of riprap obey the axioms") {
  CHECK(to_text(splitter_violations(StraightCut{})) == "");
  CHECK(to_text(splitter_violations(StraightCut{.minimum_area = 0, .maximum_aspect = 1e6})) == "");
  CHECK(to_text(splitter_violations(StraightCut{.dust = true})) == "");
  CHECK(to_text(splitter_unit_violations(StraightCut{}, StraightCut{})) == "");
  CHECK(to_text(splitter_violations(NoSplit{})) == "");
  CHECK(to_text(splitter_unit_violations(NoSplit{}, NoSplit{})) == "");
}

TEST_CASE("a user's splitter obeys the axioms") {
  CHECK(to_text(splitter_violations(FairCut{})) == "");
  CHECK(to_text(splitter_unit_violations(FairCut{}, FairCut{})) == "");
}

TEST_CASE("a splitter that loses or moves rock is reported") {
  check_violated(violations_of([](CutRings& parts) { parts.left[0] *= 1 + 1e-9; }),
                 "the areas of the pieces add up to the whole");
  check_violated(violations_of([](CutRings& parts) {
                   for (Vec2& v : parts.left) v += Vec2{1e-9, 0};
                 }),
                 "the pieces lie where the whole lay: way of their common centroid");
}

TEST_CASE("a splitter with pieces that are no convex rings is reported") {
  check_violated(
      violations_of([](CutRings& parts) { std::reverse(parts.left.begin(), parts.left.end()); }),
      "a piece is convex and counter-clockwise");
  check_violated(violations_of([](CutRings& parts) { parts.right.resize(2); }),
                 "a piece has corners");
}

TEST_CASE("a splitter that exchanges left and right is reported") {
  const Violations swapped =
      violations_of([](CutRings& parts) { std::swap(parts.left, parts.right); });
  check_violated(swapped, "the left piece lies on the left");
  check_violated(swapped, "the right piece lies on the right");
  check_violated(splitter_violations(OneSided{}), "a line turned end for end cuts as well");
  check_violated(splitter_violations(CutsBeside{}), "a line turned end for end swaps the pieces");
}

TEST_CASE("a splitter with a length of its own is reported in other units") {
  check_violated(splitter_unit_violations(OneSided{}, OneSided{}),
                 "what is cut in one unit is cut in another");
  check_violated(splitter_unit_violations(CutsBeside{.width = 1e-3}, CutsBeside{.width = 1e-3}),
                 "pieces are the same in other units");
}
