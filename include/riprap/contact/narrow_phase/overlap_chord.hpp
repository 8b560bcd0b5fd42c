#pragma once
/// @file
/// Contact line through the two points where the boundaries cross: the default narrow phase.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/contact_line.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>
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
  /// How the two lay last time, and the edge that told.
  struct Memory {
    enum class State : std::uint8_t {
      apart,     ///< the edge parts them
      one_edge,  ///< one has entered the other through this edge alone
      entangled  ///< no single edge tells: clip
    };
    SeparatingEdge edge;
    State state = State::apart;
  };

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Memory& memory) const {
    const Ring ring = memory.edge.of_b ? b : a;
    const std::size_t i = memory.edge.edge;
    if (memory.state != Memory::State::entangled && i < ring.size()) {
      const EdgeSide side = edge_side(ring, i, memory.edge.of_b ? a : b);
      if (side.deepest < 0) {
        memory = {{memory.edge.of_b, memory.edge.edge, -side.depth(ring, i)}, Memory::State::apart};
        return std::nullopt;
      }
      if (const auto contact = through_edge(a, b, memory.edge, side)) {
        memory.state = Memory::State::one_edge;
        return contact;
      }
    }
    if (memory.state == Memory::State::apart && find_separating_edge(a, b, memory.edge))
      return std::nullopt;
    return by_clipping(a, b, memory);
  }

  /// How far apart the rings were at least when they last had no contact [m].
  [[nodiscard]] double clearance(const Memory& memory) const { return memory.edge.gap; }

 private:
  // The contact of a cap. Knowing the edge, it costs a fifth of clipping.
  [[nodiscard]] static std::optional<ContactGeometry>
  through_edge(Ring a, Ring b, const SeparatingEdge& edge, const EdgeSide& side) {
    const auto across = [](Ring ring) {
      return (ring[ring.size() / 2] - ring[0]).cwiseAbs().sum();
    };
    // Far above round-off: clipping would see the same crossings, so that the answer does not
    // depend on who gives it.
    const double margin = 1e-8 * (across(a) + across(b));
    const auto cap = edge_cap(edge.of_b ? b : a, edge.edge, edge.of_b ? a : b, side, margin);
    if (!cap) return std::nullopt;
    return ContactGeometry{.normal = edge.of_b ? Vec2(-cap->normal) : cap->normal,
                           .point = 0.5 * (cap->entry + cap->exit),
                           .depth = std::min(cap->depth, 2 * cap->area / cap->chord),
                           .area = cap->area,
                           .chord = cap->chord};
  }

  [[nodiscard]] static std::optional<ContactGeometry> by_clipping(Ring a, Ring b, Memory& memory) {
    const CommonPart common = common_part(a, b);
    // Where rings barely meet, round-off must not decide between clipping and a separating edge.
    if (common.area <= 1e-9 * common.size * common.size) {
      memory = {{memory.edge.of_b, memory.edge.edge, 0}, Memory::State::apart};
      if (find_separating_edge(a, b, memory.edge) || common.empty()) return std::nullopt;
    }
    if (const auto edge = common.only_edge_of_one()) {
      const SeparatingEdge entered{edge->of_b, edge->edge, 0};
      const EdgeSide side = edge->of_b ? edge_side(b, edge->edge, a) : edge_side(a, edge->edge, b);
      if (const auto contact = through_edge(a, b, entered, side)) {
        memory = {entered, Memory::State::one_edge};
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
