// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/particles.hpp>

#include <algorithm>
#include <doctest/doctest.h>
#include <set>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Body frame about the centroid; the laboratory ring is a function of it, to the last bit, and the
/// polygon that was given, to the round-off of a difference and a sum.
void check_stored(const Particles& particles, BodyIndex i, const ConvexPolygon& polygon) {
  const Ring ring = particles.ring(i);
  const Ring local = particles.local_ring(i);
  REQUIRE(ring.size() == polygon.size());
  REQUIRE(local.size() == polygon.size());
  const AreaProperties p = area_properties(polygon.ring());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    CHECK(local[k] == polygon[k] - p.centroid);
    CHECK(ring[k] == local[k] + p.centroid);
    const double extent = local[k].norm() + p.centroid.norm();
    CHECK((ring[k] - polygon[k]).norm() <= 3e-16 * extent);
  }
  CHECK(particles.body(i).position == p.centroid);
  CHECK(particles.shape(i).area == p.area);
}

ConvexPolygon somewhere(Random& random) {
  const Vec2 place{random.uniform(-5, 5), random.uniform(-5, 5)};
  return shifted(random_polygon({.most_vertices = 12}, 1, random), place);
}

}  // namespace

TEST_CASE("mass and inertia are density times thickness times the polygon's moments") {
  Particles particles(0.02, 2500);
  CHECK(particles.thickness() == 0.02);
  CHECK(particles.mean_density() == 2500);
  const BodyIndex i = particles.add(shifted(rectangle(0.4, 0.3), {3, -2}), Motion::free);
  const double mass = 2500 * 0.02 * 0.12;
  CHECK(particles.body(i).mass == near_relative(mass, 1e-14));
  // Rectangle about its centre: m (b^2 + h^2) / 12.
  CHECK(particles.body(i).inertia == near_relative(mass * 0.25 / 12, 1e-13));
  CHECK((particles.body(i).position - Vec2{3, -2}).norm() <= 1e-15);
  CHECK(particles.shape(i).circumradius == near_relative(0.25, 1e-14));
  CHECK(particles.shape(i).count == 4);
}

TEST_CASE("each particle has the density of its material, which pieces and the others keep") {
  Particles particles(0.02, std::vector<double>{1000, 3000});
  particles.add(rectangle(0.4, 0.3), Motion::free, nullptr, 1);
  particles.add(shifted(rectangle(0.2, 0.1), {2, 0}), Motion::free);
  particles.add(shifted(rectangle(1, 1), {5, 0}), Motion::wall, nullptr, 1);
  CHECK(particles.body(0).mass == near_relative(3000 * 0.02 * 0.12, 1e-14));
  CHECK(particles.body(1).mass == near_relative(1000 * 0.02 * 0.02, 1e-14));
  CHECK(particles.density(0) == 3000);
  // Mass over volume of the two, without the wall.
  CHECK(particles.mean_density() == near_relative((3000 * 0.12 + 1000 * 0.02) / 0.14, 1e-14));
  const Ancestry whole = particles.ancestry(0);
  particles.replace(0, rectangle(0.2, 0.3), Motion::free, whole);
  CHECK(particles.material(0) == 1);
  CHECK(particles.body(0).mass == near_relative(3000 * 0.02 * 0.06, 1e-14));
  particles.remove(0);
  CHECK(particles.material(0) == 0);
  CHECK(particles.material(1) == 1);
  // Walls alone.
  particles.remove(0);
  CHECK(particles.mean_density() == near_relative(3000, 1e-14));
}

TEST_CASE("particles of one density have that mean density, to the last bit") {
  for (const double density : {2500.0, 2647.3, 1.1}) {
    Particles particles(0.017, std::vector<double>{7, density, density});
    Random random(3);
    for (MaterialIndex n = 0; n < 20; ++n)
      particles.add(somewhere(random), Motion::free, nullptr, MaterialIndex(1 + n % 2));
    particles.add(rectangle(1, 1), Motion::wall);
    CHECK(particles.mean_density() == density);
  }
}

