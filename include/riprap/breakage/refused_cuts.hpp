// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Refused cuts: not tried again until the contact partners of the particle change.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/splitmix64.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// Hash of the contact partners of a particle: changes when they do.
[[nodiscard]] inline std::uint64_t partners_hash(const Particles& particles,
                                                 std::span<const ContactLoad> loads) {
  std::uint64_t sum = 0;
  for (const ContactLoad& load : loads) sum += splitmix64(particles.ancestry(load.partner).id);
  return sum;
}

/// Of all particles, with the partners under which their cut was refused.
class RefusedCuts {
 public:
  void resize(std::size_t particles) { refusals_.resize(particles); }
  /// Particle i was removed; those behind it have moved up.
  void remove(BodyIndex i) {
    if (i < refusals_.size()) refusals_.erase(refusals_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void add(const Particles& particles, BodyIndex i, std::span<const ContactLoad> loads) {
    refusals_[i] = {true, partners_hash(particles, loads)};
  }
  /// Whether the cut of particle i was refused under the partners it has. A refusal under others is
  /// discarded.
  [[nodiscard]] bool contains(const Particles& particles, BodyIndex i,
                              std::span<const ContactLoad> loads) {
    Refusal& refusal = refusals_[i];
    if (refusal.active && refusal.partners != partners_hash(particles, loads))
      refusal.active = false;
    return refusal.active;
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("refusals", self.refusals_); }

 private:
  struct Refusal {
    bool active = false;
    std::uint64_t partners = 0;

    static void for_each_field(auto& self, auto&& visit) {
      visit("active", self.active);
      visit("partners", self.partners);
    }
  };
  std::vector<Refusal> refusals_;
};

}  // namespace riprap
