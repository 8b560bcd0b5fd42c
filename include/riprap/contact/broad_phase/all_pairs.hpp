// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Compares every box with every other: the oracle that other broad phases are tested against.

#include <cstddef>
#include <span>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Quadratic in the number of bodies; for a few dozen it is as good as any.
struct AllPairs {
  double relative_skin = 0.1;  ///< over the mean diameter [-]

  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j)
        if (boxes[i].overlaps(boxes[j]))
          visit(static_cast<BodyIndex>(i), static_cast<BodyIndex>(j));
  }

  void validate() const { require_non_negative("AllPairs.relative_skin", relative_skin); }
};

static_assert(BroadPhase<AllPairs>);

}  // namespace riprap
