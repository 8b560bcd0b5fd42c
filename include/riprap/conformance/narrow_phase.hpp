// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the narrow phase.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {
namespace internal {

struct PolygonPair {
  ConvexPolygon a;
  ConvexPolygon b;
  double overlap =
      0;  ///< minimum translation that separates them [m]; negative: they are separated
};

/// Random polygons of a diameter of about `size` [m], one beside or upon the other. Pairs that
/// just touch are left out, for there round-off decides.
[[nodiscard]] inline std::vector<PolygonPair> polygon_pairs(double size) {
  Random random(1);
  const PolygonShape shape{.most_vertices = 6};
  std::vector<PolygonPair> pairs;
  while (pairs.size() < 400) {
    const Rotation around = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
    const Vec2 shift = around * Vec2{size * random.uniform(0.3, 1.3), 0};
    const ConvexPolygon a = random_polygon(shape, size, random);
    const ConvexPolygon b = random_polygon(shape, size, random).moved({}, shift);
    const double overlap = minimum_translation(a.ring(), b.ring()).depth;
    if (std::abs(overlap) > 0.01 * size) pairs.push_back({a, b, overlap});
  }
  return pairs;
}

/// The contact of a pair with an empty cache.
template <NarrowPhase N>
[[nodiscard]] std::optional<ContactGeometry> meet(const N& narrow, const ConvexPolygon& a,
                                                  const ConvexPolygon& b) {
  typename N::Cache cache{};
  return narrow(a.ring(), b.ring(), cache);
}

/// That `found` is `expected`, both in metres. Round-off of coordinates, some 1e-14 of their size,
/// grows where edges graze each other, and once more in the direction of a short chord.
/// @param far how many sizes away from the origin the digits were lost
inline void check_same_contact(std::string_view axiom, const std::optional<ContactGeometry>& found,
                               const std::optional<ContactGeometry>& expected, double size,
                               double far, AxiomCheck& check) {
  check.equal(axiom, found.has_value(), expected.has_value(), 0);
  if (!found || !expected) return;
  const double length = 1e-11 * (1 + far) * size;
  check.equal(axiom, found->depth, expected->depth, length);
  check.equal(axiom, found->chord, expected->chord, length);
  check.equal(axiom, found->area, expected->area, length * size);
  check.equal(axiom, found->depth_gradient, expected->depth_gradient, length / size);
  check.equal(axiom, (found->point - expected->point).norm(), 0, length);
  check.equal(axiom, (found->normal - expected->normal).norm(), 0,
              length / std::max(expected->chord, 1e-3 * size));
}

template <NarrowPhase N>
void check_contact(const N& narrow, const PolygonPair& pair, double size, AxiomCheck& check) {
  const auto contact = meet(narrow, pair.a, pair.b);
  check.holds("rings that keep apart have no contact", pair.overlap > 0 || !contact);
  if (!contact) return;
  check.equal("the normal is a unit vector", contact->normal.norm(), 1, 1e-12);
  check.at_least("the depth is not negative", contact->depth, 0);
  check.at_least("the area is not negative", contact->area, 0);
  check.at_least("the chord is not negative", contact->chord, 0);
  check.at_least("the gradient of the depth is not negative", contact->depth_gradient, 0);
  const auto common = [&](const Vec2& shift) {
    const ConvexPolygon b = pair.b.moved({}, shift);
    return area_properties(overlap(pair.a.ring(), b.ring(), pair.a[0], 0).ring()).area;
  };
  check.at_most("the normal points from a to b: overlap after a shift of b along it [m^2]",
                common(1e-3 * size * contact->normal), common({0, 0}) + 1e-12 * size * size);
}

template <NarrowPhase N>
void check_pair_symmetry(const N& narrow, const PolygonPair& pair, double size, AxiomCheck& check) {
  auto expected = meet(narrow, pair.a, pair.b);
  auto swapped = meet(narrow, pair.b, pair.a);
  if (swapped) swapped->normal = -swapped->normal;
  check_same_contact("swapped rings have the opposite normal, and all else the same", swapped,
                     expected, size, 1, check);

  const Rotation turn = Rotation::from_angle(2.1);
  const Vec2 shift = size * Vec2{30, -50};
  const auto moved = meet(narrow, pair.a.moved(turn, shift), pair.b.moved(turn, shift));
  if (expected) {
    expected->normal = turn * expected->normal;
    expected->point = turn * expected->point + shift;
  }
  check_same_contact("rings moved and turned have the contact moved and turned", moved, expected,
                     size, 60, check);
}

/// Pairs evaluated in batches have the contacts of pairs evaluated singly, bitwise.
template <BatchedNarrowPhase N>
void check_groups(const N& narrow, const std::vector<PolygonPair>& pairs, AxiomCheck& check) {
  std::array<typename N::Cache, N::Batch::capacity> memories;
  std::array<ContactGeometry, N::Batch::capacity> contacts;
  std::array<const PolygonPair*, N::Batch::capacity> members;
  typename N::Batch batch;
  for (const PolygonPair& pair : pairs) {
    const std::size_t k = batch.size();
    memories[k] = {};
    if (!narrow(pair.a.ring(), pair.b.ring(), memories[k])) continue;
    members[k] = &pair;
    if (!batch.add(pair.a.ring(), pair.b.ring(), memories[k], contacts[k])) continue;
    if (batch.size() < contacts.size()) continue;
    const unsigned found = narrow.find(batch);
    batch.clear();
    for (std::size_t l = 0; l < contacts.size(); ++l)
      if ((found >> l & 1U) != 0)
        check_same_contact("a batch changes no contact", contacts[l],
                           meet(narrow, members[l]->a, members[l]->b), 0, 0, check);
  }
}

}  // namespace internal

