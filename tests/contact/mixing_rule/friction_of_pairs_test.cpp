// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/mixing_rule/friction_of_pairs.hpp>

#include <doctest/doctest.h>

#include <support/message_of.hpp>

using namespace riprap;
using test::message_of;

namespace {

const LinearSpringCoulomb rough{.normal_stiffness = 1e7, .friction = 0.6};
const LinearSpringCoulomb smooth{.normal_stiffness = 1e7, .friction = 0.2};

}  // namespace

TEST_CASE("pairs in the table have their friction, in any order; others that of the rule") {
  const FrictionOfPairs<> rule{.table = {{1, 0, 0.35}, {1, 1, 0.9}}};
  CHECK(rule(rough, smooth, {0, 1}).friction == 0.35);
  CHECK(rule(smooth, smooth, {1, 1}).friction == 0.9);
  CHECK(rule(rough, smooth, {0, 2}).friction == 0.2);
  CHECK(rule(rough, smooth, {0, 1}).normal_stiffness == 1e7);
  CHECK(rule.materials() == 2);
  CHECK(FrictionOfPairs<>{}.materials() == 0);
}

TEST_CASE("a friction below 0 and a pair that is there twice are refused") {
  CHECK(message_of([] {
          FrictionOfPairs<>{.table = {{0, 1, -0.1}}}.validate();
        }) == "FrictionOfPairs: friction = -0.1: must be a finite number, 0 or above");
  CHECK(message_of([] {
          FrictionOfPairs<>{.table = {{0, 1, 0.1}, {1, 0, 0.2}}}.validate();
        }) == "FrictionOfPairs: materials 1 and 0: must be in the table once");
  CHECK(message_of([] {
          FrictionOfPairs<>{.table = {{0, 1, 0.1}, {1, 1, 0.2}}}.validate();
        }).empty());
}
