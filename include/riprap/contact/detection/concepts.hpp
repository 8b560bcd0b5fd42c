// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the detection: in which way the narrow phase is evaluated for the pairs of a task.

#include <span>

#include <riprap/contact/narrow_phase/no_overlap.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_map.hpp>
#include <riprap/contact/pair/task_partition.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// What a detection works on.
template <class ContactType, class Narrow, class Domain, class ListState>
struct DetectionInput {
  std::span<ContactType> pairs;
  const Particles& particles;
  const Narrow& narrow;
  const Domain& domain;
  const ListState& list;  ///< of the neighbour list: bounds the approach of bodies
};

namespace requirements {

/// `D::State<Narrow>`: what a simulation keeps from step to step. `state.find(input, task)`
/// evaluates the pairs of a task, `task.for_each_pair`, and puts the indices of those that touch,
/// in order, in `task.touching` and, across a boundary, in `task.crossing`. Tasks may run in
/// parallel. `state.carry(map)` follows a new pair list; `state.forget(k)` and `state.forget_all()`
/// discard what is kept of pairs whose bodies have changed.
template <class D>
concept DetectionState =
    requires { typename D::template State<NoOverlap>; } &&
    requires(typename D::template State<NoOverlap>& state, const PairMap& map, std::size_t k,
             const DetectionInput<Contact<NoOverlap::Cache, NoOverlap::Cache>, NoOverlap,
                                  UnboundedDomain, RebuildEveryStep::State<UnboundedDomain>>& input,
             ContactTask& task) {
      state.carry(map);
      state.forget(k);
      state.forget_all();
      state.find(input, task);
    };

}  // namespace requirements

/// A `Detection` evaluates the narrow phase where it may find a contact. It changes no result.
template <class D>
concept Detection = Policy<D> && requirements::DetectionState<D>;

template <class D>
consteval bool check_detection() {
  check_policy<D>();
  static_assert(requirements::DetectionState<D>,
                "riprap: a Detection must have template <class Narrow> class State with carry(), "
                "forget(), forget_all() and find(input, task)");
  return Detection<D>;
}

}  // namespace riprap
