// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/overlap_moments.hpp>

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/overlapping_pairs.hpp>
#include <support/polygons.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using std::numbers::pi;
using test::check_same;
using test::for_random_contacts;
using test::near;
using test::near_relative;
using test::rectangle;
using test::shifted;
using test::tip_down;

namespace {

constexpr auto contact_of = test::contact_of<OverlapMoments>;

const ConvexPolygon floor_below = rectangle({0, -1}, 4, 2);

// 24 det S / (A tr S) of the clipped overlap, its moments summed over a fan of triangles by the
// midpoints of their sides: another route to the integrals.
double depth_by_clipping(const ConvexPolygon& a, const ConvexPolygon& b) {
  const OverlapPolygon common = overlap(a.ring(), b.ring(), a[0], 0);
  if (common.size < 3) return 0;
  const auto [area, centroid, polar] = area_properties(common.ring());
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (std::size_t i = 1; i + 1 < common.size; ++i) {
    const std::array corners{common.vertices[0], common.vertices[i], common.vertices[i + 1]};
    const double part = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 middle = 0.5 * (corners[k] + corners[(k + 1) % 3]) - centroid;
      second += part / 3 * middle * middle.transpose();
    }
  }
  return std::sqrt(24 * second.determinant() / (area * second.trace()));
}

// The force on b over k_n depth, and its moment about `centre`.
struct Gradient {
  Vec2 force{0, 0};
  double moment = 0;
};
Gradient gradient_of(const ContactGeometry& contact, const Vec2& centre) {
  const Vec2 force = contact.depth_gradient * contact.normal;
  return {force, cross(contact.point - centre, force)};
}

// By central differences of the depth over shifts and turns of b about `centre`.
Gradient measured_gradient(const ConvexPolygon& a, const ConvexPolygon& b, const Vec2& centre,
                           double way) {
  const auto slope = [&](const Vec2& direction, double turn) {
    const auto depth = [&](double step) {
      const Rotation rotation = Rotation::from_angle(step * turn);
      const Vec2 shift = centre + step * direction - rotation * centre;
      return depth_by_clipping(a, b.moved(rotation, shift));
    };
    return (depth(-way) - depth(way)) / (2 * way);
  };
  return {{slope({1, 0}, 0), slope({0, 1}, 0)}, slope({0, 0}, 1)};
}

}  // namespace

// --- Closed forms -------------------------------------------------------------------------------

TEST_CASE("a right-angled corner has its depth at any tilt, with the force through the tip") {
  for (const double depth : {0.03, 1e-3, 1e-6})
    for (const double tilt : {0.1, 0.5, pi / 4, 1.3}) {
      CAPTURE(depth);
      CAPTURE(tilt);
      const auto contact = contact_of(floor_below, tip_down({0.2, -depth}, tilt, pi / 2 - tilt));
      REQUIRE(contact);
      // Last digits of coordinates of size 4, over the depth.
      const double digits = 4e-15 / depth;
      CHECK(contact->depth == near_relative(depth, digits));
      CHECK(contact->depth_gradient == near(1, digits));
      CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-15);
      CHECK(contact->point.x() == near(0.2, 4e-14));
      CHECK(contact->point.y() == near(-depth / 3, 1e-14));
    }
}

TEST_CASE("the stiffness of an upright corner follows from its opening") {
  // W = k L^2 d^2 / Q with L = 2 t d, Q = L^2 + 2 d^2 + L^2 / 2, t the tangent of half the opening.
  for (const double opening : {30.0, 60.0, 90.0, 120.0}) {
    CAPTURE(opening);
    const double half = opening * pi / 360;
    const double t = std::tan(half);
    const auto contact =
        contact_of(floor_below, tip_down({0.1, -0.02}, pi / 2 - half, pi / 2 - half));
    REQUIRE(contact);
    const double stiffness = 4 * t * t / (1 + 3 * t * t);
    CHECK(std::pow(contact->depth / 0.02, 2) == near_relative(stiffness, 1e-13));
    CHECK(std::pow(contact->depth_gradient, 2) == near_relative(stiffness, 1e-13));
    CHECK(contact->point.x() == near(0.1, 1e-14));
  }
}

TEST_CASE(
    "a corner of any opening at any tilt has the energy and the line of action of its triangle") {
  const double depth = 0.02;
  for (const auto& [left, right] :
       {std::pair{0.4, 0.9}, std::pair{1.1, 0.3}, std::pair{2.2, 0.5}}) {
    const double p = depth / std::tan(left);
    const double q = depth / std::tan(right);
    const double length = p + q;
    const double sum = length * length + 2 * depth * depth + p * p + q * q;
    const auto contact = contact_of(floor_below, tip_down({0.2, -depth}, left, right));
    REQUIRE(contact);
    CHECK(0.5 * std::pow(contact->depth, 2) ==
          near_relative(std::pow(length * depth, 2) / sum, 1e-12));
    CHECK(contact->depth * contact->depth_gradient ==
          near_relative(2 * length * length * depth / sum, 1e-12));
    const double from_foot = (q - p) * (depth * depth - p * q) / sum;
    CHECK(contact->point.x() == near(0.2 + from_foot, 1e-14));
  }
}

