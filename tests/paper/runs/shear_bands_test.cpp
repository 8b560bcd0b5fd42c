// SPDX-License-Identifier: BSL-1.0
#include <paper/runs/shear_bands.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using riprap::Move;
using riprap::Vec2;
using riprap::test::contains;
using riprap::test::message_of;
using riprap::test::near;
using study::band_share;
using study::shear_around;
using study::Sheared;

namespace {

/// A grid of 21 x 21 particles about the centre, moved by a field.
template <class Field>
std::vector<Move> grid(Field by) {
  std::vector<Move> moves;
  for (int i = -10; i <= 10; ++i)
    for (int k = -10; k <= 10; ++k) {
      const Vec2 from{0.1 * i, 0.1 * k};
      moves.push_back({from, from + by(from), true});
    }
  return moves;
}

}  // namespace

TEST_CASE("uniform strain has its maximum shear everywhere, and rotation and expansion have none") {
  // e11 = .02, e22 = -.04, e12 = .04: half the difference .03, so that the radius is .05.
  const auto strained =
      shear_around(grid([](const Vec2& x) {
                     return Vec2{0.02 * x.x() + 0.05 * x.y() + 1, 0.03 * x.x() - 0.04 * x.y()};
                   }),
                   {1, 1});
  REQUIRE(strained.size() == 441);
  // Least squares of exact data.
  for (const Sheared& s : strained) CHECK(s.shear == near(0.05, 1e-14));
  const auto turned =
      shear_around(grid([](const Vec2& x) {
                     return Vec2{0.1 * x.x() - 0.2 * x.y(), 0.2 * x.x() + 0.1 * x.y()};
                   }),
                   {1, 1});
  for (const Sheared& s : turned) CHECK(s.shear == near(0, 1e-14));
}

TEST_CASE("the boundary does not count, and places are given without the strain so far") {
  auto moves = grid([](const Vec2&) { return Vec2{0, 0}; });
  moves[0].is_free = false;
  const auto all = shear_around(moves, {2, 0.5});
  REQUIRE(all.size() == 440);
  CHECK(all[0].place.x() == near(-1.0 / 2, 1e-15));
  CHECK(all[0].place.y() == near(-0.9 / 0.5, 1e-15));
}

TEST_CASE("a place on a band has more shear around it than one far from it") {
  // Across a smooth band shear falls with the distance, down to nothing.
  const auto axial = shear_around(grid([](const Vec2& x) {
                                    return Vec2{0.1 * std::tanh(2 * x.y()), 0};
                                  }),
                                  {1, 1});
  CHECK(band_share(axial, {0.3, 0.01}) > 0.85);
  CHECK(band_share(axial, {0.3, 0.9}) < 0.2);
}

TEST_CASE("no particles have no bands") {
  CHECK(contains(message_of([] {
                   static_cast<void>(band_share({}, {0, 0}));
                 }),
                 "number of free particles = 0"));
}
