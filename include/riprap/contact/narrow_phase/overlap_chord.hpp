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
#include <riprap/geometry/corner_lens.hpp>
#include <riprap/geometry/edge_cap.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {

/// The contact line of POLY (Mirghasemi, Rothenburg and Matyas 1997). Where the two boundaries
/// cross exactly twice, the contact line is the chord through the crossings: the normal is
/// perpendicular to it, the force acts at its middle, and the depth is the smaller of the overlap's
/// extent along the normal and twice its area over the chord (equal for a corner in an edge).
/// Elsewhere (containment, flush edges, more crossings) normal and depth come from the minimum
/// translation and the point is the overlap's centroid.
struct OverlapChord {
  /// How the two lay last time.
  struct Memory {
    enum class State : std::uint8_t {
      apart,     ///< an edge parts them
      cap,       ///< one has entered the other through a single edge
      lens,      ///< a corner of each is in the other
      entangled  ///< anything else
    };
    State state = State::apart;
    SeparatingEdge separating;  ///< apart
    bool of_b = false;          ///< cap: whose edge
    EntryPlace entry;           ///< cap
    std::uint8_t corner_a = 0;  ///< lens
    std::uint8_t corner_b = 0;  ///< lens
  };

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Memory& memory) const {
    if (memory.state == Memory::State::cap) {
      if (auto contact = at_cap(a, b, memory)) return contact;
    } else if (memory.state == Memory::State::lens) {
      if (auto contact = at_lens(a, b, memory.corner_a, memory.corner_b)) return contact;
    } else if (memory.state == Memory::State::apart && separated(a, b, memory.separating)) {
      return std::nullopt;
    }
    return by_clipping(a, b, memory);
  }

  /// Pairs whose contacts are found together: caps, the commonest ones, side by side in vector
  /// registers. That takes a fifth of a step's time away.
  class Group {
   public:
    using Of = OverlapChord;
    static constexpr std::size_t capacity = cap_lanes;

    [[nodiscard]] std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    [[nodiscard]] bool add(Ring a, Ring b, const Memory& memory, ContactGeometry& contact) {
      if (memory.state != Memory::State::cap) return false;
      const Ring ring = memory.of_b ? b : a;
      const Ring other = memory.of_b ? a : b;
      if (!memory.entry.fits(ring, other)) return false;
      questions_[size_] = {ring.data(), other.data(), &memory.entry};
      signs_[size_] = memory.of_b ? -1 : 1;
      contacts_[size_] = &contact;
      ++size_;
      return true;
    }

   private:
    friend OverlapChord;
    std::size_t size_ = 0;
    CapQuestions questions_;
    std::array<double, capacity> signs_;
    std::array<ContactGeometry*, capacity> contacts_;
  };
  /// Of a full group.
  [[nodiscard]] unsigned find(const Group& group) const {
    unsigned found = 0;
    find_edge_caps(group.questions_, [&](std::size_t l, const EdgeCap& cap) {
      *group.contacts_[l] = contact_at(cap, group.signs_[l]);
      found |= 1U << l;
    });
    return found;
  }

  /// How far apart the rings were at least when they last had no contact [m].
  [[nodiscard]] double clearance(const Memory& memory) const { return memory.separating.gap; }

 private:
  // Far above round-off: clipping would see the same crossings, so that the answer does not depend
  // on who gives it.
  [[nodiscard]] static double margin(Ring a, Ring b) {
    const auto across = [](Ring ring) {
      const Vec2& p = ring[0];
      const Vec2& q = ring[ring.size() / 2];
      return std::abs(p.x() - q.x()) + std::abs(p.y() - q.y());
    };
    return 1e-8 * (across(a) + across(b));
  }

  // @param sign of the normal: -1 for an edge of b
  [[nodiscard]] static ContactGeometry contact_at(const EdgeCap& cap, double sign) {
    return {.normal = {sign * cap.normal.x(), sign * cap.normal.y()},
            .point = cap.middle,
            .depth = cap.one_vertex ? cap.depth : std::min(cap.depth, 2 * cap.area / cap.chord),
            .area = cap.area,
            .chord = cap.chord};
  }
  [[nodiscard]] static std::optional<ContactGeometry> at_cap(Ring a, Ring b, const Memory& memory) {
    const auto cap = memory.of_b ? edge_cap(b, a, memory.entry) : edge_cap(a, b, memory.entry);
    if (!cap) return std::nullopt;
    return contact_at(*cap, memory.of_b ? -1 : 1);
  }

  [[nodiscard]] static std::optional<ContactGeometry> at_lens(Ring a, Ring b, std::size_t corner_a,
                                                              std::size_t corner_b) {
    if (corner_a >= a.size() || corner_b >= b.size()) return std::nullopt;
    const auto lens = corner_lens(a, corner_a, b, corner_b, margin(a, b));
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

  // General case: clips the rings, in an order of their own, and classifies the overlap for the
  // next call.
  [[nodiscard]] static std::optional<ContactGeometry> by_clipping(Ring a, Ring b, Memory& memory) {
    if (!internal::comes_first(b, a)) return by_clipping_in_order(a, b, memory);
    std::optional<ContactGeometry> contact = by_clipping_in_order(b, a, memory);
    memory.separating.of_b = !memory.separating.of_b;
    memory.of_b = !memory.of_b;
    std::swap(memory.corner_a, memory.corner_b);
    if (contact) contact->normal = -contact->normal;
    return contact;
  }

  [[nodiscard]] static std::optional<ContactGeometry> by_clipping_in_order(Ring a, Ring b,
                                                                           Memory& memory) {
    const CommonPart common = common_part(a, b);
    // Where rings barely meet, round-off must not decide between clipping and a separating edge.
    if (common.empty() || common.area <= 1e-9 * common.size * common.size) {
      memory.state = Memory::State::apart;
      memory.separating.gap = 0;
      if (find_separating_edge(a, b, memory.separating) || common.empty()) return std::nullopt;
    }
    if (const auto entry = common.entry(a.size(), b.size())) {
      memory.state = Memory::State::cap;
      memory.of_b = entry->of_b;
      memory.entry = entry->place;
      if (auto contact = at_cap(a, b, memory)) return contact;
    }
    if (const auto corners = common.corners()) {
      if (auto contact = at_lens(a, b, corners->first, corners->second)) {
        memory.state = Memory::State::lens;
        memory.corner_a = corners->first;
        memory.corner_b = corners->second;
        return contact;
      }
    }
    memory.state = Memory::State::entangled;
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