TEST_CASE("a particle is added at rest, unturned, in its place and with its motion") {
  Particles particles(1, 1);
  Random random(1);
  std::vector<ConvexPolygon> polygons;
  const Motion motions[] = {Motion::free, Motion::prescribed, Motion::strain_field};
  for (unsigned n = 0; n < 60; ++n) {
    polygons.push_back(somewhere(random));
    CHECK(particles.add(polygons.back(), motions[n % 3]) == n);
  }
  REQUIRE(particles.size() == 60);
  REQUIRE(particles.bodies().size() == 60);
  for (BodyIndex i = 0; i < 60; ++i) {
    check_stored(particles, i, polygons[i]);
    CHECK(particles.body(i).motion == motions[i % 3]);
    CHECK(particles.body(i).velocity.norm() == 0);
    CHECK(particles.body(i).rotation.angle() == 0);
    CHECK(particles.body(i).mass_scaling == 1);
    CHECK(particles.ancestry(i).id == i);
    CHECK(particles.ancestry(i).root == i);
    CHECK(particles.ancestry(i).parent == no_particle);
    CHECK(particles.ancestry(i).generation == 0);
  }
}

TEST_CASE("the ring follows the body's pose") {
  Particles particles(1, 1);
  particles.add(shifted(rectangle(2, 2), {-4, -4}), Motion::free);
  const BodyIndex i = particles.add(shifted(rectangle(4, 2), {1, 1}), Motion::free);
  particles.add(shifted(rectangle(2, 2), {9, 9}), Motion::free);
  particles.body(i).position = {10, 20};
  particles.body(i).rotation = Rotation::from_angle(pi / 2);
  // Rings stay as they are until update_ring.
  CHECK(particles.ring(i)[0] == Vec2{-1, 0});
  particles.update_ring(i);
  // (-2, -1) turned by 90 degrees is (1, -2).
  CHECK((particles.ring(i)[0] - Vec2{11, 18}).norm() <= 4e-15);
  CHECK((particles.ring(i)[1] - Vec2{11, 22}).norm() <= 4e-15);
  CHECK((particles.ring(i)[2] - Vec2{9, 22}).norm() <= 4e-15);
  CHECK((particles.ring(i)[3] - Vec2{9, 18}).norm() <= 4e-15);
  // Neighbours in the pool stay where they were.
  CHECK(particles.ring(0)[0] == Vec2{-5, -5});
  CHECK(particles.ring(2)[0] == Vec2{8, 8});
}

TEST_CASE("pieces have parent, root and generation, and get new ids") {
  Particles particles(1, 1);
  particles.add(unit_square(), Motion::free);
  const BodyIndex i = particles.add(shifted(unit_square(), {5, 0}), Motion::free);
  const Ancestry intact = particles.ancestry(i);
  REQUIRE(intact.id == 1);
  // The particle at i breaks in two: one piece in its place, one at the end.
  particles.replace(i, shifted(rectangle(0.5, 1), {5, 0}), Motion::free, intact);
  const BodyIndex j = particles.add(shifted(rectangle(0.5, 1), {5.5, 0}), Motion::free, &intact);
  CHECK(particles.size() == 3);
  for (const BodyIndex piece : {i, j}) {
    CHECK(particles.ancestry(piece).parent == 1);
    CHECK(particles.ancestry(piece).root == 1);
    CHECK(particles.ancestry(piece).generation == 1);
  }
  CHECK(particles.ancestry(i).id == 2);
  CHECK(particles.ancestry(j).id == 3);
  // A piece of a piece.
  const Ancestry broken = particles.ancestry(j);
  particles.replace(j, shifted(rectangle(0.5, 0.5), {5.5, 0}), Motion::prescribed, broken);
  CHECK(particles.ancestry(j).id == 4);
  CHECK(particles.ancestry(j).parent == 3);
  CHECK(particles.ancestry(j).root == 1);
  CHECK(particles.ancestry(j).generation == 2);
  CHECK(particles.body(j).motion == Motion::prescribed);
  CHECK(particles.ancestry(0).id == 0);
}

TEST_CASE("the parent may be named by reference into the same storage") {
  Particles particles(1, 1);
  particles.add(unit_square(), Motion::free);
  // Many additions move the storage, some of them while the parent is being read.
  for (unsigned n = 1; n < 200; ++n) {
    const BodyIndex child = particles.add(unit_square(), Motion::free, &particles.ancestry(n - 1));
    REQUIRE(particles.ancestry(child).parent == n - 1);
    REQUIRE(particles.ancestry(child).root == 0);
    REQUIRE(particles.ancestry(child).generation == n);
  }
  particles.replace(7, unit_square(), Motion::free, particles.ancestry(7));
  CHECK(particles.ancestry(7).parent == 7);
  CHECK(particles.ancestry(7).generation == 8);
}

