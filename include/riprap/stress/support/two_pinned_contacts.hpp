// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Two contacts are held fast, the others load the particle: the paper's support.

#include <cstddef>
#include <span>
#include <utility>

#include <riprap/stress/support/concepts.hpp>

namespace riprap {

/// Pins two contact points in both directions, one constraint more than needed: the force along the
/// line that joins them follows from the distance between them being kept. The choice of the two
/// changes the stress field by tens of per cent.
///
/// A particle with exactly two contacts carries its loads at the pins: reactions take their place,
/// its stress is zero, and it cannot fail at any load, between two platens for one. With fewer
/// than two it cannot be held and is left unstressed.
struct TwoPinnedContacts {
  /// Which two.
  enum class Choice { largest_normal_forces, farthest_apart };

  static constexpr bool needs_flexibility = true;

  Choice choice = Choice::largest_normal_forces;

  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator& op) const {
    const auto [first, second] = pins(loads, op.mesh());
    for (const std::size_t i : {first, second})
      if (i < loads.size()) loads[i].force_body = Vec2{0, 0};
    if (first == second) {
      for (BoundaryLoad& load : loads) load.force_body = Vec2{0, 0};
      return;
    }
    BoundaryLoad& p = loads[first];
    BoundaryLoad& q = loads[second];
    const Vec2 origin = op.mesh().position(p.at);
    const Vec2 span = op.mesh().position(q.at) - origin;
    const double length = span.norm();
    const Vec2 along = span / length;

    // Statics: q takes the moment about p across the line, p takes the rest.
    Vec2 sum{0, 0};
    double moment = 0;
    for (const BoundaryLoad& load : loads) {
      sum += load.force_body;
      moment += cross(op.mesh().position(load.at) - origin, load.force_body);
    }
    q.force_body = -(moment / length) * perpendicular(along);
    p.force_body = -sum - q.force_body;

    // Compatibility: a pair of forces along the line restores the distance between the pins.
    double gap = 0;
    for (const BoundaryLoad& load : loads)
      gap += stretch(op, p.at, q.at, along, load.at, load.force_body);
    const double unit =
        stretch(op, p.at, q.at, along, q.at, along) - stretch(op, p.at, q.at, along, p.at, along);
    const Vec2 pull = -(gap / unit) * along;
    q.force_body += pull;
    p.force_body -= pull;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("choice", self.choice); }

 private:
  [[nodiscard]] static double stretch(const InfluenceOperator& op, const BoundaryPoint& p,
                                      const BoundaryPoint& q, const Vec2& along,
                                      const BoundaryPoint& at, const Vec2& force) {
    return along.dot(op.displacement(q, at, force) - op.displacement(p, at, force));
  }

  // The two pins; equal where there are no two distinct contact points. Ties go to the lower index.
  [[nodiscard]] std::pair<std::size_t, std::size_t> pins(std::span<const BoundaryLoad> loads,
                                                         const Mesh& mesh) const {
    std::pair<std::size_t, std::size_t> best{0, 0};
    double best_value = -1;
    for (std::size_t i = 0; i < loads.size(); ++i)
      for (std::size_t j = i + 1; j < loads.size(); ++j) {
        const double distance = (mesh.position(loads[i].at) - mesh.position(loads[j].at)).norm();
        if (distance <= coincident * mesh.nodes[0].norm()) continue;
        const double value = choice == Choice::farthest_apart
                                 ? distance
                                 : loads[i].normal_force + loads[j].normal_force;
        if (value > best_value) {
          best_value = value;
          best = {i, j};
        }
      }
    return best;
  }

  /// Two contact points closer than this share of the particle's size cannot hold it.
  static constexpr double coincident = 1e-3;
};

static_assert(Support<TwoPinnedContacts>);

}  // namespace riprap
