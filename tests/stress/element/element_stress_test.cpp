// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/element/element_stress.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("element stresses start at zero and are zero again after a reset, whatever the size") {
  ElementStress stress;
  CHECK(stress.size() == 0);
  for (const std::size_t elements : {3u, 7u, 2u}) {
    stress.reset(elements);
    CHECK(stress.size() == elements);
    CHECK(stress.values().size() == static_cast<Eigen::Index>(3 * elements));
    CHECK(stress.values().isZero(0));
    for (std::size_t e = 0; e < elements; ++e) stress.set(e, {1, 2, 3});
  }
}

TEST_CASE("what is set for one element comes back for it and for no other") {
  ElementStress stress;
  stress.reset(4);
  stress.set(2, {5, -6, 7});
  for (std::size_t e = 0; e < 4; ++e) {
    CHECK(stress[e].s11 == (e == 2 ? 5 : 0));
    CHECK(stress[e].s22 == (e == 2 ? -6 : 0));
    CHECK(stress[e].s12 == (e == 2 ? 7 : 0));
  }
}

TEST_CASE("values run component by component: all s11, then all s22, then all s12") {
  ElementStress stress;
  stress.reset(2);
  stress.set(0, {1, 3, 5});
  stress.set(1, {2, 4, 6});
  for (Eigen::Index i = 0; i < 6; ++i) CHECK(stress.values()[i] == static_cast<double>(i + 1));
  stress.values() *= 10;
  CHECK(stress[1].s12 == 60);
}
