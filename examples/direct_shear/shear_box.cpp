// SPDX-License-Identifier: BSL-1.0
#include "shear_box.hpp"

#include <riprap/core/errors.hpp>

namespace direct_shear {

std::vector<riprap::PlacedParticle> box_walls(const BoxSize& size, riprap::Motion sides) {
  using riprap::ConvexPolygon;
  riprap::require_positive("BoxSize.width", size.width);
  riprap::require_positive("BoxSize.thickness", size.thickness);
  riprap::require(size.parting > 0 && size.parting < size.height, "BoxSize.parting", size.parting,
                  "must lie in (0, BoxSize.height)");
  const double in = 0.5 * size.width;
  const double out = in + size.thickness;
  const double top = size.height + size.thickness;
  const auto block = [](double left, double right, double bottom, double up,
                        riprap::Motion motion) {
    return riprap::PlacedParticle{
        ConvexPolygon{{left, bottom}, {right, bottom}, {right, up}, {left, up}}, motion};
  };
  const auto rough = riprap::Motion::wall;
  return {block(-out, out, -size.thickness, 0, rough), block(-out, -in, 0, size.parting, sides),
          block(in, out, 0, size.parting, sides),      block(-in, in, size.height, top, rough),
          block(-out, -in, size.parting, top, sides),  block(in, out, size.parting, top, sides)};
}

BoxForces& BoxForces::operator+=(const BoxForces& o) {
  shear_lower += o.shear_lower;
  shear_upper += o.shear_upper;
  normal_lid += o.normal_lid;
  normal_plane += o.normal_plane;
  return *this;
}

}  // namespace direct_shear
