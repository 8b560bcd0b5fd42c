// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stops a run in which an intact particle breaks into pieces without end.

#include <cstddef>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/particle/ancestry.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Counts the pieces of every intact particle, but for dust. A cluster of bonded cells may have so
/// many for each of its cells.
class PieceLimit {
 public:
  /// The particle is about to become two pieces. Throws SimulationError, naming the particle, if
  /// its root has `splitter.maximum_pieces` already; a splitter without that member has no limit.
  template <class S>
  void add_break(const S& splitter, const Ancestry& particle) {
    if constexpr (requires { splitter.maximum_pieces; }) {
      if (breaks_.size() <= particle.root) breaks_.resize(particle.root + 1, 0);
      const std::size_t of_cells = particle.root < cells.size() ? cells[particle.root] : 1;
      const std::size_t limit = of_cells * splitter.maximum_pieces;
      if (++breaks_[particle.root] + (of_cells - 1) >= limit) throw_too_many(particle, limit);
    }
  }

  /// Counts the particles of each root, in a sample of intact ones.
  void count_cells(const Particles& particles) {
    cells.clear();
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      const ParticleId root = particles.ancestry(i).root;
      if (cells.size() <= root) cells.resize(root + std::size_t{1}, 0);
      ++cells[root];
    }
  }
  std::vector<std::size_t> cells;  ///< by id of the root; one each where it is empty

  /// But for the cells.
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) { visit("breaks", self.breaks_); }

 private:
  [[noreturn, gnu::cold]] static void throw_too_many(const Ancestry& particle, std::size_t limit) {
    throw SimulationError(
        particle_text(particle.id) + " of generation " + std::to_string(particle.generation) +
        " is to break, and its root, " + particle_text(particle.root) + ", has " +
        std::to_string(limit) +
        " pieces already, the splitter's maximum_pieces. Pieces break again and again under the "
        "same load: raise the splitter's minimum_area or the trigger's critical ratio, or allow "
        "more pieces");
  }

  std::vector<std::size_t> breaks_;  // by id of the root
};

}  // namespace riprap
