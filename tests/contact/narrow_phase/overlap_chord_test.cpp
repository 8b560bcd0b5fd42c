// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/separating_axis.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/overlapping_pairs.hpp>
#include <support/polygons.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::area_slope;
using test::check_same;
using test::crossings;
using test::for_random_contacts;
using test::mirrored;
using test::near;
using test::near_relative;
using test::rectangle;
using test::shifted;
using test::tip_down;

namespace {

constexpr auto contact_of = test::contact_of<OverlapChord>;

}  // namespace

// --- Closed forms -------------------------------------------------------------------------------

TEST_CASE("a corner in an edge has the depth of its tip and the chord along the edge") {
  const double pi = std::numbers::pi;
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  for (const double depth : {0.1, 1e-3, 1e-6})
    for (const auto& [left, right] :
         {std::pair{pi / 4, pi / 4}, std::pair{0.3, 1.2}, std::pair{1.5, 0.2}}) {
      CAPTURE(depth);
      const double to_left = depth / std::tan(left);
      const double to_right = depth / std::tan(right);
      const auto contact = contact_of(floor, tip_down({0.2, -depth}, left, right));
      REQUIRE(contact);
      // Coordinates of size 4 end in digits of 4e-16.
      const double tolerance = 1e-14;
      CHECK((contact->normal - Vec2{0, 1}).norm() * contact->chord <= tolerance);
      CHECK(std::abs(contact->depth - depth) <= tolerance);
      CHECK(std::abs(contact->chord - (to_left + to_right)) <= 10 * tolerance);
      CHECK((contact->point - Vec2{0.2 + 0.5 * (to_right - to_left), 0}).norm() <= 10 * tolerance);
      CHECK(std::abs(contact->area - 0.5 * depth * (to_left + to_right)) <= 10 * tolerance * depth);
    }
}

TEST_CASE("however shallow a corner is, it makes contact") {
  // A force that began at a finite depth would give energy away or take it.
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  for (const double depth : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    CAPTURE(depth);
    const auto contact = contact_of(floor, tip_down({0, -depth}, 1.0, 0.7));
    REQUIRE(contact);
    // The last digits of coordinates of size 2, whatever the depth.
    CHECK(contact->depth == near(depth, 1e-15));
    const auto swapped = contact_of(tip_down({0, -depth}, 1.0, 0.7), floor);
    REQUIRE(swapped);
    CHECK(swapped->depth == near(depth, 1e-15));
  }
}

TEST_CASE("a face on a wider face has the overlap's height as depth and the face as chord") {
  for (const double depth : {0.2, 1e-3, 1e-8}) {
    CAPTURE(depth);
    const auto contact =
        contact_of(rectangle({0, -1}, 4, 2), rectangle({0.3, 0.5 - depth}, 1.5, 1));
    REQUIRE(contact);
    CHECK(std::abs(contact->depth - depth) <= 1e-14);
    CHECK(contact->chord == near_relative(1.5, 1e-14));
    CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-14);
    CHECK((contact->point - Vec2{0.3, 0}).norm() <= 1e-14);
    CHECK(std::abs(contact->area - 1.5 * depth) <= 1e-14);
  }
}

TEST_CASE("a corner in a corner has the diagonal as chord and twice area over chord as depth") {
  const double w = 0.1;
  const double h = 0.2;
  const double diagonal = std::hypot(w, h);
  const auto contact = contact_of(rectangle({0, 0}, 1, 1), rectangle({1 - w, 1 - h}, 1, 1));
  REQUIRE(contact);
  CHECK(contact->chord == near_relative(diagonal, 1e-14));
  CHECK(contact->depth == near_relative(2 * w * h / diagonal, 1e-14));
  CHECK(contact->area == near_relative(w * h, 1e-14));
  CHECK((contact->normal - Vec2{h, w} / diagonal).norm() <= 1e-14);
  CHECK((contact->point - Vec2{0.5 - 0.5 * w, 0.5 - 0.5 * h}).norm() <= 1e-14);
}

// --- Where there is no chord --------------------------------------------------------------------

TEST_CASE("bodies that keep apart or only touch have no contact") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  CHECK(!contact_of(square, rectangle({3, 0}, 1, 1)));
  CHECK(!contact_of(square, rectangle({1.0000001, 0.2}, 1, 1)));
  CHECK(!contact_of(square, rectangle({1, 0}, 1, 1)));       // face on face
  CHECK(!contact_of(square, rectangle({1, 1}, 1, 1)));       // corner on corner
  CHECK(!contact_of(square, tip_down({0.1, 0.5}, 1, 0.8)));  // corner on face
  // Near each other but parted by neither axis.
  CHECK(!contact_of(square, rectangle({0.9, 0.9}, 1, 1, std::numbers::pi / 4)));
}