TEST_CASE("a replaced particle leaves nothing of its motion or load behind") {
  Particles particles(1, 1);
  particles.add(unit_square(), Motion::free);
  Body& body = particles.body(0);
  body.velocity = {1, 2};
  body.angular_velocity = 3;
  body.rotation = Rotation::from_angle(1);
  body.contact = {{4, 5}, 6};
  body.mass_scaling = 7;
  const ConvexPolygon piece = shifted(regular_polygon(3, 0.1), {2, 2});
  particles.replace(0, piece, Motion::free, particles.ancestry(0));
  check_stored(particles, 0, piece);
  CHECK(particles.body(0).velocity.norm() == 0);
  CHECK(particles.body(0).angular_velocity == 0);
  CHECK(particles.body(0).rotation.sine == 0);
  CHECK(particles.body(0).contact.force.norm() == 0);
  CHECK(particles.body(0).contact.moment == 0);
  CHECK(particles.body(0).mass_scaling == 1);
  CHECK(particles.shape(0).circumradius == near_relative(0.1, 1e-14));
}

TEST_CASE("over many breaks every ring stays right, no id returns and the pool stays small") {
  Particles particles(1, 1);
  Random random(17);
  std::vector<ConvexPolygon> expected;
  std::set<ParticleId> ids;
  for (unsigned n = 0; n < 20; ++n) {
    expected.push_back(somewhere(random));
    ids.insert(particles.ancestry(particles.add(expected.back(), Motion::free)).id);
  }
  for (int event = 0; event < 400; ++event) {
    const BodyIndex i = random.uniform_integer(0, static_cast<unsigned>(particles.size() - 1));
    const Ancestry parent = particles.ancestry(i);
    expected[i] = somewhere(random);
    particles.replace(i, expected[i], Motion::free, parent);
    REQUIRE(ids.insert(particles.ancestry(i).id).second);
    if (event % 8 == 0) {
      expected.push_back(somewhere(random));
      const BodyIndex j = particles.add(expected.back(), Motion::free, &parent);
      REQUIRE(ids.insert(particles.ancestry(j).id).second);
    }
    std::size_t live = 0;
    std::size_t end = 0;
    for (BodyIndex k = 0; k < particles.size(); ++k) {
      check_stored(particles, k, expected[k]);
      live += particles.shape(k).count;
      end = std::max<std::size_t>(end, particles.shape(k).first + particles.shape(k).count);
    }
    // Never more dead vertices than living ones.
    REQUIRE(end <= 2 * live);
  }
  CHECK(ids.size() == 20 + 400 + 50);
}

TEST_CASE("a moved ring survives the clearing of the pool") {
  Particles particles(1, 1);
  const BodyIndex moved = particles.add(unit_square(), Motion::free);
  const BodyIndex breaking = particles.add(unit_square(), Motion::free);
  particles.body(moved).position = {3, 4};
  particles.update_ring(moved);
  const std::vector<Vec2> before(particles.ring(moved).begin(), particles.ring(moved).end());
  for (int n = 0; n < 10; ++n)
    particles.replace(breaking, regular_polygon(30, 1), Motion::free, particles.ancestry(breaking));
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(particles.ring(moved)[k] == before[k]);
    CHECK(particles.local_ring(moved)[k] == unit_square()[k] - Vec2{0.5, 0.5});
  }
}

TEST_CASE("the pool is cleared now and then, not at every break") {
  Particles particles(1, 1);
  for (int n = 0; n < 20; ++n) particles.add(unit_square(), Motion::free);
  int cleared = 0;
  for (int n = 0; n < 210; ++n) {
    particles.replace(0, unit_square(), Motion::free, particles.ancestry(0));
    cleared += particles.shape(0).first == 0;
  }
  // k breaks leave 4 k dead vertices of 80 + 4 k: more than half of them for the first time at 21.
  CHECK(cleared == 10);
}

TEST_CASE("particles behind a removed one move up, and its id is not used again") {
  Particles particles(1, 1);
  for (const double x : {0.0, 2.0, 4.0, 6.0})
    particles.add(unit_square().moved({}, {x, 0}), Motion::free);
  particles.remove(1);
  REQUIRE(particles.size() == 3);
  CHECK(particles.body(1).position == Vec2{4.5, 0.5});
  CHECK(particles.ring(1)[0] == Vec2{4, 0});
  CHECK(particles.ancestry(2).id == 3);
  CHECK(particles.find(3) == BodyIndex{2});
  CHECK_FALSE(particles.find(1).has_value());
  particles.remove(0);
  particles.remove(1);  // the vertices of most are dead now
  CHECK(particles.shape(0).first == 0);
  CHECK(particles.ring(0)[2] == Vec2{5, 1});
  CHECK(particles.ancestry(particles.add(unit_square(), Motion::free)).id == 4);
}
