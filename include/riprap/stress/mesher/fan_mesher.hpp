// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Triangles that fan out from the centroid. The file to copy for a mesher of your own.

#include <cstdint>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/stress/mesher/concepts.hpp>

namespace riprap {

/// Divides each edge evenly and joins every piece to the centroid: exact in constant stress, coarse
/// and pointed inside, where all triangles meet. Quick, and the same for every size and pose.
struct FanMesher {
  unsigned edge_divisions = 8;  ///< triangles on each edge

  [[nodiscard]] Mesh operator()(Ring ring) const;

  static void for_each_field(auto& self, auto&& visit) {
    visit("edge_divisions", self.edge_divisions);
  }

  void validate() const;
};

static_assert(Mesher<FanMesher>);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/mesher/fan_mesher.ipp>
#endif
