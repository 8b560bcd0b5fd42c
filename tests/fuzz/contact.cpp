// SPDX-License-Identifier: BSL-1.0
// Two polygons of any size, one beside, on or in the other: the common part, OverlapChord and
// SeparatingAxis.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/separating_axis.hpp>
#include <riprap/geometry/overlap.hpp>

#include "check.hpp"
#include "shapes.hpp"
#include "targets.hpp"

namespace riprap::fuzz {

namespace {

using Wide = long double;
using WidePoint = std::array<Wide, 2>;

/// The area that two rings have in common, in more digits than the library's.
double exact_common_area(Ring a, Ring b) {
  const auto place = [&](const Vec2& v) -> WidePoint {
    return {static_cast<Wide>(v.x()) - static_cast<Wide>(a[0].x()),
            static_cast<Wide>(v.y()) - static_cast<Wide>(a[0].y())};
  };
  std::vector<WidePoint> part;
  for (const Vec2& v : a) part.push_back(place(v));
  for (std::size_t j = 0; j < b.size() && !part.empty(); ++j) {
    const WidePoint p = place(b[j]);
    const WidePoint q = place(b[(j + 1) % b.size()]);
    const auto side = [&](const WidePoint& v) {
      return (q[0] - p[0]) * (v[1] - p[1]) - (q[1] - p[1]) * (v[0] - p[0]);
    };
    std::vector<WidePoint> kept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const WidePoint& u = part[i];
      const WidePoint& v = part[(i + 1) % part.size()];
      const Wide d = side(u);
      const Wide d_next = side(v);
      if (d >= 0) kept.push_back(u);
      if ((d >= 0) == (d_next >= 0)) continue;
      const Wide t = d / (d - d_next);
      kept.push_back({u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1])});
    }
    part = std::move(kept);
  }
  Wide twice_area = 0;
  for (std::size_t i = 1; i + 1 < part.size(); ++i)
    twice_area += (part[i][0] - part[0][0]) * (part[i + 1][1] - part[0][1]) -
                  (part[i][1] - part[0][1]) * (part[i + 1][0] - part[0][0]);
  return static_cast<double>(std::max<Wide>(twice_area / 2, 0));
}

/// A pair with what round-off of its coordinates does to lengths and areas.
struct Pair {
  Ring a;
  Ring b;
  double smaller_size;
  double smaller_area;
  double round_off;  ///< [m]
  double common_area;

  Pair(Ring first, Ring second)
      : a(first), b(second), smaller_size(std::min(diameter(a), diameter(b))),
        smaller_area(std::min(polygon_area(a), polygon_area(b))),
        round_off(1e-14 * std::max({largest_coordinate(a), largest_coordinate(b), diameter(a),
                                    diameter(b)})),
        common_area(exact_common_area(a, b)) {}
  [[nodiscard]] double area_round_off() const { return smaller_size * round_off; }
  /// Of the vertices of the common part along an edge: the more, the smaller the angle between the
  /// two edges that meet there. Clipping finds corners, too, as crossings of two edges.
  [[nodiscard]] double crossing_round_off() const {
    double sine = 1;
    const auto add = [&sine](const LineSide& p, const LineSide& q) {
      const double between =
          std::abs(p.x * q.y - p.y * q.x) / (std::hypot(p.x, p.y) * std::hypot(q.x, q.y));
      if (between > 0) sine = std::min(sine, between);
    };
    const auto edge = [](Ring ring, std::size_t i) {
      return LineSide(ring[i], ring[next_vertex(i, ring.size())]);
    };
    for (const Ring ring : {a, b})
      for (std::size_t i = 0; i < ring.size(); ++i)
        add(edge(ring, i), edge(ring, next_vertex(i, ring.size())));
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const LineSide p = edge(a, i);
        const LineSide q = edge(b, j);
        if ((p(b[j]) > 0) != (p(b[next_vertex(j, b.size())]) > 0) &&
            (q(a[i]) > 0) != (q(a[next_vertex(i, a.size())]) > 0))
          add(p, q);
      }
    return round_off / sine;
  }
  /// Not so for sizes that differ by ten powers of ten: a corner far away may have no digits of the
  /// small polygon left.
  [[nodiscard]] bool has_digits() const { return round_off <= 1e-4 * smaller_size; }
};

void check_common_part(const Pair& pair) {
  const OverlapPolygon common = overlap(pair.a, pair.b, pair.a[0], 0);
  for (std::size_t i = 0; i < common.size; ++i) {
    const EdgeSource source = common.sources[i];
    check(is_finite(common.vertices[i]), "vertices of the common part are finite");
    check(source.edge < (source.of_b ? pair.b : pair.a).size(),
          "edges of the common part are edges of the rings");
  }
  if (!pair.has_digits()) return;
  const double area = polygon_area(common.ring());
  check(std::abs(area - pair.common_area) <= 8 * pair.area_round_off(),
        "the common part has the area that more digits give it",
        {area, pair.common_area, pair.area_round_off()});
  check(area <= pair.smaller_area + 8 * pair.area_round_off(),
        "the common part is no larger than the smaller polygon", {area, pair.smaller_area});
}