TEST_CASE("a body inside another is parted by the least translation") {
  const ConvexPolygon outer = rectangle({0, 0}, 4, 2);
  const ConvexPolygon inner = rectangle({1.2, 0.1}, 0.5, 0.5);
  const auto contact = contact_of(outer, inner);
  REQUIRE(contact);
  // The way out through the right face is 2 - 1.2 + 0.25, through the upper one 1 - 0.1 + 0.25.
  CHECK(contact->depth == near_relative(1.05, 1e-14));
  CHECK((contact->normal - Vec2{1, 0}).norm() <= 1e-14);
  CHECK((contact->point - Vec2{1.2, 0.1}).norm() <= 1e-14);
  CHECK(contact->area == near_relative(0.25, 1e-14));
  const auto swapped = contact_of(inner, outer);
  REQUIRE(swapped);
  CHECK(swapped->depth == near_relative(1.05, 1e-14));
  CHECK((swapped->normal - Vec2{-1, 0}).norm() <= 1e-14);
}

TEST_CASE("faces of equal width one on the other are parted by the least translation") {
  const auto contact = contact_of(rectangle({0, -0.5}, 1, 1), rectangle({0, 0.499}, 1, 1));
  REQUIRE(contact);
  CHECK(contact->depth == near_relative(1e-3, 1e-12));
  CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-14);
  CHECK((contact->point - Vec2{0, -0.0005}).norm() <= 1e-14);
  CHECK(contact->chord == near_relative(1, 1e-14));
  CHECK(contact->area == near_relative(1e-3, 1e-12));
}

TEST_CASE("faces flush at one end only are parted by the least translation") {
  for (const double side : {1.0, -1.0}) {
    const ConvexPolygon wide = rectangle({0, -0.5}, 2, 1);
    const ConvexPolygon narrow = rectangle({0.5 * side, 0.499}, 1, 1);
    const auto contact = contact_of(wide, narrow);
    const auto swapped = contact_of(narrow, wide);
    REQUIRE(contact);
    REQUIRE(swapped);
    for (const auto& c : {*contact, *swapped}) {
      CHECK(c.depth == near_relative(1e-3, 1e-12));
      CHECK(c.chord == near_relative(1, 1e-14));
      CHECK((c.point - Vec2{0.5 * side, -0.0005}).norm() <= 1e-14);
    }
    CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-14);
    CHECK((swapped->normal - Vec2{0, -1}).norm() <= 1e-14);
  }
}

TEST_CASE("a sliver across a body crosses it four times and is parted by the least translation") {
  const ConvexPolygon body = rectangle({0, 0}, 1, 1);
  const ConvexPolygon sliver = rectangle({0.1, 0.4}, 4, 0.04);
  const auto contact = contact_of(body, sliver);
  REQUIRE(contact);
  CHECK(contact->depth == near_relative(0.5 - 0.4 + 0.02, 1e-13));
  CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-14);
  CHECK((contact->point - Vec2{0, 0.4}).norm() <= 1e-14);
  CHECK(contact->area == near_relative(0.04, 1e-13));
}

TEST_CASE("a body on top of itself has a finite contact with a unit normal") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  const auto contact = contact_of(square, square);
  REQUIRE(contact);
  CHECK(contact->depth == near_relative(1, 1e-14));
  CHECK(contact->normal.norm() == near_relative(1, 1e-14));
  CHECK(contact->area == near_relative(1, 1e-14));
}

TEST_CASE("a body below the round-off of the other one's coordinates has no contact") {
  // Relative to a vertex of the wedge, the pebble's coordinates are multiples of 0.25.
  const ConvexPolygon wedge{{-1e15, -2e15}, {3e15, 4e14}, {-1e15, 3e15}};
  const ConvexPolygon pebble{{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}};
  for (const auto& [a, b] : {std::pair{wedge, pebble}, std::pair{pebble, wedge}})
    CHECK(!contact_of(a, b));
}

// --- Properties of any contact ------------------------------------------------------------------

TEST_CASE("parting two bodies along the normal takes chord times way off their overlap") {
  // dA/ds = -chord along the normal and 0 along the tangent wherever two boundaries cross twice:
  // the normal points where the overlap shrinks fastest, from a to b.
  int checked = 0;
  for_random_contacts<OverlapChord>(
      400, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
        if (crossings(a, b) != 2) return;
        ++checked;
        // Areas end in digits of 1e-16, over 2e-6; they are quadratic in the shift unless a vertex
        // crosses a face meanwhile, which adds at most the shift.
        CHECK(std::abs(area_slope(a, b, contact.normal) - contact.chord) <= 3e-6);
        CHECK(std::abs(area_slope(a, b, contact.tangent())) <= 3e-6);
      });
  CHECK(checked > 200);
}

