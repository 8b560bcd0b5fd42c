// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the trigger: when does a particle break?

#include <algorithm>
#include <concepts>
#include <cstddef>

#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/breakage/failure/loaded_particle.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

namespace requirements {

/// `trigger(failures)` -> bool. Const: a decision depends on one evaluation, not on those before
/// it.
template <class T>
concept TriggerByCount = requires(const T& trigger, const FailureCount& failures) {
  { trigger(failures) } -> std::convertible_to<bool>;
};

/// `trigger(failures, particle)` in its place: the contact loads on the particle, its mean stress,
/// polygon and rock as well. A trigger that has both calls gets the particle.
template <class T>
concept TriggerByCountAndLoads =
    requires(const T& trigger, const FailureCount& failures, const LoadedParticle& particle) {
      { trigger(failures, particle) } -> std::convertible_to<bool>;
    };

/// `trigger(particle)` -> FailureMode by which the particle breaks, or `intact`: for this call
/// alone no finite elements are evaluated. A trigger that also has one of the others gets that.
template <class T>
concept TriggerByLoads = !TriggerByCountAndLoads<T> && !TriggerByCount<T> &&
                         requires(const T& trigger, const LoadedParticle& particle) {
                           { trigger(particle) } -> std::convertible_to<FailureMode>;
                         };

template <class T>
concept TriggerCall = TriggerByCountAndLoads<T> || TriggerByCount<T> || TriggerByLoads<T>;

/// Optional: `trigger.strength_factor(id, area)` [-], above 0: strength of the particle over that
/// of the criterion. Const, since it must not change from call to call; a non-const
/// function would be ignored silently.
template <class T>
concept TriggerStrength = !requires(T& trigger, ParticleId id, double area) {
  trigger.strength_factor(id, area);
} || requires(const T& trigger, const ParticleId id, const double area) {
  { trigger.strength_factor(id, area) } -> std::convertible_to<double>;
};

/// Optional: `trigger.failed_elements_needed(elements)`: with fewer failed elements, of so many, it
/// never fires; more than there are if it never does. Particles that cannot have come so far since
/// they were last evaluated are skipped (screening), and break in the same step as without it.
/// Const, since it must not change from call to call.
template <class T>
concept TriggerNeeded = !requires(T& trigger, std::size_t elements) {
  trigger.failed_elements_needed(elements);
} || requires(const T& trigger, const std::size_t elements) {
  { trigger.failed_elements_needed(elements) } -> std::convertible_to<std::size_t>;
};

/// Optional, in place of it: `trigger.failed_area_needed()` [-], for a trigger that decides from
/// the failed area: with a smaller share of it it never fires.
template <class T>
concept TriggerAreaNeeded =
    !requires(T& trigger) { trigger.failed_area_needed(); } || requires(const T& trigger) {
      { trigger.failed_area_needed() } -> std::convertible_to<double>;
    };

/// Whether `trigger` says how many failed elements, or how much of the area, it needs.
template <class T>
concept TriggerStatesNeed = requires(T& trigger, std::size_t elements) {
  trigger.failed_elements_needed(elements);
} || requires(T& trigger) { trigger.failed_area_needed(); };

/// A trigger that knows of no elements cannot need failed ones.
template <class T>
concept TriggerNeedsWhatItGets = !(TriggerByLoads<T> && TriggerStatesNeed<T>);

}  // namespace requirements

/// A `Trigger` decides from the failed elements of one evaluation, from the contact loads on the
/// particle, or from both.
template <class T>
concept Trigger = Policy<T> && requirements::TriggerCall<T> && requirements::TriggerStrength<T> &&
                  requirements::TriggerNeeded<T> && requirements::TriggerAreaNeeded<T> &&
                  requirements::TriggerNeedsWhatItGets<T>;

/// A trigger that takes the loaded particle alone: it needs no finite elements.
template <class T>
concept LoadTrigger = Trigger<T> && requirements::TriggerByLoads<T>;

/// A trigger by which each particle has a strength of its own.
template <class T>
concept HasStrengthFactor = Trigger<T> && requires(const T& trigger, ParticleId id, double area) {
  trigger.strength_factor(id, area);
};

/// A trigger that says how many failed elements, or how much of the area, it needs: its particles
/// can be screened.
template <class T>
concept ScreenableTrigger = Trigger<T> && requirements::TriggerStatesNeed<T>;

template <class T>
consteval bool check_trigger() {
  check_policy<T>();
  static_assert(requirements::TriggerCall<T>,
                "riprap: a Trigger must have bool operator()(const FailureCount&[, const "
                "LoadedParticle&]) const, or FailureMode operator()(const LoadedParticle&) const");
  static_assert(requirements::TriggerStrength<T>,
                "riprap: strength_factor of a Trigger must be double "
                "strength_factor(ParticleId, double area) const");
  static_assert(requirements::TriggerNeeded<T>,
                "riprap: failed_elements_needed of a Trigger must be std::size_t "
                "failed_elements_needed(std::size_t elements) const");
  static_assert(
      requirements::TriggerAreaNeeded<T>,
      "riprap: failed_area_needed of a Trigger must be double failed_area_needed() const");
  static_assert(requirements::TriggerNeedsWhatItGets<T>,
                "riprap: a Trigger that takes the LoadedParticle alone must not have "
                "failed_elements_needed or failed_area_needed");
  return Trigger<T>;
}

/// Whether a trigger fires that counts failed elements.
template <Trigger T>
  requires(!LoadTrigger<T>)
[[nodiscard]] bool fires(const T& trigger, const FailureCount& failures,
                         const LoadedParticle& particle) {
  if constexpr (requirements::TriggerByCountAndLoads<T>)
    return trigger(failures, particle);
  else
    return trigger(failures);
}

/// The fewest failed elements, of so many, whose share reaches `critical`; one more than there are
/// if none does. By the comparison that triggers make, so that round-off agrees.
[[nodiscard]] inline std::size_t failed_elements_for_ratio(std::size_t elements, double critical) {
  const auto reached = [&](std::size_t failed) {
    return FailureCount{.elements = elements, .failed = failed}.ratio() >= critical;
  };
  if (!reached(elements)) return elements + 1;
  auto failed = static_cast<std::size_t>(
      std::clamp(critical * static_cast<double>(elements), 0.0, static_cast<double>(elements)));
  while (failed > 0 && reached(failed - 1)) --failed;
  while (!reached(failed)) ++failed;
  return failed;
}

}  // namespace riprap
