// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A straight cut with a sliver rule: the default splitter.

#include <riprap/breakage/splitter/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// Cuts along the line unless a piece would be too small, too slender, or no ConvexPolygon (65
/// vertices, a corner that round-off makes straight). Without the rule pieces break again and again
/// under the same load and energy appears from slivers crossed by neighbours; the rule sets the
/// count of breaks, so it is stated with every result. With `dust` a piece that is too small breaks
/// off: it is counted, in the grading for one, and no longer simulated.
struct StraightCut {
  double minimum_area = 0.08;  ///< of a piece, over the mean area of the intact particles [-]
  double maximum_aspect = 3;   ///< of a piece, diameter over least width [-]
  /// Of one intact particle; a break beyond them ends the run with a SimulationError. The default
  /// areas allow 21 for a particle of 1.3 times the mean diameter.
  unsigned maximum_pieces = 100;
  bool dust = false;

  [[nodiscard]] std::optional<CutRings> operator()(Ring ring, const Line& line,
                                                   double mean_area) const {
    std::optional<CutRings> parts = cut(ring, line, snap);
    const auto allowed = [&](Ring piece) {
      return is_dust(piece, mean_area) || acceptable(piece, mean_area);
    };
    if (parts && allowed(parts->left) && allowed(parts->right)) return parts;
    return std::nullopt;
  }

  [[nodiscard]] bool is_dust(Ring piece, double mean_area) const {
    return dust && polygon_area(piece) < minimum_area * mean_area;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("minimum_area", self.minimum_area);
    visit("maximum_aspect", self.maximum_aspect);
    visit("maximum_pieces", self.maximum_pieces);
    visit("dust", self.dust);
  }

  void validate() const {
    require_non_negative("StraightCut.minimum_area", minimum_area);
    require(maximum_aspect >= 1, "StraightCut.maximum_aspect", maximum_aspect, "must be 1 or more");
    require(maximum_pieces >= 1, "StraightCut.maximum_pieces", maximum_pieces, "must be 1 or more");
  }

 private:
  /// A crack that would pass a corner within a thousandth of the diameter ends in it: an edge
  /// shorter than that would be meshed with triangles of no area.
  static constexpr double snap = 1e-3;

  [[nodiscard]] bool acceptable(Ring piece, double mean_area) const {
    return polygon_area(piece) >= minimum_area * mean_area && aspect(piece) <= maximum_aspect &&
           try_convex_polygon({piece.begin(), piece.end()});
  }
};

static_assert(Splitter<StraightCut>);

}  // namespace riprap
