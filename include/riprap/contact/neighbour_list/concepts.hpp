// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the neighbour list: how long the pairs of a search stay valid.

#include <concepts>
#include <type_traits>

#include <riprap/contact/broad_phase/pair_search.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

namespace requirements {

/// `N::uses_skin`: whether pairs are searched with the skin of the broad phase.
template <class N>
concept NeighbourListSkin = requires { typename std::bool_constant<bool{N::uses_skin}>; };

/// `N::State<Domain>`: what a simulation keeps of its list. `state.record_motion(particles, task,
/// first, last)` is called for the bodies of a task after they have moved;
/// `state.is_stale(particles, domain, execution)` at the new poses, and true once pairs may be
/// missing; then `state.rebuilt(particles, domain, extent)` with the extent of the new search.
/// `state.invalidate()` makes the next `is_stale` true.
///
/// Optional: `state.divide(particles, whole, parent, second)`: the body `whole` at the index
/// `parent` has become the pieces at `parent` and `second`; one piece, if the two are equal. The
/// list goes on with the pairs of the parent as those of each piece. Without it the pairs are
/// searched anew after a break.
template <class N, class Domain>
concept NeighbourListRebuild =
    requires { typename N::template State<Domain>; } &&
    requires(typename N::template State<Domain>& state, const Particles& particles,
             const Domain& domain, const PairExtent& extent, std::size_t k) {
      state.record_motion(particles, k, k, k);
      { state.is_stale(particles, domain, Serial{}) } -> std::convertible_to<bool>;
      state.rebuilt(particles, domain, extent);
      state.invalidate();
    };

/// `state.displacement()` [m]: grows by at least half of the distance by which any two bodies of a
/// pair can have approached each other; `state.contact_threshold(gap)`: its value below which two
/// bodies that are `gap` apart now cannot touch. Pairs are skipped below.
template <class N, class Domain>
concept NeighbourListBound = requires(const typename N::template State<Domain>& state, double gap) {
  { state.displacement() } -> std::convertible_to<double>;
  { state.contact_threshold(gap) } -> std::convertible_to<double>;
};

/// The optional function; see NeighbourListRebuild.
template <class State>
concept FollowsPieces = requires(State& state, const Particles& particles, const Body& whole,
                                 BodyIndex i) { state.divide(particles, whole, i, i); };

}  // namespace requirements

/// A `NeighbourList` decides when neighbours are searched anew. It changes no result.
template <class N>
concept NeighbourList = Policy<N> && requirements::NeighbourListSkin<N> &&
                        requirements::NeighbourListRebuild<N, UnboundedDomain> &&
                        requirements::NeighbourListBound<N, UnboundedDomain>;

template <class N>
consteval bool check_neighbour_list() {
  check_policy<N>();
  static_assert(requirements::NeighbourListSkin<N>,
                "riprap: a NeighbourList must have static constexpr bool uses_skin");
  static_assert(requirements::NeighbourListRebuild<N, UnboundedDomain>,
                "riprap: a NeighbourList must have template <class Domain> class State with "
                "record_motion(), is_stale(), rebuilt() and invalidate()");
  if constexpr (requirements::NeighbourListRebuild<N, UnboundedDomain>)
    static_assert(requirements::NeighbourListBound<N, UnboundedDomain>,
                  "riprap: the State of a NeighbourList must have double displacement() const and "
                  "double contact_threshold(double gap) const");
  return NeighbourList<N>;
}

}  // namespace riprap
