// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/load_scale.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a weak particle carries its load as a strong one would carry a larger load") {
  Particles particles(0.016, 2500);
  particles.add(ConvexPolygon{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}}, Motion::free);
  const WeibullStrength weibull{};
  CHECK(load_scale(weibull, particles, 0, Rock{}) ==
        near_relative(1 / weibull.strength_factor(0, particles.shape(0).area), 1e-15));
  CHECK(load_scale(FailedElementRatio{}, particles, 0, Rock{}) == 1);
}