TEST_CASE("a contact without a chord is undone by shifting the second body by the depth") {
  int checked = 0;
  for_random_contacts<OverlapChord>(
      1000, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
        if (crossings(a, b) == 2) return;
        ++checked;
        const auto apart = [&](double share) {
          return !contact_of(a, shifted(b, share * contact.depth * contact.normal));
        };
        CHECK(apart(1 + 1e-9));
        CHECK(!apart(1 - 1e-6));
        // No other direction does with less.
        for (int i = 0; i < 36; ++i) {
          const Vec2 other = Rotation::from_angle(i * std::numbers::pi / 18) * Vec2{1, 0};
          CHECK(contact_of(a, shifted(b, (1 - 1e-6) * contact.depth * other)));
        }
      });
  CHECK(checked > 50);
}

TEST_CASE("swapping the bodies turns the normal round and changes nothing else") {
  for_random_contacts<OverlapChord>(
      500, [](const auto& a, const auto& b, const ContactGeometry& contact) {
        const auto swapped = contact_of(b, a);
        REQUIRE(swapped);
        ContactGeometry back = *swapped;
        back.normal = -back.normal;
        check_same(back, contact, 1e-13);
      });
}

TEST_CASE("a contact moves rigidly with its bodies, far from the origin too") {
  test::check_contacts_move_rigidly<OverlapChord>();
}

TEST_CASE("a mirrored pair has the mirrored contact") {
  for_random_contacts<OverlapChord>(
      200, [](const auto& a, const auto& b, const ContactGeometry& contact) {
        const auto image = contact_of(mirrored(a), mirrored(b));
        REQUIRE(image);
        ContactGeometry back = *image;
        back.normal.x() = -back.normal.x();
        back.point.x() = -back.point.x();
        check_same(back, contact, 1e-13);
      });
}

TEST_CASE("contacts of bodies of any size are the same, scaled to the last bit") {
  // Powers of two: no digit may depend on the unit of length.
  for (const double scale : {std::ldexp(1.0, -30), std::ldexp(1.0, 40)}) {
    const auto scaled = [scale](const ConvexPolygon& polygon) {
      std::vector<Vec2> vertices;
      for (const Vec2& v : polygon) vertices.push_back(scale * v);
      return ConvexPolygon(vertices);
    };
    for_random_contacts<OverlapChord>(
        100, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
          const auto large = contact_of(scaled(a), scaled(b));
          REQUIRE(large);
          CHECK(large->depth == scale * contact.depth);
          CHECK(large->chord == scale * contact.chord);
          CHECK(large->area == scale * scale * contact.area);
          CHECK(large->point == scale * contact.point);
          CHECK(large->normal == contact.normal);
        });
  }
}

TEST_CASE("the cache of a pair never changes the result") {
  Random random(7);
  const ConvexPolygon a = random_polygon({}, 1, random);
  const ConvexPolygon b = random_polygon({}, 1, random);
  OverlapChord::Cache kept;
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rotation at = Rotation::from_angle(0.013 * i);
    const ConvexPolygon moved =
        b.moved(Rotation::from_angle(0.031 * i), (0.8 + 0.3 * at.sine) * (at * Vec2{1, 0}));
    const auto fresh = contact_of(a, moved);
    const auto remembered = OverlapChord{}(a.ring(), moved.ring(), kept);
    REQUIRE(fresh.has_value() == remembered.has_value());
    if (!fresh) continue;
    ++touching;
    CHECK(fresh->depth == remembered->depth);
    CHECK(fresh->point == remembered->point);
    CHECK(fresh->normal == remembered->normal);
  }
  CHECK(touching > 200);
  CHECK(touching < 1800);
}

TEST_CASE("a cached edge of another pair changes nothing") {
  const ConvexPolygon a = rectangle({0, 0}, 1, 1);
  const ConvexPolygon b = tip_down({0, 0.4}, 1, 1);
  using Cache = OverlapChord::Cache;
  for (const auto state : {Cache::State::apart, Cache::State::corner_edge,
                           Cache::State::corner_corner, Cache::State::general}) {
    Cache cache{.state = state,
                .separating = {.of_b = true, .edge = 63},
                .of_b = true,
                .entry = {.edge = 63, .first = 63},
                .corner_a = 63,
                .corner_b = 63};
    CHECK(OverlapChord{}(a.ring(), b.ring(), cache));
  }
}

// --- Continuity ---------------------------------------------------------------------------------