/// How far x lies outside a ring [m]; not positive inside.
double distance_outside(Ring ring, const Vec2& x) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    farthest = std::max(farthest, -cross(edge, x - ring[i]) / edge.norm());
  }
  return farthest;
}

void check_contact(const Pair& pair, const ContactGeometry& contact) {
  check(is_finite(contact.normal) && is_finite(contact.point) && std::isfinite(contact.depth) &&
            std::isfinite(contact.area) && std::isfinite(contact.chord),
        "a contact is finite",
        {contact.normal.x(), contact.normal.y(), contact.point.x(), contact.point.y(),
         contact.depth, contact.area, contact.chord});
  check(std::abs(contact.normal.norm() - 1) <= 1e-12, "the normal is a unit vector",
        {contact.normal.x(), contact.normal.y()});
  check(contact.depth >= 0 && contact.area >= 0 && contact.chord >= 0,
        "depth, area and chord are not negative", {contact.depth, contact.area, contact.chord});
  if (!pair.has_digits()) return;
  check(contact.area <= pair.smaller_area + 8 * pair.area_round_off(),
        "the area of a contact is at most that of the smaller polygon",
        {contact.area, pair.smaller_area});
  check(contact.chord <= pair.smaller_size + 8 * pair.crossing_round_off(),
        "the chord is no longer than the smaller polygon", {contact.chord, pair.smaller_size});
  check(std::abs(contact.area - pair.common_area) <= 8 * pair.area_round_off(),
        "the area of a contact is that of the common part",
        {contact.area, pair.common_area, pair.area_round_off()});
  for (const Ring ring : {pair.a, pair.b})
    check(distance_outside(ring, contact.point) <= 8 * pair.round_off,
          "the point of a contact lies in both polygons", {distance_outside(ring, contact.point)});
}

/// The least translation leaves nothing in common.
void check_least_translation(const Pair& pair, const ContactGeometry& contact) {
  if (!pair.has_digits()) return;
  std::vector<Vec2> shifted;
  for (const Vec2& v : pair.b)
    shifted.push_back(v + (contact.depth + 8 * pair.round_off) * contact.normal);
  const double left = exact_common_area(pair.a, shifted);
  check(left <= pair.area_round_off(), "a shift by the depth parts the polygons", {left});
}

bool same(const std::optional<ContactGeometry>& p, const std::optional<ContactGeometry>& q) {
  if (!p || !q) return p.has_value() == q.has_value();
  return p->normal == q->normal && p->point == q->point && p->depth == q->depth &&
         p->area == q->area && p->chord == q->chord;
}

void check_same(const std::optional<ContactGeometry>& p, const std::optional<ContactGeometry>& q,
                std::string_view sentence) {
  if (same(p, q)) return;
  const ContactGeometry x = p.value_or(ContactGeometry{});
  const ContactGeometry y = q.value_or(ContactGeometry{});
  check(false, sentence,
        {x.normal.x(), x.normal.y(), x.point.x(), x.point.y(), x.depth, x.area, x.chord,
         y.normal.x(), y.normal.y(), y.point.x(), y.point.y(), y.depth, y.area, y.chord});
}

template <class Narrow>
std::optional<ContactGeometry> fresh_contact(Ring a, Ring b) {
  typename Narrow::Cache cache{};
  return Narrow{}(a, b, cache);
}

/// A full group of one pair.
void check_group(const Pair& pair, const OverlapChord::Cache& cache,
                 const std::optional<ContactGeometry>& alone) {
  OverlapChord::Batch batch;
  std::array<ContactGeometry, OverlapChord::Batch::capacity> contacts;
  for (ContactGeometry& contact : contacts)
    if (!batch.add(pair.a, pair.b, cache, contact)) return;
  const unsigned found = OverlapChord{}.find(batch);
  for (std::size_t l = 0; l < contacts.size(); ++l)
    if ((found >> l & 1U) != 0) check_same(contacts[l], alone, "a group changes a contact");
}

