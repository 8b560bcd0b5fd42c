// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Where particles have been during shear.

#include <optional>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>

namespace riprap {

/// An observer of a test that keeps the centroid of every particle at each record and break.
/// Platens are no particles: they have no path. Memory grows with records times particles, not with
/// steps.
class DisplacementPaths {
 public:
  struct Path {
    Ancestry particle;
    std::vector<Vec2> points;    ///< centroids in order of time [m]
    std::optional<Vec2> branch;  ///< of a piece: where the path of its parent ended

    static void for_each_field(auto& self, auto&& visit) {
      visit("particle", self.particle);
      visit("points", self.points);
      visit("branch", self.branch);
    }
  };

  /// By particle id, broken particles included; without points for platens and for those that broke
  /// before the first record.
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }

  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    const Particles& particles = view.sim.particles();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      if (!particles.body(i).is_wall())
        path(particles.ancestry(i)).points.push_back(particles.body(i).position);
  }

  template <class Sim>
  void record_break(const BiaxialView<Sim>& view, const BreakEvent& event) {
    if (paths_.empty()) return;  // a break before shear
    const Particles& particles = view.sim.particles();
    path(event.particle).points.push_back(event.place());
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      if (particles.ancestry(i).parent != event.particle.id) continue;
      path(particles.ancestry(i)).branch = event.place();
      path(particles.ancestry(i)).points.push_back(particles.body(i).position);
    }
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("paths", self.paths_); }

 private:
  [[nodiscard]] Path& path(const Ancestry& particle) {
    if (paths_.size() <= particle.id) paths_.resize(particle.id + 1);
    paths_[particle.id].particle = particle;
    return paths_[particle.id];
  }

  std::vector<Path> paths_;
};

}  // namespace riprap