namespace {

/// Largest change of depth, point and normal over one step of a slide, and how often there is none.
struct Jumps {
  double depth = 0;
  double point = 0;
  double normal_times_chord = 0;
  int touching = 0;
};

/// Slides a corner over a floor's surface and off its end.
Jumps slide_off(double step) {
  const ConvexPolygon floor{{-1, -1}, {0.8, -1}, {1, 0}, {-1, 0}};
  Jumps jumps;
  std::optional<ContactGeometry> before;
  // The step does not divide the way: no crossing falls on a vertex.
  for (double x = 0.31234567; x < 1.2; x += step) {
    const auto now = contact_of(floor, tip_down({x, -0.03}, 0.9, 0.6));
    if (now) ++jumps.touching;
    const double depth_before = before ? before->depth : 0;
    const double depth_now = now ? now->depth : 0;
    jumps.depth = std::max(jumps.depth, std::abs(depth_now - depth_before) * (x > 0.35 ? 1 : 0));
    if (now && before) {
      jumps.point = std::max(jumps.point, (now->point - before->point).norm());
      const double turned = (now->normal - before->normal).norm();
      jumps.normal_times_chord = std::max(jumps.normal_times_chord, turned * now->chord);
    }
    before = now;
  }
  return jumps;
}

}  // namespace

TEST_CASE("depth, point and normal of a sliding corner change no faster than the corner moves") {
  for (const double step : {1.7e-4, 1.7e-5}) {
    CAPTURE(step);
    const Jumps jumps = slide_off(step);
    CHECK(jumps.touching > 0.6 / step);
    // Where the corner leaves over the end, crossings run along faces that meet at some 45 degrees:
    // a few times as fast as the corner, never in jumps.
    CHECK(jumps.depth <= 4 * step);
    CHECK(jumps.point <= 4 * step);
    CHECK(jumps.normal_times_chord <= 4 * step);
  }
}

TEST_CASE_TEMPLATE("swapping the rings of a nearly degenerate pair changes nothing", Narrow,
                   OverlapChord, SeparatingAxis) {
  // An edge of one lies on an edge of the other, corner on corner or anywhere, but for small shifts
  // and turns.
  Random random(7);
  const auto small = [&] {
    if (random.uniform(0, 1) < 0.4) return 0.0;
    return random.uniform(-1, 1) * std::pow(10, random.uniform(-17, -3));
  };
  int contacts = 0;
  int different = 0;
  for (int trial = 0; trial < 50'000; ++trial) {
    const ConvexPolygon a = random.uniform(0, 1) < 0.5
                                ? rectangle({0, 0}, 1, 1)
                                : random_polygon({.most_vertices = 7}, 1, random);
    const double side = random.uniform(0.3, 3);
    const ConvexPolygon other = random.uniform(0, 1) < 0.5 ? rectangle({0, 0}, side, side) : a;
    const std::size_t i = random.uniform_integer(0, static_cast<unsigned>(a.size()) - 1);
    const std::size_t j = random.uniform_integer(0, static_cast<unsigned>(other.size()) - 1);
    const Vec2 edge = a[(i + 1) % a.size()] - a[i];
    const Vec2 other_edge = other[(j + 1) % other.size()] - other[j];
    const double turn = std::atan2(-edge.y(), -edge.x()) -
                        std::atan2(other_edge.y(), other_edge.x()) +
                        (random.uniform(0, 1) < 0.3 ? random.uniform(-0.5, 0.5) : small());
    const ConvexPolygon turned = other.moved(Rotation::from_angle(turn), {0, 0});
    const std::array places{0.0, 1.0, 0.5, random.uniform(-0.2, 1.2)};
    const double depth = random.uniform(0, 1) < 0.3 ? random.uniform(0, 0.05) : small();
    const Vec2 target = a[i] + (places[random.uniform_integer(0, 3)] + small()) * edge +
                        depth / edge.norm() * perpendicular(edge);
    const ConvexPolygon b = turned.moved({}, target - turned[j]);
    const auto contact = test::contact_of<Narrow>(a, b);
    const auto swapped = test::contact_of<Narrow>(b, a);
    contacts += contact.has_value();
    if (contact.has_value() != swapped.has_value()) ++different;
    if (!contact || !swapped) continue;
    // Round-off of coordinates of size 1, over the chord for directions.
    different += !((contact->normal + swapped->normal).norm() * contact->chord <= 1e-12 &&
                   (contact->point - swapped->point).norm() <= 1e-12 &&
                   std::abs(contact->depth - swapped->depth) <= 1e-12 &&
                   std::abs(contact->area - swapped->area) <= 1e-12 &&
                   std::abs(contact->chord - swapped->chord) <= 1e-12);
  }
  CHECK(contacts > 20'000);
  CHECK(different == 0);
}
