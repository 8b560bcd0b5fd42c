// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/mixing_rule/mix_by_parameter.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("friction, stiffnesses and the rest are mixed each by its mean") {
  const SpringDashpot a{
      .normal_stiffness = 1e7, .tangential_stiffness = 2e7, .friction = 0.6, .damping_ratio = 0.1};
  const SpringDashpot b{
      .normal_stiffness = 3e7, .tangential_stiffness = 0, .friction = 0.2, .damping_ratio = 0.3};
  const SpringDashpot mixed = MixByParameter{}(a, b, {0, 1});
  CHECK(mixed.normal_stiffness == near_relative(1.5e7, 1e-15));
  CHECK(mixed.tangential_stiffness == 0);
  CHECK(mixed.friction == 0.2);
  CHECK(mixed.damping_ratio == near_relative(0.2, 1e-15));
  const SpringDashpot means = MixByParameter<ArithmeticMean, ArithmeticMean>{}(a, b, {0, 1});
  CHECK(means.friction == near_relative(0.4, 1e-15));
  CHECK(means.normal_stiffness == near_relative(2e7, 1e-15));
}

TEST_CASE("a stiffness by area is a stiffness, a length is not") {
  const OverlapAreaSpring mixed =
      MixByParameter{}(OverlapAreaSpring{.area_stiffness = 1e11, .largest_chord = 0.01},
                       OverlapAreaSpring{.area_stiffness = 3e11, .largest_chord = 0.03}, {0, 1});
  CHECK(mixed.area_stiffness == near_relative(1.5e11, 1e-15));
  CHECK(mixed.largest_chord == near_relative(0.02, 1e-15));
}

TEST_CASE("laws that differ in what is true or false cannot be mixed") {
  CHECK(test::message_of([] {
          (void)MixByParameter{}(SpringDashpot{.may_pull = true}, SpringDashpot{}, {2, 4});
        }) == "MixByParameter: may_pull must be the same in the contact laws of the materials 2 "
              "and 4");
}
