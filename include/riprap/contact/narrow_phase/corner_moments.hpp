// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Depth of OverlapMoments for a corner of each body in the other, in closed form.

#include <cstddef>

#include <riprap/contact/narrow_phase/quadrangle_moments.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>

namespace riprap::internal {

/// Of as many pairs as N has lanes: the quadrangle of where the boundary enters a, a's corner, the
/// other crossing and b's corner.
template <class N>
struct CornerMoments {
  N normal_x, normal_y, point_x, point_y, depth, gradient, area, chord;
  N opposite;  // above zero: the corners lie on opposite sides of the chord

  [[gnu::always_inline]] explicit CornerMoments(const CornerLens<N>& lens) {
    const auto from = [](const auto& start, const auto& end) __attribute__((always_inline)) {
      return PlaneVector<N>{end.x - start.x, end.y - start.y};
    };
    const PlaneVector<N> d = from(lens.enters, lens.leaves);
    const PlaneVector<N> e = from(lens.p.at, lens.q.at);
    const PlaneVector<N> side = from(lens.enters, lens.p.at);
    const QuadrangleMoments<N> m(d, e, lens.at_enters + lens.at_leaves, lens.at_enters,
                                 side.cross(d));
    chord = square_root(m.dd);
    area = 0.5 * m.twice_area;
    depth = m.slope * m.twice_area;

    // Force, turned by 90 degrees, and moment about the centroid, over W / A.
    const N bb = m.b * m.b;
    opposite = 1 - bb;
    const N tilt = opposite * m.skew;
    const PlaneVector<N> line{d.x - tilt * e.x, d.y - tilt * e.y};
    const N moment = m.a * m.dd * (1.0 / 3) +
                     (m.a * m.dd - 2 * m.b * m.de) * (2 * m.dd - opposite * m.ee) * m.per_spread +
                     (8 * m.b * bb * m.de - m.a * (12 * m.dd + opposite * (3 + 5 * bb) * m.ee)) *
                         m.per_shape * (1.0 / 6);

    // x / sqrt(y) as x sqrt(y) (1 / y): the root and the division do not wait for each other.
    const N squared = line.dot(line);
    const N length = square_root(squared);
    const N reciprocal = 1 / squared;
    const N inverse = length * reciprocal;
    gradient = m.slope * length;
    normal_x = line.y * inverse;
    normal_y = -line.x * inverse;
    const N back = moment * reciprocal;
    const N on_d = 0.5 - m.a * (1.0 / 6) - back;
    const N on_e = m.b * (1.0 / 3) + back * tilt;
    point_x = lens.enters.x + on_d * d.x + on_e * e.x;
    point_y = lens.enters.y + on_d * d.y + on_e * e.y;
  }

  /// Not if round-off has put both corners on one side of the chord: clipping decides then.
  [[nodiscard, gnu::always_inline]] bool has_digits(std::size_t l) const {
    return lane(opposite, l) > 0;
  }
  [[nodiscard, gnu::always_inline]] ContactGeometry overlap(std::size_t l) const {
    return {.normal = {lane(normal_x, l), lane(normal_y, l)},
            .point = {lane(point_x, l), lane(point_y, l)},
            .depth = lane(depth, l),
            .area = lane(area, l),
            .chord = lane(chord, l),
            .depth_gradient = lane(gradient, l)};
  }
};

}  // namespace riprap::internal