TEST_CASE("a thin face carries a spring at each end") {
  // depth^2 = d1^2 + d2^2 to first order in the depths over the width.
  const double width = 1.5;
  const double d1 = 2e-6;
  const double d2 = 5e-6;
  const ConvexPolygon block{{-0.5, -d1}, {1, -d2}, {1, 1}, {-0.5, 1}};
  const auto contact = contact_of(floor_below, block);
  REQUIRE(contact);
  CHECK(contact->depth == near_relative(std::hypot(d1, d2), 1e-5));
  const double force = contact->depth * contact->depth_gradient;
  CHECK(force == near_relative(d1 + d2, 1e-5));
  CHECK(contact->point.x() == near_relative(-0.5 + width * d2 / (d1 + d2), 1e-5));
}

TEST_CASE(
    "tilted faces, one over the end of the other, keep their digits however thin the overlap") {
  // A rectangle of width 0.75 in exact arithmetic: depth sqrt(2) d to second order, force 2 d.
  for (const double depth : {1e-4, 1e-6, 1e-8, 1e-10, 1e-11})
    for (int i = 0; i < 40; ++i) {
      CAPTURE(depth);
      const double tilt = 0.157 * i + 0.05;
      const auto contact = contact_of(
          rectangle({0, -0.5}, 1, 1).moved(Rotation::from_angle(tilt), Vec2{0, 0}),
          rectangle({0.25, 0.5 - depth}, 1, 1).moved(Rotation::from_angle(tilt), Vec2{0, 0}));
      REQUIRE(contact);
      // Coordinates of size one end in digits of 1e-16.
      const double digits = 1e-15 / depth + 2 * depth;
      CHECK(contact->depth == near_relative(std::numbers::sqrt2 * depth, digits));
      const Vec2 up = Rotation::from_angle(tilt) * Vec2{0, 1};
      CHECK(contact->depth * contact->depth_gradient * contact->normal.dot(up) ==
            near_relative(2 * depth, 3 * digits));
    }
}

TEST_CASE("needles with their short side first have finite contacts") {
  for (const double height : {0.3, 0.1, 0.03, 0.01})
    for (const double depth : {1e-7, 5e-9, 2e-9, 1e-9})
      for (int i = 0; i < 40; ++i) {
        const Rotation turn = Rotation::from_angle(0.16 * i);
        const ConvexPolygon a{{0, 0}, {0, -height}, {1, 0}};
        const ConvexPolygon b{{1.3, -depth}, {1.3, height - depth}, {0.3, -depth}};
        const auto contact = contact_of(a.moved(turn, Vec2{0, 0}), b.moved(turn, Vec2{0, 0}));
        if (!contact) continue;
        CHECK(std::isfinite(contact->depth));
        CHECK(contact->depth_gradient < 1.5);
        CHECK(std::isfinite(contact->point.x() + contact->point.y()));
      }
}

TEST_CASE("a face on a face has the energy of a rectangle, flush or not") {
  // W = k s^2 d^2 / (s^2 + d^2): force 2 k s^4 d / (s^2 + d^2)^2.
  const double depth = 0.2;
  for (const double shift : {0.0, 1e-10, 1e-3, 0.2}) {
    CAPTURE(shift);
    const auto contact =
        contact_of(rectangle({0, -0.5}, 1, 1), rectangle({shift, 0.5 - depth}, 1, 1));
    REQUIRE(contact);
    const double width = 1 - shift;
    const double squared = width * width + depth * depth;
    CHECK(contact->depth == near_relative(std::sqrt(2 / squared) * width * depth, 1e-13));
    const double up = contact->depth * contact->depth_gradient * contact->normal.y();
    CHECK(up == near_relative(2 * std::pow(width, 4) * depth / (squared * squared), 1e-12));
  }
}

TEST_CASE("two right-angled corners tip to tip are springs in series") {
  const double apart = 1.9;  // of the centres; half diagonals of the squares are one each
  const double side = std::sqrt(2.0);
  const auto contact =
      contact_of(rectangle({0, 0}, side, side, pi / 4), rectangle({0, apart}, side, side, pi / 4));
  REQUIRE(contact);
  const double approach = 2 - apart;
  CHECK(std::pow(contact->depth, 2) == near_relative(0.5 * approach * approach, 1e-12));
  CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-12);
  CHECK((contact->point - Vec2{0, 0.5 * apart}).norm() <= 1e-12);
}

