// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the narrow phase: do two convex rings touch, and how.

#include <concepts>
#include <cstddef>
#include <optional>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

namespace requirements {

/// `N::Cache`: data of a pair kept from step to step (a separating edge, say) that may speed the
/// evaluation up and must never change its result. A new pair starts with `Cache{}`; pairs are
/// moved when they are sorted.
template <class N>
concept NarrowPhaseCache = requires { typename N::Cache; } && std::semiregular<typename N::Cache>;

/// `narrow(a, b, cache)` -> the contact, or nothing where the rings are separated. Swapping the
/// rings flips the normal and changes nothing else; moving both rigidly moves the contact. Const:
/// what is cached belongs to the pair.
template <class N>
concept NarrowPhaseCall =
    requires(const N& narrow, const Ring a, const Ring b, typename N::Cache& cache) {
      { narrow(a, b, cache) } -> std::convertible_to<std::optional<ContactGeometry>>;
    };

/// Optional: `narrow.clearance(cache)` [m]: lower bound on the distance of the rings when the last
/// call found no contact. The pair is skipped until each of the bodies can have moved by half of
/// it. A non-const function would be ignored silently.
template <class N>
concept NarrowPhaseClearance = !requires(N& narrow, typename N::Cache& cache) {
  narrow.clearance(cache);
} || requires(const N& narrow, const typename N::Cache& cache) {
  { narrow.clearance(cache) } -> std::convertible_to<double>;
};

/// A batch of pairs that `narrow` evaluates at once.
template <class N>
concept NarrowPhaseBatchCall =
    requires(const N& narrow, typename N::Batch& batch, const Ring a, const Ring b,
             const typename N::Cache& cache, ContactGeometry& contact) {
      requires N::Batch::capacity >= 1 && N::Batch::capacity <= 32;
      { batch.size() } -> std::convertible_to<std::size_t>;
      { batch.add(a, b, cache, contact) } -> std::convertible_to<bool>;
      { narrow.find(batch) } -> std::convertible_to<unsigned>;
      batch.clear();
    } &&
    std::default_initializable<typename N::Batch> &&
    (
        !requires { N::Batch::kinds; } ||
        requires(const typename N::Cache& cache) {
          { N::Batch::kinds } -> std::convertible_to<std::size_t>;
          { N::Batch::kind(cache) } -> std::convertible_to<std::size_t>;
        });

/// Optional: a type `N::Batch` of up to `Batch::capacity` pairs, for a narrow phase that evaluates
/// several pairs at once (SIMD). `batch.add(a, b, cache, contact)` adds a pair or returns false:
/// then the pair is evaluated singly. `narrow.find(batch)` writes the contacts of a full batch to
/// the `contact`s it was given and returns a bit mask of the pairs that have one; the others are
/// evaluated singly. `Batch::Of` is N itself: a class that inherits from N does not get N's batch.
template <class N>
concept NarrowPhaseBatch = !requires { typename N::Batch; } || (requires {
  typename N::Batch::Of;
} && (!std::same_as<typename N::Batch::Of, N> || NarrowPhaseBatchCall<N>));

}  // namespace requirements

/// Whether a narrow phase evaluates pairs in batches.
template <class N>
concept BatchedNarrowPhase = requires { requires std::same_as<typename N::Batch::Of, N>; };

/// A `NarrowPhase` turns two placed rings into contact geometry.
template <class N>
concept NarrowPhase =
    Policy<N> && requirements::NarrowPhaseCache<N> && requirements::NarrowPhaseCall<N> &&
    requirements::NarrowPhaseClearance<N> && requirements::NarrowPhaseBatch<N>;

template <class N>
consteval bool check_narrow_phase() {
  check_policy<N>();
  static_assert(
      requirements::NarrowPhaseCache<N>,
      "riprap: a NarrowPhase must have a type Cache that can be default-constructed and copied");
  if constexpr (requirements::NarrowPhaseCache<N>) {  // the others cannot be checked without it
    static_assert(requirements::NarrowPhaseCall<N>,
                  "riprap: a NarrowPhase must have std::optional<ContactGeometry> operator()(Ring, "
                  "Ring, Cache&) const");
    static_assert(
        requirements::NarrowPhaseClearance<N>,
        "riprap: clearance of a NarrowPhase must be double clearance(const Cache&) const");
    static_assert(
        requirements::NarrowPhaseBatch<N>,
        "riprap: a Batch of a NarrowPhase must have a type Of, capacity, size(), clear(), "
        "bool add(Ring, Ring, const Cache&, ContactGeometry&), with kinds also kind(const Cache&), "
        "and the NarrowPhase unsigned find(const Batch&) const");
  }
  return NarrowPhase<N>;
}

}  // namespace riprap
