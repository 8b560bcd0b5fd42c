#pragma once
/// @file
/// The role of the broad phase: which pairs of bodies are worth a closer look.

#include <concepts>
#include <span>

#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Axis-aligned box [m].
struct Box {
  Vec2 low{0, 0};
  Vec2 high{0, 0};

  [[nodiscard]] bool meets(const Box& o) const {
    return low.x() <= o.high.x() && o.low.x() <= high.x() && low.y() <= o.high.y() &&
           o.low.y() <= high.y();
  }
  [[nodiscard]] Box moved(const Vec2& by) const { return {low + by, high + by}; }
};

/// A `BroadPhase` finds the pairs whose boxes meet.
///
/// - `broad.relative_skin` [-]: boxes are grown by this share of the mean diameter, so that the
///   pairs stay valid until some vertex has moved half as far; asked for because only the model
///   knows what a rebuild costs.
/// - `broad.visit_pairs(boxes, visit)`: calls `visit(i, j)` once for every pair i < j of boxes that
///   meet, in an order that depends on the boxes only.
/// - `broad.validate()`: throws InvalidInput for parameters that break a rule.
template <class B>
concept BroadPhase =
    requires(const B& broad, std::span<const Box> boxes, void (*visit)(BodyIndex, BodyIndex)) {
      { broad.relative_skin } -> std::convertible_to<double>;
      broad.visit_pairs(boxes, visit);
      broad.validate();
    };

}  // namespace riprap
