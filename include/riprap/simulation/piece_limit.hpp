// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stops a run in which an intact particle breaks into pieces without end.

#include <cstddef>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/particle/ancestry.hpp>

namespace riprap {

/// Counts the pieces of every intact particle, but for dust.
class PieceLimit {
 public:
  /// The particle is about to become two pieces. Throws SimulationError, naming the particle, if
  /// its root has `splitter.maximum_pieces` already; a splitter without that member has no limit.
  template <class S>
  void add_break(const S& splitter, const Ancestry& particle) {
    if constexpr (requires { splitter.maximum_pieces; }) {
      if (breaks_.size() <= particle.root) breaks_.resize(particle.root + 1, 0);
      if (++breaks_[particle.root] >= splitter.maximum_pieces)
        throw_too_many(particle, splitter.maximum_pieces);
    }
  }

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
