// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/domain.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

#include <support/near.hpp>

using namespace riprap;

TEST_CASE("an image in the open plane takes no room") {
  CHECK(std::is_empty_v<UnboundedDomain::Image>);
  CHECK(UnboundedDomain::Image{} == UnboundedDomain::Image{});
}

TEST_CASE("an image lies whole periods away and moves with the cell") {
  const PeriodicDomain domain{.period = {2, 3}, .rate = {0.1, -0.2}};
  const PeriodicDomain::Image image{1, -2};
  CHECK(domain.offset(image) == Vec2{2, -6});
  // A cell that shortens along axis 1 brings the image on the right nearer.
  CHECK((domain.velocity(image) - Vec2{-0.2, -1.2}).norm() <= 1e-15);
  CHECK(domain.offset(image + -image) == Vec2{0, 0});
}

TEST_CASE("a place belongs to the copy of the cell that holds it") {
  const PeriodicDomain domain{.period = {2, 3}};
  CHECK(domain.cell_of({0.9, -1.4}) == PeriodicDomain::Image{0, 0});
  CHECK(domain.cell_of({1.1, -1.6}) == PeriodicDomain::Image{1, -1});
  CHECK(domain.cell_of({-5.2, 4.6}) == PeriodicDomain::Image{-3, 2});
}

TEST_CASE("the images above a sheared cell are shifted and move along axis 1") {
  const PeriodicDomain domain{
      .period = {2, 3}, .rate = {0.1, -0.2}, .shear_offset = 0.7, .shear_rate = 0.5};
  const PeriodicDomain::Image image{1, -2};
  CHECK((domain.offset(image) - Vec2{2 - 2 * 0.7, -6}).norm() <= 1e-15);
  // The gradient (-0.1, 0.5; 0, 0.2) times the offset.
  CHECK((domain.velocity(image) - Vec2{-0.06 - 3, -1.2}).norm() <= 1e-15);
}

TEST_CASE("the rows of a sheared cell are shifted against each other") {
  const PeriodicDomain domain{.period = {2, 3}, .centre = {0.1, 0}, .shear_offset = 4.7};
  CHECK(domain.cell_of({1.0, -1.4}) == PeriodicDomain::Image{0, 0});
  // The cell above has its centre at 4.8, 2.8, 0.8, ...
  CHECK(domain.cell_of({0.8, 1.6}) == PeriodicDomain::Image{-2, 1});
  CHECK(domain.cell_of({1.9, 1.6}) == PeriodicDomain::Image{-1, 1});
}

TEST_CASE("a cell that is sheared and shortened at once becomes the exponential of its gradient") {
  PeriodicDomain domain{.period = {2, 3}, .rate = {0.4, -0.2}, .shear_rate = 0.5};
  constexpr int steps = 2000;
  for (int n = 0; n < steps; ++n) domain.drift(1.0 / steps);
  // Of (-0.4, 0.5; 0, 0.2) over 1 s; the scheme is of first order: 0.5 |G|^2 / n.
  const double a = std::exp(-0.4);
  const double b = std::exp(0.2);
  const double tolerance = 0.5 * (0.4 * 0.4 + 0.5 * 0.5 + 0.2 * 0.2) / steps;
  CHECK(domain.period.x() == test::near_relative(2 * a, tolerance));
  CHECK(domain.period.y() == test::near_relative(3 * b, tolerance));
  CHECK(domain.shear_offset == test::near_relative(3 * 0.5 * (b - a) / 0.6, tolerance));
}
