// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/plane_state/plane_state_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

using Choice = PlaneStateChoice<PlaneStress, PlaneStrain>;
static_assert(PlaneState<Choice>);

}  // namespace

TEST_CASE("a plane state chosen at run time gives the same as the one that was chosen") {
  const Rock rock;
  const Stress2 stress{30e6, 70e6, 5e6};
  const Choice thin{PlaneStress{}};
  CHECK(thin.elasticity(rock) == PlaneStress{}.elasticity(rock));
  CHECK(thin.out_of_plane_stress(rock, stress) == 0);
  const Choice thick{PlaneStrain{}};
  CHECK(thick.elasticity(rock) == PlaneStrain{}.elasticity(rock));
  CHECK(thick.out_of_plane_stress(rock, stress) == near_relative(17e6, 1e-14));
}

TEST_CASE("the first plane state is the one before any choice") {
  CHECK(Choice{}.elasticity(Rock{}) == PlaneStress{}.elasticity(Rock{}));
}
