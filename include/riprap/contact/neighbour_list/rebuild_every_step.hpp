// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Neighbours are searched at every step: the neighbour list without acceleration.

#include <limits>

#include <riprap/contact/neighbour_list/concepts.hpp>

namespace riprap {

/// Pairs are those whose bounding boxes overlap now; no pair is skipped.
struct RebuildEveryStep {
  static constexpr bool uses_skin = false;

  template <class Domain>
  struct State {
    void record_motion(const Particles&, std::size_t, std::size_t, std::size_t) {}
    template <Execution E>
    [[nodiscard]] bool is_stale(const Particles&, const Domain&, const E&) const {
      return true;
    }
    void rebuilt(const Particles&, const Domain&, const PairExtent&) {}
    void divide(const Particles&, const Body&, BodyIndex, BodyIndex) {}
    void invalidate() {}
    [[nodiscard]] double displacement() const { return 0; }
    [[nodiscard]] double contact_threshold(double) const {
      return -std::numeric_limits<double>::infinity();
    }
  };
};

static_assert(NeighbourList<RebuildEveryStep>);

}  // namespace riprap
