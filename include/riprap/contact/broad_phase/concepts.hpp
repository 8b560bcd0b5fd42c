// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the broad phase: candidate pairs for contact detection.

#include <concepts>
#include <span>

#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Axis-aligned box [m].
struct Box {
  Vec2 low{0, 0};
  Vec2 high{0, 0};

  [[nodiscard]] bool overlaps(const Box& o) const {
    return low.x() <= o.high.x() && o.low.x() <= high.x() && low.y() <= o.high.y() &&
           o.low.y() <= high.y();
  }
  [[nodiscard]] Box moved(const Vec2& by) const { return {low + by, high + by}; }
};

namespace requirements {

/// Stands for whatever is called for the pairs.
struct PairVisitor {
  void operator()(BodyIndex, BodyIndex) const {}
};

/// `broad.relative_skin` [-]: boxes are grown by this share of the mean diameter, so that the pairs
/// stay valid until some vertex has moved half as far; required because only the model knows what
/// a rebuild costs.
template <class B>
concept BroadPhaseSkin = requires(const B& broad) {
  { broad.relative_skin } -> std::convertible_to<double>;
};

/// `broad.visit_pairs(boxes, visit)` calls `visit(i, j)` once for every pair i < j of boxes that
/// meet, in an order that depends on the boxes only. Const: it must not depend on earlier calls.
template <class B>
concept BroadPhaseVisit = requires(const B& broad, const std::span<const Box> boxes) {
  broad.visit_pairs(boxes, PairVisitor{});
};

/// Optional: a type `B::Workspace` with `broad.visit_pairs(boxes, workspace, visit)`, which is then
/// called instead: scratch memory without effect on the result. Without that call
/// the type would be ignored silently.
template <class B>
concept BroadPhaseWorkspace = !requires {
  typename B::Workspace;
} || requires(const B& broad, const std::span<const Box> boxes, typename B::Workspace& workspace) {
  broad.visit_pairs(boxes, workspace, PairVisitor{});
};

/// The memory that a broad phase keeps; none, if it does not say.
template <class B>
struct WorkspaceOf {
  struct type {};
};
template <class B>
  requires requires { typename B::Workspace; }
struct WorkspaceOf<B> {
  using type = typename B::Workspace;
};

}  // namespace requirements

/// A `BroadPhase` finds the pairs whose boxes meet.
template <class B>
concept BroadPhase = Policy<B> && requirements::BroadPhaseSkin<B> &&
                     requirements::BroadPhaseVisit<B> && requirements::BroadPhaseWorkspace<B>;

template <class B>
consteval bool check_broad_phase() {
  check_policy<B>();
  static_assert(requirements::BroadPhaseSkin<B>,
                "riprap: a BroadPhase must have double relative_skin");
  static_assert(requirements::BroadPhaseVisit<B>,
                "riprap: a BroadPhase must have template <class Visit> void "
                "visit_pairs(std::span<const Box>, Visit&&) const");
  static_assert(requirements::BroadPhaseWorkspace<B>,
                "riprap: a BroadPhase with a type Workspace must have template <class Visit> void "
                "visit_pairs(std::span<const Box>, Workspace&, Visit&&) const");
  return BroadPhase<B>;
}

}  // namespace riprap
