// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the breakage trigger.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/conformance/loaded_sample.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {
namespace internal {

/// A fan of triangles, of which each is smaller than the one before; the last has half of the area
/// of the first.
[[nodiscard]] inline Mesh falling_areas(unsigned elements) {
  Mesh mesh;
  mesh.nodes = {{0, 0}};
  for (std::uint32_t e = 0; e <= elements; ++e) {
    mesh.nodes.push_back({1, e == 0 ? 0 : mesh.nodes[e].y() + 1 - 0.5 * (e - 1) / elements});
    if (e > 0) mesh.triangles.push_back({0, e, e + 1});
  }
  return mesh;
}

/// Of a trigger that counts failed elements; one that takes the particle gets one without loads.
template <Trigger T>
void check_counts(const T& trigger, AxiomCheck& check) {
  const auto decide = [&](const FailureCount& failures) {
    return LoadedSample{}.particle(
        [&](const LoadedParticle& particle) { return fires(trigger, failures, particle); });
  };
  for (const unsigned elements : {50u, 100u, 200u}) {
    bool broken = false;
    const Mesh mesh = falling_areas(elements);
    const SamplingPoints samples(mesh);
    double area = 0;
    for (std::size_t e = 0; e < elements; ++e) area += samples.area(e);
    double failed_area = 0;
    for (std::size_t failed = 0; failed <= elements; ++failed) {
      const FailureCount failures{.elements = elements,
                                  .failed = failed,
                                  .lowest_safety_factor =
                                      failed == 0 ? 2.0 : 1.0 / static_cast<double>(failed),
                                  .failed_area = failed_area,
                                  .area = area};
      if (failed < elements) failed_area += samples.area(failed);
      const bool breaks = decide(failures);
      check.at("failed elements", static_cast<double>(failed));
      check.holds("a particle without failed elements stays whole", failed > 0 || !breaks);
      check.holds("one more failed element never prevents a break", breaks || !broken);
      check.holds("the same count gives the same answer", decide(failures) == breaks);
      if constexpr (requires { trigger.failed_elements_needed(failed); })
        check.holds("a particle with fewer failed elements than are needed stays whole",
                    failed >= trigger.failed_elements_needed(elements) || !breaks);
      if constexpr (requires { trigger.failed_area_needed(); })
        check.holds("a particle with less failed area than is needed stays whole",
                    failures.area_ratio() >= trigger.failed_area_needed() || !breaks);
      broken = breaks;
    }
  }
}

template <LoadTrigger T>
[[nodiscard]] FailureMode mode_of(const T& trigger, const LoadedSample& sample) {
  return sample.particle([&](const LoadedParticle& p) -> FailureMode { return trigger(p); });
}

/// Of a trigger that takes the loads alone: particles of about `size` [m] under rising loads.
template <LoadTrigger T>
void check_loads(const T& trigger, double size, AxiomCheck& check) {
  for (const LoadedSample& unit : loaded_samples(size, 20)) {
    bool broken = false;
    for (double force = 1; force < 1e10; force *= 3) {
      const LoadedSample sample = unit.times(force);
      const FailureMode mode = mode_of(trigger, sample);
      const auto is_mode_of = [&](const LoadedSample& other) {
        return mode_of(trigger, other) == mode;
      };
      check.at("force", force);
      check.holds("a larger load never prevents a break", mode != FailureMode::intact || !broken);
      check.holds("the same loads give the same answer", is_mode_of(sample));
      check.holds("the order of the loads does not matter", is_mode_of(sample.reversed()));
      const Vec2 shift = 100 * size * Vec2{4, -7};
      check.holds("a shifted particle fails likewise", is_mode_of(sample.moved({}, 1, shift)));
      broken = mode != FailureMode::intact;
    }
    LoadedSample unloaded = unit;
    unloaded.loads.clear();
    check.holds("a particle without loads stays whole",
                mode_of(trigger, unloaded) == FailureMode::intact);
  }
}

}  // namespace internal

/// Which axioms a trigger breaks, for particles of 50 to 200 elements and about `mean_area` [m^2].
/// The elements fail from the largest to the smallest; loads rise from 1 N to 20 GN.
template <Trigger T>
[[nodiscard]] Violations trigger_violations(const T& trigger, double mean_area = 2e-4) {
  AxiomCheck check;
  if constexpr (LoadTrigger<T>)
    internal::check_loads(trigger, equivalent_diameter(mean_area), check);
  else
    internal::check_counts(trigger, check);
  if constexpr (requires { trigger.strength_factor(ParticleId{}, mean_area); })
    for (ParticleId id = 0; id < 1000; ++id)
      for (const double area : {0.1 * mean_area, mean_area, 10 * mean_area}) {
        const double factor = trigger.strength_factor(id, area);
        check.at("particle", id);
        check.at_least("a strength factor is above zero", factor,
                       std::numeric_limits<double>::min());
        check.at_most("a strength factor is finite", factor, std::numeric_limits<double>::max());
        check.equal("a particle keeps its strength factor", trigger.strength_factor(id, area),
                    factor, 0);
      }
  return std::move(check).violations();
}

/// For triggers without preferred axes, of rock that has none: a particle that is turned with its
/// loads fails likewise.
template <LoadTrigger T>
[[nodiscard]] Violations trigger_rotation_violations(const T& trigger, double mean_area = 2e-4) {
  AxiomCheck check;
  const Rotation turn = Rotation::from_angle(0.7);
  for (const internal::LoadedSample& unit :
       internal::loaded_samples(equivalent_diameter(mean_area), 20))
    for (double force = 1; force < 1e10; force *= 3) {
      const internal::LoadedSample sample = unit.times(force);
      check.at("force", force);
      check.holds("a turned particle fails likewise",
                  internal::mode_of(trigger, sample.moved(turn, 1, {0, 0})) ==
                      internal::mode_of(trigger, sample));
    }
  return std::move(check).violations();
}

}  // namespace riprap
