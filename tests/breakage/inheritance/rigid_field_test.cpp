// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/inheritance/rigid_field.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/particle/particles.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

struct Totals {
  double mass = 0;
  Vec2 momentum{0, 0};
  double angular_momentum = 0;  // about a given point
  double kinetic = 0;

  void add(const Body& body, const Vec2& about) {
    mass += body.mass;
    momentum += body.mass * body.velocity;
    angular_momentum += body.inertia * body.angular_velocity +
                        body.mass * cross(body.position - about, body.velocity);
    kinetic += body.kinetic_energy();
  }
};

// An irregular pentagon of some 16 mm, turned and shifted.
ConvexPolygon pentagon(double angle, const Vec2& shift) {
  return ConvexPolygon{
      {-0.008, -0.004}, {0.003, -0.007}, {0.009, 0.001}, {0.002, 0.008}, {-0.006, 0.005}}
      .moved(Rotation::from_angle(angle), shift);
}

struct Broken {
  Body parent;
  std::vector<Body> pieces;
};

// Breaks a moving particle in two along a line through its centroid.
Broken break_particle(double angle, const Vec2& shift) {
  Particles particles{0.016, 2500};
  const BodyIndex i = particles.add(pentagon(angle, shift), Motion::free);
  particles.body(i).velocity = {1.7, -0.6};
  particles.body(i).angular_velocity = 340;
  Broken result{particles.body(i), {}};
  const Line line{result.parent.position, Vec2{std::cos(angle + 0.8), std::sin(angle + 0.8)}};
  const auto parts = StraightCut{}(particles.ring(i), line, particles.shape(i).area);
  REQUIRE(parts);
  const Ancestry ancestry = particles.ancestry(i);
  particles.replace(i, ConvexPolygon{parts->left}, Motion::free, ancestry);
  const BodyIndex j = particles.add(ConvexPolygon{parts->right}, Motion::free, &ancestry);
  for (const BodyIndex piece : {i, j}) {
    RigidField{}(result.parent, particles.body(piece));
    result.pieces.push_back(particles.body(piece));
  }
  return result;
}

struct SetsNothing {};
static_assert(!Inheritance<SetsNothing>);

}  // namespace

TEST_CASE("a split keeps mass, momentum, angular momentum and kinetic energy") {
  for (const double angle : {0.0, 0.37, 1.9, -2.6})
    for (const Vec2& shift : {Vec2{0, 0}, Vec2{0.3, -0.2}, Vec2{16, 9}}) {
      CAPTURE(angle);
      CAPTURE(shift.x());
      const Broken broken = break_particle(angle, shift);
      // Coordinates are rounded to offset * 1.1e-16; relative to the size of 16 mm, and a few
      // operations.
      const double tolerance = 1e-14 * (1 + shift.norm() / 0.016);
      Totals before;
      Totals after;
      before.add(broken.parent, shift);
      for (const Body& piece : broken.pieces) after.add(piece, shift);
      CHECK(after.mass == near_relative(before.mass, tolerance));
      CHECK((after.momentum - before.momentum).norm() ==
            near(0, tolerance * before.momentum.norm()));
      CHECK(after.angular_momentum == near_relative(before.angular_momentum, tolerance));
      CHECK(after.kinetic == near_relative(before.kinetic, tolerance));
    }
}

TEST_CASE("pieces of a spinning particle part with omega x r") {
  const Broken broken = break_particle(0.37, {0.1, 0.2});
  const Body& p = broken.pieces[0];
  const Body& q = broken.pieces[1];
  CHECK(p.angular_velocity == broken.parent.angular_velocity);
  CHECK(q.angular_velocity == broken.parent.angular_velocity);
  const Vec2 apart = q.position - p.position;
  const Vec2 expected = broken.parent.angular_velocity * perpendicular(apart);
  CHECK((q.velocity - p.velocity - expected).norm() == near(0, 1e-13 * expected.norm()));
}

TEST_CASE("of a particle that only translates every piece has its velocity") {
  Body parent;
  parent.position = {3, 4};
  parent.velocity = {0.25, -0.5};
  Body piece;
  piece.position = {7, -1};
  RigidField{}(parent, piece);
  CHECK(piece.velocity == parent.velocity);
  CHECK(piece.angular_velocity == 0);
}
