// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/incremental_displacement.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <support/broken_sample.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::BrokenSample;
using riprap::test::near;

TEST_CASE("a move leads from the place at the beginning to the place now") {
  BrokenSample sample;
  sample.move(0, {0.5, 0.5});
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  const Vec2 first = sample.particles().body(0).position;
  sample.move(0, {0.003, 0});
  sample.move(0, {0.001, -0.002});
  const std::vector<Move> moves = movement.moves(sample.particles());
  REQUIRE(moves.size() == 2);
  CHECK(moves[0].from == first);
  // Round-off of places half a metre from the origin.
  CHECK((moves[0].to - first - Vec2{0.004, -0.002}).norm() <= 1e-15);
  CHECK(moves[0].is_free);
  CHECK(!moves[1].is_free);
  CHECK((moves[1].to - moves[1].from).norm() <= 1e-15);
}

TEST_CASE("a break is no displacement, and the pieces count by their areas") {
  BrokenSample sample;
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  const Vec2 first = sample.particles().body(0).position;
  sample.move(0, {0.003, 0});
  const BreakEvent event = sample.split(0);
  movement.record_break(sample.view(), event);
  CHECK((movement.moves(sample.particles())[0].to - first - Vec2{0.003, 0}).norm() <= 1e-16);

  sample.move(2, {0, 0.004});
  const std::vector<Move> moves = movement.moves(sample.particles());
  REQUIRE(moves.size() == 2);
  // 20 mm by 10 mm, split at 7 mm: body 2 is the new piece on the right of an upright line.
  const double share = event.areas[1] / (event.areas[0] + event.areas[1]);
  CHECK(share == near(0.65, 1e-14));
  CHECK((moves[0].to - first).y() == near(0.004 * share, 1e-16));
}

TEST_CASE("dust stays where it broke off") {
  BrokenSample sample;
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  const Vec2 first = sample.particles().body(0).position;
  sample.move(0, {0.003, 0});
  BreakEvent event = sample.split(0);
  // As if the left piece were dust, and no longer there.
  Particles rest(0.016, 2500);
  Ancestry parent = event.particle;
  const Ring ring = sample.particles().ring(2);
  rest.add(ConvexPolygon{std::vector<Vec2>(ring.begin(), ring.end())}, Motion::free, &parent);
  event.pieces = {no_particle, rest.ancestry(0).id};
  movement.record_break(sample.view(), event);
  CHECK((movement.moves(rest)[0].to - first - Vec2{0.003, 0}).norm() <= 1e-16);
  rest.body(0).position += Vec2{0, 0.004};
  CHECK((movement.moves(rest)[0].to - first - Vec2{0.003, 0.65 * 0.004}).norm() <= 1e-16);
}

TEST_CASE("pieces of pieces belong to the particle there was at the beginning") {
  BrokenSample sample;
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  const Vec2 first = sample.particles().body(0).position;
  movement.record_break(sample.view(), sample.split(0));
  movement.record_break(sample.view(), sample.split(2));
  for (const BodyIndex i : {0u, 2u, 3u}) sample.move(i, {0.001, 0});
  const std::vector<Move> moves = movement.moves(sample.particles());
  REQUIRE(moves.size() == 2);
  CHECK((moves[0].to - first - Vec2{0.001, 0}).norm() <= 1e-16);
}

TEST_CASE("a new beginning replaces the old one: pieces that are there now count for themselves") {
  BrokenSample sample;
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  movement.record_break(sample.view(), sample.split(0));
  sample.move(2, {0.005, 0});
  movement.begin(sample.particles());
  sample.move(2, {0, 0.001});
  const std::vector<Move> moves = movement.moves(sample.particles());
  REQUIRE(moves.size() == 3);
  CHECK((moves[0].to - moves[0].from).norm() <= 1e-16);
  CHECK((moves[2].to - moves[2].from - Vec2{0, 0.001}).norm() <= 1e-16);
}

TEST_CASE("platens do not count") {
  BrokenSample sample;
  sample.add_platen();
  IncrementalDisplacement movement;
  movement.begin(sample.particles());
  sample.move(2, {0, 0.007});
  CHECK(movement.moves(sample.particles()).size() == 2);
}

TEST_CASE("no displacement before the beginning") {
  const BrokenSample sample;
  CHECK(IncrementalDisplacement{}.moves(sample.particles()).empty());
}
