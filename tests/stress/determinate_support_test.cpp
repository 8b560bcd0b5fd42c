// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/determinate_support.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/mesher/fan_mesher.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;

TEST_CASE("the two nodes of a support are on opposite sides of the particle") {
  const Mesh mesh = FanMesher{2}(test::regular_polygon(6, 0.01).ring());
  const DeterminateSupport support = DeterminateSupport::on_opposite_sides(mesh);
  const Vec2 across = mesh.nodes[support.guided] - mesh.nodes[support.fixed];
  CHECK(across.norm() ==
        test::near_relative(0.02, 1e-12));  // the diameter of the circumscribed circle
}
