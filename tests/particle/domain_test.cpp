// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/domain.hpp>

#include <doctest/doctest.h>

#include <type_traits>

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