template <class Narrow>
void check_narrow_phase(const Pair& pair, typename Narrow::Cache& kept) {
  const Narrow narrow;
  const auto contact = fresh_contact<Narrow>(pair.a, pair.b);
  if (contact) {
    check_contact(pair, *contact);
    if constexpr (std::is_same_v<Narrow, SeparatingAxis>) check_least_translation(pair, *contact);
  } else if (pair.has_digits()) {
    // Common parts of a width below 1e-13 of the size are left out.
    check(pair.common_area <= 40 * pair.area_round_off(), "rings that overlap have a contact",
          {pair.common_area, pair.area_round_off()});
  }

  // Of two equal rings none comes first.
  if (!std::ranges::equal(pair.a, pair.b)) {
    auto swapped = fresh_contact<Narrow>(pair.b, pair.a);
    if (swapped) swapped->normal = -swapped->normal;
    check_same(contact, swapped, "swapped rings have another contact");
  }
  if constexpr (requires { typename Narrow::Batch; }) check_group(pair, kept, contact);
  const auto remembered = narrow(pair.a, pair.b, kept);
  if (!pair.has_digits()) return;
  check_same(contact, remembered, "what a pair remembers changes its contact");
  if (!remembered) {
    // Rings whose common part is narrower than round-off have no contact, but are not apart.
    const double distance = std::max(-minimum_translation(pair.a, pair.b).depth, 0.0);
    check(narrow.clearance(kept) <= distance + 8 * pair.round_off,
          "the clearance is no more than the distance of the rings",
          {narrow.clearance(kept), distance});
  }
}

/// b with one of its edges along an edge of a, but for small turns and shifts.
std::optional<ConvexPolygon> laid_on(const ConvexPolygon& a, const ConvexPolygon& b, Input& input) {
  const std::size_t i = input.below(static_cast<unsigned>(a.size()));
  const std::size_t j = input.below(static_cast<unsigned>(b.size()));
  const Vec2 edge = a[(i + 1) % a.size()] - a[i];
  const Vec2 other = b[(j + 1) % b.size()] - b[j];
  const double length = edge.norm() * other.norm();
  // Turns the one against the other; exact where both are multiples of small numbers.
  Rotation turn{-edge.dot(other) / length, cross(edge, other) / length};
  const unsigned kind = input.byte();
  if ((kind & 3U) != 0) {
    const double angle = (kind & 3U) == 1 ? input.tiny() : 6.3 * input.share();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    turn = {c * turn.cosine - s * turn.sine, s * turn.cosine + c * turn.sine};
  }
  double along = (kind >> 2 & 3U) * 0.5;
  if ((kind & 16U) != 0) along += input.tiny();
  if ((kind & 32U) != 0) along += 2 * input.share() - 1;
  const double depth = (kind & 64U) != 0 ? input.share() : input.tiny();
  const double size = std::min(diameter(a.ring()), diameter(b.ring()));
  const Vec2 target = a[i] + along * edge + depth * size / edge.norm() * perpendicular(edge);
  std::vector<Vec2> vertices;
  for (const Vec2& v : b) vertices.push_back(turn * (v - b[j]) + target);
  return try_convex_polygon(std::move(vertices));
}

std::optional<ConvexPolygon> second_polygon(const ConvexPolygon& a, Input& input) {
  const unsigned kind = input.below(8);
  std::optional<ConvexPolygon> b = kind < 3 ? a : polygon_from(input);
  if (!b || kind == 7) return b;
  if (kind % 2 == 0) return laid_on(a, *b, input);
  std::vector<Vec2> vertices;
  const Vec2 shift = diameter(a.ring()) * Vec2{input.tiny(), input.tiny()};
  for (const Vec2& v : *b) vertices.push_back(v - (*b)[0] + a[0] + shift);
  return try_convex_polygon(std::move(vertices));
}

std::optional<ConvexPolygon> moved_a_little(const ConvexPolygon& b, Input& input) {
  const unsigned kind = input.byte();
  const Rotation turn = Rotation::from_angle((kind & 1U) != 0 ? input.tiny() : 0);
  const double reach = diameter(b.ring()) * ((kind & 2U) != 0 ? 0.1 : 1);
  const Vec2 shift = (kind & 4U) != 0 ? reach * Vec2{input.number(), input.number()}
                                      : reach * Vec2{input.tiny(), input.tiny()};
  std::vector<Vec2> vertices;
  for (const Vec2& v : b) vertices.push_back(turn * (v - b[0]) + b[0] + shift);
  return try_convex_polygon(std::move(vertices));
}

}  // namespace

void contact(Bytes bytes) {
  Input input(bytes);
  const std::optional<ConvexPolygon> a = polygon_from(input);
  if (!a) return;
  std::optional<ConvexPolygon> b = second_polygon(*a, input);
  OverlapChord::Cache chord{};
  SeparatingAxis::Cache axis{};
  for (int step = 0; step < 8 && b; ++step) {
    const Pair pair(a->ring(), b->ring());
    check_common_part(pair);
    check_narrow_phase<OverlapChord>(pair, chord);
    check_narrow_phase<SeparatingAxis>(pair, axis);
    if (input.empty()) return;
    b = moved_a_little(*b, input);
  }
}

}  // namespace riprap::fuzz
