// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of a quadrangle, and the density of the force that they give: see OverlapMoments.

#include <riprap/core/simd.hpp>

namespace riprap::internal {

/// A place in a frame that moves with the overlap [m].
template <class N>
struct FramePoint {
  N u, v;
};

/// Of the quadrangle of the origin and three more vertices, counter-clockwise, of which two may be
/// the same; for as many overlaps as N has lanes. Accurate for thin overlaps along u.
template <class N>
struct QuadrangleMoments {
  N area, unit, det, depth;
  FramePoint<N> centroid;

  [[gnu::always_inline]] QuadrangleMoments(const FramePoint<N>& a, const FramePoint<N>& b,
                                           const FramePoint<N>& c) {
    // Two triangles at the origin.
    const N first = 0.5 * (a.u * b.v - a.v * b.u);
    const N second = 0.5 * (b.u * c.v - b.v * c.u);
    area = first + second;
    const N share = second / area;
    const N apart_u = c.u - a.u;
    const N apart_v = c.v - a.v;
    centroid = {(a.u + b.u + share * apart_u) * (1.0 / 3),
                (a.v + b.v + share * apart_v) * (1.0 / 3)};
    // Second moments: of each triangle about its centroid, and of their centroids.
    const N f = first * (1.0 / 18);
    const N s = second * (1.0 / 18);
    const N between = first * share * (1.0 / 9);
    uu_ = f * (a.u * a.u + b.u * b.u - a.u * b.u) + s * (b.u * b.u + c.u * c.u - b.u * c.u) +
          between * apart_u * apart_u;
    vv_ = f * (a.v * a.v + b.v * b.v - a.v * b.v) + s * (b.v * b.v + c.v * c.v - b.v * c.v) +
          between * apart_v * apart_v;
    uv_ = f * (a.u * a.v + b.u * b.v - 0.5 * (a.u * b.v + b.u * a.v)) +
          s * (b.u * b.v + c.u * c.v - 0.5 * (b.u * c.v + c.u * b.v)) + between * apart_u * apart_v;
    det = uu_ * vv_ - uv_ * uv_;
    const N trace = uu_ + vv_;
    of_trace_ = det / trace;
    unit = 12 / (area * trace);
    depth = square_root(N(2 * unit * det));
  }

  /// Density of the force over `unit`, at a place relative to the centroid.
  [[nodiscard, gnu::always_inline]] N density(const FramePoint<N>& r) const {
    return (vv_ - of_trace_) * r.u * r.u - 2 * uv_ * r.u * r.v + (uu_ - of_trace_) * r.v * r.v -
           det / area;
  }

 private:
  N uu_, vv_, uv_, of_trace_;
};

}  // namespace riprap::internal
