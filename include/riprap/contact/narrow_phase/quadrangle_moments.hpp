// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of a quadrangle from its diagonals: docs/theory/contact.md, "Quadrangles".

#include <riprap/core/simd.hpp>

namespace riprap::internal {

/// A vector in the plane, for as many overlaps as N has lanes.
template <class N>
struct PlaneVector {
  N x, y;

  [[nodiscard, gnu::always_inline]] N dot(const PlaneVector& o) const { return x * o.x + y * o.y; }
  [[nodiscard, gnu::always_inline]] N cross(const PlaneVector& o) const {
    return x * o.y - y * o.x;
  }
};

/// Of the quadrangle of vertices 1 to 4, counter-clockwise, of which two may be the same; for as
/// many overlaps as N has lanes. Depths keep their digits, however thin it is.
template <class N>
struct QuadrangleMoments {
  PlaneVector<N> d, e;  // diagonals, from vertex 1 to 3 and from 2 to 4
  N twice_area;
  // From where the diagonals cross to the middle of d and of e, over half their lengths: xi, eta.
  N a, b;
  N dd, de, ee;  // products of the diagonals
  N per_shape;   // A^4 / (432 det S)
  N per_spread;  // A / (72 tr S)
  N slope;       // depth / (2 A)
  N skew;  // kappa: (1 + a) (1 + b) skew: excess of the force's density on side 1-2, over W / A

  /// @param all,at_1,at_2 twice the areas: whole, and cut off by e and d at vertices 1 and 2
  [[gnu::always_inline]] QuadrangleMoments(const PlaneVector<N>& from_1,
                                           const PlaneVector<N>& from_2, const N& all,
                                           const N& at_1, const N& at_2)
      : d(from_1), e(from_2), twice_area(all) {
    const N inverse = 2 / twice_area;
    a = 1 - at_1 * inverse;
    b = 1 - at_2 * inverse;
    dd = d.dot(d);
    de = d.dot(e);
    ee = e.dot(e);
    const N aa = a * a;
    const N bb = b * b;
    const N ab = 4 * (a * b);
    const N shape = 3 + aa + bb - aa * bb;
    per_shape = 1 / shape;
    per_spread = 1 / ((3 + aa) * dd + (3 + bb) * ee - ab * de);
    slope = square_root(N(shape * per_spread));
    skew = ab * per_shape - 6 * de * per_spread;
  }
};

}  // namespace riprap::internal