/// Which axioms a narrow phase breaks for random polygons of about `size` [m].
template <NarrowPhase N>
[[nodiscard]] Violations narrow_phase_violations(const N& narrow, double size = 0.016) {
  AxiomCheck check;
  typename N::Cache cache{};  // of whatever pair came before
  for (const internal::PolygonPair& pair : internal::polygon_pairs(size)) {
    check.at("overlap", pair.overlap);
    internal::check_contact(narrow, pair, size, check);
    internal::check_pair_symmetry(narrow, pair, size, check);
    const auto remembering = narrow(pair.a.ring(), pair.b.ring(), cache);
    internal::check_same_contact("memory never changes the answer", remembering,
                                 internal::meet(narrow, pair.a, pair.b), 0, 0, check);
    if constexpr (requires { narrow.clearance(cache); })
      if (!remembering)
        check.at_most("the clearance is no more than the distance of the rings [m]",
                      narrow.clearance(cache), -pair.overlap + 1e-12 * size);
  }
  if constexpr (BatchedNarrowPhase<N>)
    internal::check_groups(narrow, internal::polygon_pairs(size), check);
  return std::move(check).violations();
}

/// Which results change, beyond their unit, when polygons and narrow phase are given in other units
/// of length.
/// @param other `narrow` with its parameters in `units`
template <NarrowPhase N>
[[nodiscard]] Violations narrow_phase_unit_violations(const N& narrow, const N& other,
                                                      const Units& units = {},
                                                      double size = 0.016) {
  AxiomCheck check;
  const auto in_units = [&units](const ConvexPolygon& polygon) {
    std::vector<Vec2> vertices;
    for (const Vec2& v : polygon) vertices.push_back(units.length * v);
    return ConvexPolygon(std::move(vertices));
  };
  for (const internal::PolygonPair& pair : internal::polygon_pairs(size)) {
    auto same = internal::meet(other, in_units(pair.a), in_units(pair.b));
    if (same) {
      same->point /= units.length;
      same->depth /= units.length;
      same->chord /= units.length;
      same->area /= units.area();
    }
    internal::check_same_contact("a contact is the same in other units", same,
                                 internal::meet(narrow, pair.a, pair.b), size, 1, check);
  }
  return std::move(check).violations();
}

}  // namespace riprap