TEST_CASE("a body inside another feels no force") {
  const auto contact = contact_of(rectangle({0, 0}, 4, 2), rectangle({1.2, 0.1}, 0.5, 0.5));
  REQUIRE(contact);
  CHECK(contact->depth_gradient == 0);
  // Of a square of side s: 12 k s^2 s^4 / 144 / (s^2 s^4 / 6) = k s^2 / 2.
  CHECK(contact->depth == near_relative(0.5, 1e-13));
  CHECK((contact->normal - Vec2{1, 0}).norm() <= 1e-14);
}

// --- Gradient -----------------------------------------------------------------------------------

TEST_CASE("depth and gradient are those of the clipped overlap for pairs of every class") {
  std::array<int, 4> classes{};
  int shallow = 0;
  test::for_random_pairs(1500, [&](const auto& a, const auto& b) {
    OverlapMoments::Cache cache;
    const auto contact = OverlapMoments{}(a.ring(), b.ring(), cache);
    REQUIRE(contact);
    // Round-off of coordinates of size 2, some ten times over.
    CHECK(contact->depth == near(depth_by_clipping(a, b), 2e-14));
    const double way = 1e-6;
    // Within that way of the first touch or of a class the difference is not central.
    if (contact->depth < 1e3 * way) return void(++shallow);
    ++classes[static_cast<std::size_t>(cache.state)];
    const Vec2 centre = area_properties(b.ring()).centroid;
    const Gradient expected = measured_gradient(a, b, centre, way);
    const Gradient gradient = gradient_of(*contact, centre);
    CHECK((gradient.force - expected.force).norm() <= 1e-6);
    CHECK(gradient.moment == near(expected.moment, 1e-6));
  });
  CHECK(shallow < 20);
  for (const int count : {classes[1], classes[2], classes[3]}) CHECK(count > 200);
}

TEST_CASE("the energy has no jumps along random paths, through all classes and containment") {
  Random random(11);
  double steepest = 0;
  for (int path = 0; path < 60; ++path) {
    const ConvexPolygon a = random_polygon({}, random.uniform(0.7, 1.3), random);
    const ConvexPolygon b = random_polygon({}, random.uniform(0.4, 1.3), random);
    const Vec2 start{random.uniform(-1.2, 1.2), -3};
    const Vec2 way{random.uniform(-1, 1), 6};
    const double turn = random.uniform(-2, 2);
    constexpr int steps = 2000;
    double before = 0;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const auto contact = contact_of(a, b.moved(Rotation::from_angle(turn * t), start + t * way));
      const double energy = contact ? contact->depth * contact->depth : 0;
      steepest = std::max(steepest, std::abs(energy - before) * steps);
      before = energy;
    }
  }
  // d(depth^2)/dt = 2 depth gradient velocity, with a depth up to 1, a gradient up to 1.6 and a
  // velocity up to 6 along the path and 2 by the turn. A jump by 0.03 would make it 60.
  CHECK(steepest > 5);
  CHECK(steepest < 26);
}

TEST_CASE("nothing begins at first touch but from zero") {
  for (const double depth : {1e-3, 1e-5, 1e-7}) {
    const auto corner = contact_of(floor_below, tip_down({0, -depth}, 0.5, 0.2));
    REQUIRE(corner);
    // D^2 is at most twice the square of the least width.
    CHECK(corner->depth <= std::sqrt(2.0) * depth);
    CHECK(corner->depth_gradient <= std::sqrt(2.0));
  }
}

// --- Symmetries ---------------------------------------------------------------------------------

TEST_CASE("moments of swapped bodies have the opposite normal") {
  for_random_contacts<OverlapMoments>(
      500, [](const auto& a, const auto& b, const ContactGeometry& contact) {
        const auto swapped = contact_of(b, a);
        REQUIRE(swapped);
        ContactGeometry back = *swapped;
        back.normal = -back.normal;
        check_same(back, contact, 1e-12);
        CHECK(back.depth_gradient == near(contact.depth_gradient, 1e-12));
      });
}

TEST_CASE("moments move rigidly with their bodies") {
  test::check_contacts_move_rigidly<OverlapMoments>();
}

TEST_CASE("moments scale with the unit of length, to the last bit") {
  for (const double scale : {std::ldexp(1.0, -30), std::ldexp(1.0, 40)})
    for_random_contacts<OverlapMoments>(
        100, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
          const auto large = contact_of(test::scaled(a, scale), test::scaled(b, scale));
          REQUIRE(large);
          CHECK(large->depth == scale * contact.depth);
          CHECK(large->point == scale * contact.point);
          CHECK(large->normal == contact.normal);
          CHECK(large->depth_gradient == contact.depth_gradient);
        });
}
