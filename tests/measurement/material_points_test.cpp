// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/material_points.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

ConvexPolygon rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

}  // namespace

TEST_CASE(
    "centroids are those of the bodies in the order of their ids, without walls and platens") {
  Particles particles(1, 1);
  particles.add(rectangle(0, 2, 0, 2), Motion::free);
  particles.add(rectangle(4, 6, 0, 2), Motion::platen);
  particles.add(rectangle(4, 6, 4, 6), Motion::wall);
  particles.add(rectangle(8, 10, 0, 2), Motion::strain_field);
  const Ancestry broken = particles.ancestry(0);
  // The left piece, of id 4, is at index 0; the right one, of id 5, at index 4.
  particles.replace(0, rectangle(0, 0.5, 0, 2), Motion::free, broken);
  particles.add(rectangle(0.5, 2, 0, 2), Motion::free, &broken);
  const auto points = centroids(particles);
  REQUIRE(points.size() == 3);
  CHECK(points[0].id == 3);
  CHECK(points[1].id == 4);
  CHECK(points[1].position.x() == near(0.25, 1e-15));
  CHECK(points[2].id == 5);
  CHECK(points[2].position.x() == near(1.25, 1e-15));
}

TEST_CASE("pieces of one intact particle have one point, where its centroid was when it broke") {
  Particles particles(1, 1);
  particles.add(rectangle(0, 2, 0, 2), Motion::free);
  particles.add(rectangle(4, 6, 0, 2), Motion::free);
  const Ancestry broken = particles.ancestry(0);
  particles.replace(0, rectangle(0, 0.5, 0, 2), Motion::free, broken);
  particles.add(rectangle(0.5, 2, 0, 2), Motion::free, &broken);
  const Ancestry again = particles.ancestry(2);
  particles.replace(2, rectangle(0.5, 2, 0, 0.3), Motion::free, again);
  particles.add(rectangle(0.5, 2, 0.3, 2), Motion::free, &again);
  const auto points = root_centroids(particles);
  REQUIRE(points.size() == 2);
  CHECK(points[0].id == 0);
  CHECK(points[0].position.x() == near(1, 1e-15));
  CHECK(points[0].position.y() == near(1, 1e-15));
  CHECK(points[1].id == 1);
  // A piece that moves takes the point along by its share of the area.
  particles.body(0).position += Vec2{0.4, 0};
  CHECK(root_centroids(particles)[0].position.x() == near(1.1, 1e-15));
}
