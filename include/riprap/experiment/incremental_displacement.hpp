// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How far particles have come since a moment, across their breaks.

#include <cstddef>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>

namespace riprap {

/// From where to where the centroid of a particle has come [m].
struct Move {
  Vec2 from{0, 0};
  Vec2 to{0, 0};
  bool is_free = true;

  static void for_each_field(auto& self, auto&& visit) {
    visit("from", self.from);
    visit("to", self.to);
    visit("is_free", self.is_free);
  }
};

/// An observer of a test that follows all particles there are at `begin`. Of one that breaks
/// it follows all pieces: together they have one centroid, for which dust stays where it broke off.
/// Platens do not count.
class IncrementalDisplacement {
 public:
  /// From now on, from here.
  void begin(const Particles& particles) {
    starts_.clear();
    start_of_.clear();
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      if (particles.body(i).is_wall()) continue;
      start_of(particles.ancestry(i).id) = starts_.size();
      starts_.push_back({particles.body(i).position, {0, 0}, particles.body(i).is_free()});
    }
    dust_areas_.assign(starts_.size(), 0);
  }

  template <class Sim>
  void record_break(const BiaxialView<Sim>& /*view*/, const BreakEvent& event) {
    const std::size_t start = start_of(event.particle.id);
    if (start == unknown) return;
    for (std::size_t k = 0; k < 2; ++k) {
      if (event.pieces[k] != no_particle) {
        start_of(event.pieces[k]) = start;
        continue;
      }
      starts_[start].to += event.areas[k] * event.centroids[k];
      dust_areas_[start] += event.areas[k];
    }
  }

  /// Of all particles there were at `begin`, in the order of the bodies then.
  [[nodiscard]] std::vector<Move> moves(const Particles& particles) const {
    std::vector<Move> out = starts_;
    std::vector<double> areas = dust_areas_;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      const ParticleId id = particles.ancestry(i).id;
      if (id >= start_of_.size() || start_of_[id] == unknown) continue;
      const double area = particles.shape(i).area;
      out[start_of_[id]].to += area * particles.body(i).position;
      areas[start_of_[id]] += area;
    }
    for (std::size_t k = 0; k < out.size(); ++k) out[k].to /= areas[k];
    return out;
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("starts", self.starts_);
    visit("dust_areas", self.dust_areas_);
    visit("start_of", self.start_of_);
  }

 private:
  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t& start_of(ParticleId id) {
    if (start_of_.size() <= id) start_of_.resize(id + 1, unknown);
    return start_of_[id];
  }

  std::vector<Move> starts_;  // to: of dust, times its area
  std::vector<double> dust_areas_;
  std::vector<std::size_t> start_of_;  // by particle id: its place in starts_
};

}  // namespace riprap
