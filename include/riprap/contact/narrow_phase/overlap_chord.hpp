// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact line through the two points where the boundaries cross: the default narrow phase.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/contact_line.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>
#include <riprap/geometry/corner_edge_overlap.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {

/// The contact line of POLY (Mirghasemi, Rothenburg and Matyas 1997). Where the two boundaries
/// cross exactly twice, the contact line is the chord through the crossings: the normal is
/// perpendicular to it, the force acts at its middle, and the depth is the smaller of the overlap's
/// extent along the normal and twice its area over the chord (equal for a corner in an edge).
/// Elsewhere (containment, flush edges, more crossings) normal and depth come from the minimum
/// translation and the point is the overlap's centroid.
struct OverlapChord {
  /// Class of the overlap at the last evaluation.
  struct Cache {
    enum class State : std::uint8_t {
      apart,          ///< separated by an edge
      corner_edge,    ///< one or two corners of one ring beyond a single edge of the other
      corner_corner,  ///< one corner of each ring inside the other
      general         ///< anything else
    };
    State state = State::apart;
    SeparatingEdge separating;  ///< apart
    bool of_b = false;          ///< corner_edge: whose edge
    CornerEdgeFeature entry;    ///< corner_edge
    std::uint8_t corner_a = 0;  ///< corner_corner
    std::uint8_t corner_b = 0;  ///< corner_corner
  };

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    if (cache.state == Cache::State::corner_edge) {
      if (auto contact = corner_edge_contact(a, b, cache)) return contact;
    } else if (cache.state == Cache::State::corner_corner) {
      if (auto contact = corner_corner_contact(a, b, cache.corner_a, cache.corner_b))
        return contact;
    } else if (cache.state == Cache::State::apart && separated(a, b, cache.separating)) {
      return std::nullopt;
    }
    return by_clipping(a, b, cache);
  }

  /// Pairs whose overlaps are corner-edge, the most common class, evaluated together (SIMD).
  class Batch {
   public:
    using Of = OverlapChord;
    static constexpr std::size_t capacity = 4;

    [[nodiscard]] std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    [[nodiscard]] bool add(Ring a, Ring b, const Cache& cache, ContactGeometry& contact) {
      if (cache.state != Cache::State::corner_edge) return false;
      const Ring ring = cache.of_b ? b : a;
      const Ring other = cache.of_b ? a : b;
      if (!cache.entry.fits(ring, other)) return false;
      queries_[size_] = {ring.data(), other.data(), &cache.entry};
      signs_[size_] = cache.of_b ? -1 : 1;
      contacts_[size_] = &contact;
      ++size_;
      return true;
    }

   private:
    friend OverlapChord;
    std::size_t size_ = 0;
    std::array<CornerEdgeQuery, capacity> queries_;
    std::array<double, capacity> signs_;
    std::array<ContactGeometry*, capacity> contacts_;
  };
  /// Evaluates a full batch.
  [[nodiscard]] unsigned find(const Batch& batch) const {
    unsigned found = 0;
    find_corner_edge_overlaps(batch.queries_, [&](std::size_t l, const CornerEdgeOverlap& cap) {
      *batch.contacts_[l] = contact_at(cap, batch.signs_[l]);
      found |= 1U << l;
    });
    return found;
  }

  /// Lower bound on the distance of the rings at the last evaluation without a contact [m].
  [[nodiscard]] double clearance(const Cache& cache) const { return cache.separating.gap; }

 private:
  // Far above round-off: clipping would find the same crossings, so that closed forms and clipping
  // agree on the class of the overlap.
  [[nodiscard]] static double margin(Ring a, Ring b) {
    const auto across = [](Ring ring) {
      const Vec2& p = ring[0];
      const Vec2& q = ring[ring.size() / 2];
      return std::abs(p.x() - q.x()) + std::abs(p.y() - q.y());
    };
    return 1e-8 * (across(a) + across(b));
  }

  // @param sign of the normal: -1 for an edge of b
  [[nodiscard]] static ContactGeometry contact_at(const CornerEdgeOverlap& cap, double sign) {
    return {.normal = {sign * cap.normal.x(), sign * cap.normal.y()},
            .point = cap.middle,
            .depth = cap.one_vertex ? cap.depth : std::min(cap.depth, 2 * cap.area / cap.chord),
            .area = cap.area,
            .chord = cap.chord};
  }
  [[nodiscard]] static std::optional<ContactGeometry> corner_edge_contact(Ring a, Ring b,
                                                                          const Cache& cache) {
    const auto cap = cache.of_b ? corner_edge_overlap(b, a, cache.entry)
                                : corner_edge_overlap(a, b, cache.entry);
    if (!cap) return std::nullopt;
    return contact_at(*cap, cache.of_b ? -1 : 1);
  }

  [[nodiscard]] static std::optional<ContactGeometry>
  corner_corner_contact(Ring a, Ring b, std::size_t corner_a, std::size_t corner_b) {
    if (corner_a >= a.size() || corner_b >= b.size()) return std::nullopt;
    const auto lens = corner_corner_overlap(a, corner_a, b, corner_b, margin(a, b));
    if (!lens) return std::nullopt;
    const double x = lens->leaves_a.x() - lens->enters_a.x();
    const double y = lens->leaves_a.y() - lens->enters_a.y();
    const double chord = std::sqrt(x * x + y * y);
    const double scale = 1 / chord;
    // Of a quadrangle over its diagonal the extent is twice the area over it.
    return ContactGeometry{.normal = {y * scale, -x * scale},
                           .point = 0.5 * (lens->leaves_a + lens->enters_a),
                           .depth = 2 * lens->area * scale,
                           .area = lens->area,
                           .chord = chord};
  }

  // General case: clips the rings, in an order independent of that of the arguments, and classifies
  // the overlap for the next call.
  [[nodiscard]] static std::optional<ContactGeometry> by_clipping(Ring a, Ring b, Cache& cache) {
    if (!internal::comes_first(b, a)) return by_clipping_in_order(a, b, cache);
    std::optional<ContactGeometry> contact = by_clipping_in_order(b, a, cache);
    cache.separating.of_b = !cache.separating.of_b;
    cache.of_b = !cache.of_b;
    std::swap(cache.corner_a, cache.corner_b);
    if (contact) contact->normal = -contact->normal;
    return contact;
  }

  [[nodiscard]] static std::optional<ContactGeometry> by_clipping_in_order(Ring a, Ring b,
                                                                           Cache& cache) {
    const CommonPart common = common_part(a, b);
    // Where rings barely meet, round-off must not decide between clipping and a separating edge.
    if (common.empty() || common.area <= 1e-9 * common.size * common.size) {
      cache.state = Cache::State::apart;
      cache.separating.gap = 0;
      if (find_separating_edge(a, b, cache.separating) || common.empty()) return std::nullopt;
    }
    if (const auto entry = common.entry(a.size(), b.size())) {
      cache.state = Cache::State::corner_edge;
      cache.of_b = entry->of_b;
      cache.entry = entry->place;
      if (auto contact = corner_edge_contact(a, b, cache)) return contact;
    }
    if (const auto corners = common.corners()) {
      if (auto contact = corner_corner_contact(a, b, corners->first, corners->second)) {
        cache.state = Cache::State::corner_corner;
        cache.corner_a = corners->first;
        cache.corner_b = corners->second;
        return contact;
      }
    }
    cache.state = Cache::State::general;
    ContactGeometry contact = contact_line(a, b, common);
    if (!(contact.chord > 0)) return least_translation_contact(a, b, common);
    contact.area = common.area;
    contact.depth = std::min(extent_along(common.polygon.ring(), contact.normal),
                             2 * contact.area / contact.chord);
    return contact;
  }
};

static_assert(NarrowPhase<OverlapChord>);

}  // namespace riprap
