// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/displacement_paths.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/simulation/break_event.hpp>
#include <support/broken_sample.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::BrokenSample;
using riprap::test::near;

TEST_CASE("a path holds the centroid at each record, in order") {
  BrokenSample sample;
  DisplacementPaths paths;
  std::vector<Vec2> expected;
  for (int k = 0; k < 4; ++k) {
    sample.move(0, {0.001 * k, -0.0005 * k * k});
    expected.push_back(sample.particles().body(0).position);
    paths.record(sample.view());
  }
  REQUIRE(paths.paths().size() == 2);
  CHECK(paths.paths()[0].points == expected);
  CHECK(!paths.paths()[0].branch);
  // The other one has stood still.
  CHECK(paths.paths()[1].points == std::vector<Vec2>(4, sample.particles().body(1).position));
}

TEST_CASE(
    "the path of a broken particle ends at its centroid, and those of its pieces begin there") {
  BrokenSample sample;
  DisplacementPaths paths;
  paths.record(sample.view());
  sample.move(0, {0.003, 0.001});
  const Vec2 centroid = sample.particles().body(0).position;
  const BreakEvent event = sample.split(0);
  paths.record_break(sample.view(), event);
  sample.move(2, {0.002, 0});
  paths.record(sample.view());

  REQUIRE(paths.paths().size() == 4);
  const auto& parent = paths.paths()[0];
  REQUIRE(parent.points.size() == 2);
  // Round-off of centroids a centimetre from the origin.
  CHECK((parent.points[1] - centroid).norm() <= 1e-16);
  for (const BodyIndex i : {0u, 2u}) {
    const ParticleId id = sample.particles().ancestry(i).id;
    const auto& piece = paths.paths()[id];
    CAPTURE(id);
    CHECK(piece.particle.parent == parent.particle.id);
    CHECK(piece.particle.generation == 1);
    REQUIRE(piece.branch);
    CHECK(*piece.branch == parent.points[1]);
    REQUIRE(piece.points.size() == 2);
    CHECK(piece.points[1] == sample.particles().body(i).position);
    // Only the second piece has moved since the break.
    CHECK((piece.points[1] - piece.points[0]).norm() == near(i == 2 ? 0.002 : 0, 1e-16));
  }
}

TEST_CASE("paths of pieces of pieces branch from the path of their own parent") {
  BrokenSample sample;
  DisplacementPaths paths;
  paths.record(sample.view());
  paths.record_break(sample.view(), sample.split(0));
  sample.move(0, {0, 0.004});
  const ParticleId parent = sample.particles().ancestry(0).id;
  const Vec2 centroid = sample.particles().body(0).position;
  paths.record_break(sample.view(), sample.split(0));
  const auto& grandchild = paths.paths()[sample.particles().ancestry(0).id];
  CHECK(grandchild.particle.generation == 2);
  CHECK(grandchild.particle.parent == parent);
  REQUIRE(grandchild.branch);
  CHECK((*grandchild.branch - centroid).norm() <= 1e-16);
  CHECK(paths.paths()[parent].points.back() == *grandchild.branch);
}

TEST_CASE("breaks before the first record leave no path of the parent and no branch") {
  BrokenSample sample;
  DisplacementPaths paths;
  paths.record_break(sample.view(), sample.split(0));
  CHECK(paths.paths().empty());
  paths.record(sample.view());
  REQUIRE(paths.paths().size() == 4);
  CHECK(paths.paths()[0].points.empty());
  for (const BodyIndex i : {0u, 2u}) {
    const auto& piece = paths.paths()[sample.particles().ancestry(i).id];
    CHECK(piece.points == std::vector<Vec2>{sample.particles().body(i).position});
    CHECK(!piece.branch);
  }
}

TEST_CASE("platens are no particles: they have no path") {
  BrokenSample sample;
  sample.add_platen();
  DisplacementPaths paths;
  paths.record(sample.view());
  sample.move(2, {0, 0.007});
  paths.record(sample.view());
  CHECK(paths.paths().size() == 2);  // those of the two particles
  // A piece gets an id after that of the platen, whose path stays without points.
  paths.record_break(sample.view(), sample.split(0));
  REQUIRE(paths.paths().size() == 5);
  CHECK(paths.paths()[2].points.empty());
  CHECK(!paths.paths()[3].points.empty());
}
