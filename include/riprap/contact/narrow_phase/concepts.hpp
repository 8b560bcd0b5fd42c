// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the narrow phase: do two convex rings touch, and how.

#include <concepts>
#include <cstddef>
#include <optional>

#include <riprap/contact/contact_geometry.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

namespace clauses {

/// `N::Memory`: what a pair remembers from step to step (a separating edge, say); it may speed the
/// answer up and must never change it. Every new pair starts with `Memory{}`, and pairs are moved
/// when they are sorted.
template <class N>
concept NarrowPhaseMemory =
    requires { typename N::Memory; } && std::semiregular<typename N::Memory>;

/// `narrow(a, b, memory)` -> the contact, or nothing where the rings keep apart. Swapping the rings
/// flips the normal and changes nothing else; moving both rigidly moves the answer. Const: what is
/// remembered belongs to the pair.
template <class N>
concept NarrowPhaseCall =
    requires(const N& narrow, const Ring a, const Ring b, typename N::Memory& memory) {
      { narrow(a, b, memory) } -> std::convertible_to<std::optional<ContactGeometry>>;
    };

/// Optional: `narrow.clearance(memory)` [m]: how far apart the rings were, at least, when the last
/// call found no contact. Until bodies have moved so far a pair is not asked again. Not const, it
/// would be passed over in silence.
template <class N>
concept NarrowPhaseClearance = !requires(N& narrow, typename N::Memory& memory) {
  narrow.clearance(memory);
} || requires(const N& narrow, const typename N::Memory& memory) {
  { narrow.clearance(memory) } -> std::convertible_to<double>;
};

/// A group of pairs that `narrow` finds the contacts of at once.
template <class N>
concept NarrowPhaseGroupCall = requires(const N& narrow, typename N::Group& group, const Ring a,
                                        const Ring b, const typename N::Memory& memory,
                                        ContactGeometry& contact) {
  requires N::Group::capacity >= 1 && N::Group::capacity <= 32;
  { group.size() } -> std::convertible_to<std::size_t>;
  { group.add(a, b, memory, contact) } -> std::convertible_to<bool>;
  { narrow.find(group) } -> std::convertible_to<unsigned>;
  group.clear();
} && std::default_initializable<typename N::Group>;

/// Optional: a type `N::Group` of up to `Group::capacity` pairs, for a narrow phase that is faster
/// with several at once. `group.add(a, b, memory, contact)` takes a pair in, or says no: then it is
/// asked alone. `narrow.find(group)` puts the contacts of a full group where `contact` was and
/// returns, bit by bit, who has one; the others are asked alone. `Group::Of` is N itself: who
/// inherits from N and answers differently is not given N's group.
template <class N>
concept NarrowPhaseGroup = !requires { typename N::Group; } || (requires {
  typename N::Group::Of;
} && (!std::same_as<typename N::Group::Of, N> || NarrowPhaseGroupCall<N>));

}  // namespace clauses

/// Whether a narrow phase finds contacts in groups.
template <class N>
concept FindsGroups = requires { requires std::same_as<typename N::Group::Of, N>; };

/// A `NarrowPhase` turns two placed rings into contact geometry.
template <class N>
concept NarrowPhase = Policy<N> && clauses::NarrowPhaseMemory<N> && clauses::NarrowPhaseCall<N> &&
                      clauses::NarrowPhaseClearance<N> && clauses::NarrowPhaseGroup<N>;

template <class N>
consteval bool check_narrow_phase() {
  check_policy<N>();
  static_assert(
      clauses::NarrowPhaseMemory<N>,
      "riprap: a NarrowPhase must have a type Memory that can be default-constructed and copied");
  if constexpr (clauses::NarrowPhaseMemory<N>) {  // the others cannot be asked without it
    static_assert(clauses::NarrowPhaseCall<N>,
                  "riprap: a NarrowPhase must have std::optional<ContactGeometry> operator()(Ring, "
                  "Ring, Memory&) const");
    static_assert(
        clauses::NarrowPhaseClearance<N>,
        "riprap: clearance of a NarrowPhase must be double clearance(const Memory&) const");
    static_assert(
        clauses::NarrowPhaseGroup<N>,
        "riprap: a Group of a NarrowPhase must have a type Of, capacity, size(), clear(), "
        "bool add(Ring, Ring, const Memory&, ContactGeometry&), and the NarrowPhase "
        "unsigned find(const Group&) const");
  }
  return NarrowPhase<N>;
}

}  // namespace riprap
