// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Verlet list (neighbour list): searches again only once pairs may be missing.

#include <algorithm>
#include <limits>

#include <riprap/acceleration/neighbour_list/displacement_bound.hpp>
#include <riprap/contact/neighbour_list/concepts.hpp>

namespace riprap {

/// Verlet list with a skin (Verlet 1967): its pairs stay complete until a vertex has moved by half
/// of the skin relative to its neighbours. The default.
struct VerletList {
  static constexpr bool uses_skin = true;

  template <class Domain>
  class State {
   public:
    /// See `DisplacementBound::record_motion`.
    void record_motion(const Particles& particles, std::size_t task, std::size_t first,
                       std::size_t last) {
      bound_.record_motion(particles, task, first, last);
    }

    /// Updates the displacement bound to the present poses. True once pairs may be missing.
    template <Execution E = Serial>
    [[nodiscard]] bool is_stale(const Particles& particles, const Domain& domain,
                                const E& execution = {}) {
      if (bound_.bodies() != particles.size()) {
        bound_.restart(particles, domain);
        valid_until_ = -infinity;
      } else {
        bound_.update(particles, domain, extent_.skin / 16, extent_.centres, extent_.farthest_image,
                      execution);
      }
      return bound_.value() >= valid_until_;
    }

    void rebuilt(const Particles& particles, const Domain& domain, const PairExtent& extent) {
      if (bound_.bodies() != particles.size()) bound_.restart(particles, domain);
      extent_ = extent;
      valid_until_ = bound_.contact_threshold(extent.skin);
    }
    /// Pieces lie within their parent: its pairs are theirs for as long.
    void divide(const Particles& particles, const Body& whole, BodyIndex parent, BodyIndex second) {
      bound_.divide(particles, whole, parent, second);
      for (const BodyIndex piece : {parent, second})
        extent_.centres =
            std::max(extent_.centres, 2 * particles.shape(piece).circumradius + 3 * extent_.skin);
    }
    void invalidate() { valid_until_ = -infinity; }

    /// The displacement bound, as of the last call of `is_stale` [m].
    [[nodiscard]] double displacement() const { return bound_.value(); }
    [[nodiscard]] double contact_threshold(double gap) const {
      return bound_.contact_threshold(gap);
    }

   private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    DisplacementBound<Domain> bound_;
    PairExtent extent_;
    double valid_until_ = -infinity;  // in terms of displacement()
  };
};

static_assert(NeighbourList<VerletList>);

}  // namespace riprap
