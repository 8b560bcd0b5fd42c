// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/replace_by_pieces.hpp>

#include <doctest/doctest.h>

#include <riprap/geometry/cut.hpp>
#include <riprap/simulation/model.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;

namespace {

// A plate of 20 mm by 10 mm about the origin, which moves and turns, beside another one.
struct Plate {
  Particles particles{0.016, 2500};
  Crack crack;
  BreakEvent event;

  Plate() {
    particles.add(test::rectangle({0, 0}, 0.02, 0.01), Motion::free);
    particles.add(test::rectangle({0.1, 0}, 0.02, 0.01), Motion::free);
    particles.body(0).velocity = {1, 2};
    particles.body(0).angular_velocity = 100;
    // Upright at x = 5 mm: the left side of the line has three quarters.
    crack.line = {{0.005, 0}, {0, 1}};
    crack.pieces = cut(particles.ring(0), crack.line).value();
  }
  BodyIndex replace() {
    return replace_by_pieces(Model{}, particles.body(0).mass, crack, 0, particles, event);
  }
  void check_piece(BodyIndex i, std::size_t k, double area, double x) const {
    CHECK(event.pieces[k] == particles.ancestry(i).id);
    CHECK(event.areas[k] == near_relative(area, 1e-12));
    CHECK((event.centroids[k] - Vec2{x, 0}).norm() <= 1e-16);
    CHECK(particles.shape(i).area == event.areas[k]);
    CHECK(particles.ancestry(i).parent == 0);
    CHECK(particles.ancestry(i).root == 0);
    // Rigid motion about the origin: v + omega x r.
    CHECK((particles.body(i).velocity - Vec2{1, 2 + 100 * x}).norm() <= 1e-13);
    CHECK(particles.body(i).angular_velocity == 100);
    // Lighter than the smallest intact particle: its mass is scaled up to that.
    CHECK(particles.body(i).mass_scaling * area == near_relative(2e-4, 1e-12));
  }
  void check_dust(std::size_t k, double area, double x) const {
    REQUIRE(particles.dust().size() == 1);
    CHECK(particles.dust()[0].root == 0);
    CHECK(particles.dust()[0].area == event.areas[k]);
    CHECK(event.pieces[k] == no_particle);
    CHECK(event.areas[k] == near_relative(area, 1e-12));
    CHECK((event.centroids[k] - Vec2{x, 0}).norm() <= 1e-16);
  }
};

}  // namespace

TEST_CASE("the left piece takes the place, the right one is new") {
  Plate plate;
  REQUIRE(plate.replace() == 2);
  REQUIRE(plate.particles.size() == 3);
  plate.check_piece(0, 0, 1.5e-4, -0.0025);
  plate.check_piece(2, 1, 0.5e-4, 0.0075);
  CHECK(plate.particles.dust().empty());
  CHECK(plate.event.place().norm() <= 1e-16);
}

TEST_CASE("beside dust the other piece takes the place") {
  Plate right;
  right.crack.is_dust = {false, true};
  REQUIRE(right.replace() == 0);
  REQUIRE(right.particles.size() == 2);
  right.check_piece(0, 0, 1.5e-4, -0.0025);
  right.check_dust(1, 0.5e-4, 0.0075);

  Plate left;
  left.crack.is_dust = {true, false};
  REQUIRE(left.replace() == 0);
  REQUIRE(left.particles.size() == 2);
  left.check_piece(0, 1, 0.5e-4, 0.0075);
  left.check_dust(0, 1.5e-4, -0.0025);
}
