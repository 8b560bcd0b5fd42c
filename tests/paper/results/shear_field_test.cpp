// SPDX-License-Identifier: BSL-1.0
#include <paper/results/shear_field.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <support/near.hpp>

using report::band_direction_excess;
using report::radius_of_bands;
using report::ShearWindow;
using riprap::Vec2;
using riprap::test::near;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A round sample of some 1,200 particles on a square grid, with shear that a function gives.
template <class Shear>
ShearWindow sample(Shear shear) {
  ShearWindow window;
  for (int i = -20; i <= 20; ++i)
    for (int k = -20; k <= 20; ++k) {
      const Vec2 place{0.05 * i, 0.05 * k};
      if (place.norm() <= 1) window.particles.push_back({place, place, shear(place)});
    }
  return window;
}

/// Shear that falls with the distance from a line through the centre, and a little along it.
auto band(double angle) {
  return [=](const Vec2& x) {
    const Vec2 along{std::cos(angle), std::sin(angle)};
    return 2 - std::abs(riprap::cross(along, x)) - 1e-3 * std::abs(along.dot(x));
  };
}

}  // namespace

TEST_CASE("the tenth with the most shear has the mean distance from the centre") {
  ShearWindow window;
  for (int i = 0; i < 20; ++i)
    window.particles.push_back({{9, 9}, {0.05 * i, 0}, i == 4 || i == 8 ? 2.0 : 1.0});
  CHECK(radius_of_bands(window) == near((0.2 + 0.4) / 2, 1e-15));
  CHECK(std::isnan(radius_of_bands({})));
}

TEST_CASE("pairs in an inclined band lie along it, and those in an axial or lateral one do not") {
  // A band of a tenth of the particles is 0.16 wide and 2 long: pairs two to eight spacings (0.05)
  // apart spread over some 20 degrees to either side of its direction.
  for (const double angle : {45 * degree, 54 * degree, 63 * degree, 126 * degree})
    CHECK(band_direction_excess(sample(band(angle))) > 0.2);
  // An axial band is 36 degrees off the middle of the range, into which its tails reach.
  CHECK(band_direction_excess(sample(band(0))) < -0.1);
  CHECK(band_direction_excess(sample(band(90 * degree))) < 0);
}

TEST_CASE("shear that prefers no direction has none in excess, whatever the outline") {
  // The tenth around the centre is a disc, of which all directions are alike up to the grid.
  const auto disc = sample([](const Vec2& x) { return 2 - x.norm(); });
  CHECK(std::abs(band_direction_excess(disc)) < 0.05);
  // Of a sample shortened to half its height all pairs, sheared or not, lie flatter alike.
  ShearWindow flat = sample([](const Vec2& x) { return std::sin(1e4 * x.x() + 3e4 * x.y()); });
  for (auto& p : flat.particles) p.place.y() *= 0.5;
  CHECK(std::abs(band_direction_excess(flat)) < 0.06);
}

TEST_CASE("no particles and no pairs have no direction") {
  CHECK(std::isnan(band_direction_excess({})));
  CHECK(std::isnan(band_direction_excess(sample(band(0)), 1000, 2000)));
}
