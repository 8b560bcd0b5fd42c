// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Breaks of particles in a step.

#include <algorithm>
#include <cstddef>

#include <riprap/breakage/breakage_pass.hpp>
#include <riprap/core/step_phase.hpp>
#include <riprap/simulation/break_event.hpp>
#include <riprap/simulation/observer.hpp>
#include <riprap/simulation/replace_by_pieces.hpp>

namespace riprap {

/// Base of a Simulation.
template <class Sim>
class Breaking {
 public:
  /// In the hook before_splits: which particles break, still whole, and how; in order of ids.
  [[nodiscard]] const BreakagePass::Cracks& cracks() const
    requires(Sim::breakable)
  {
    return sim().breakage_.pass.cracks();
  }

 private:
  friend Sim;
  Breaking() = default;
  [[nodiscard]] Sim& sim() { return static_cast<Sim&>(*this); }
  [[nodiscard]] const Sim& sim() const { return static_cast<const Sim&>(*this); }

  // All cracks are found before the first split, which changes the contacts that load the others.
  template <class OnPhaseEnd, class... Observers>
  void break_particles(OnPhaseEnd&& on_phase_end, Observers&... observers) {
    const BreakagePass::Cracks& cracks =
        sim().breakage_.find_cracks(sim().model_, sim().rocks_, sim().mean_area_, sim().particles_,
                                    sim().interactions(), on_phase_end);
    if (cracks.empty()) return;
    const std::size_t first = sim().breaks_.size();
    (hooks::before_splits(observers, sim()), ...);
    for (const auto& [i, crack] : cracks) split(i, crack);
    sim().bonds_.exclude_divided(sim().contacts_);
    sim().contacts_.update_pieces(sim().particles_);
    (hooks::after_splits(observers, sim()), ...);
    for (std::size_t k = first; k < sim().breaks_.size(); ++k)
      (hooks::on_break(observers, sim(), sim().breaks_[k]), ...);
    sim().tell_bond_breaks(observers...);
    if constexpr (Sim::bonded) {
      // Bonds of pieces, which are lighter, may be stiffer than the step was chosen for.
      sim().time_step_ = std::min(sim().time_step_, sim().stable_time_step());
    }
    on_phase_end(StepPhase::splitting);
  }

  void split(BodyIndex i, const Crack& crack) {
    Particles& particles = sim().particles_;
    BreakEvent event = event_of(crack, particles.ancestry(i), sim().steps_, sim().time_);
    const Body whole = particles.body(i);
    const BodyIndex second =
        replace_by_pieces(sim().model_, sim().smallest_mass_, crack, i, particles, event);
    const auto on_right = [&](const Vec2& x) { return crack.line.left_distance(x) < 0; };
    const auto on_dust = [&](const Vec2& x) { return crack.is_dust[on_right(x) ? 1 : 0]; };
    if (crack.leaves_dust())
      sim().contacts_.cut_off(particles, whole, i, on_dust);
    else
      sim().contacts_.divide(particles, whole, i, second, on_right);
    if constexpr (Sim::bonded)
      sim().bonds_.divide({whole, i, crack.line, pieces_of(crack, i, second)}, particles,
                          sim().contacts_.domain(), {sim().steps_, sim().time_});
    sim().breakage_.forget(i);
    sim().loads_.forget(i);
    sim().breaks_.push_back(event);
  }
};

}  // namespace riprap
