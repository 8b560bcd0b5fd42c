// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/mixing_rule.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <riprap/contact/mixing_rule/friction_of_pairs.hpp>
#include <riprap/contact/mixing_rule/mix_by_parameter.hpp>
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>

using namespace riprap;
using test::check_violated;

namespace {

const SpringDashpot one{.normal_stiffness = 1e7, .friction = 0.6, .damping_ratio = 0.1};
const SpringDashpot other{.normal_stiffness = 3e7, .friction = 0.2, .damping_ratio = 0.3};

struct FirstLaw {  // not symmetric
  template <class L>
  L operator()(const L& a, const L&, const MaterialPair&) const {
    return a;
  }
};
struct NegativeFriction {
  SpringDashpot operator()(const SpringDashpot& a, const SpringDashpot& b,
                           const MaterialPair&) const {
    return {.friction = -a.friction * b.friction};
  }
};
struct FrictionOfEdges {  // equal laws give another one
  SpringDashpot operator()(SpringDashpot a, const SpringDashpot& b, const MaterialPair&) const {
    a.normal_stiffness += b.normal_stiffness;
    a.damping_ratio = 0.5 * (a.damping_ratio + b.damping_ratio);
    a.friction = 0.5 * (a.friction + b.friction);
    return a;
  }
};

}  // namespace

TEST_CASE("the shipped mixing rules obey the axioms") {
  CHECK(to_text(mixing_rule_violations(MixByParameter{}, one, other)) == "");
  CHECK(to_text(mixing_rule_violations(MixByParameter<ArithmeticMean, Smaller>{}, one, other)) ==
        "");
  CHECK(to_text(mixing_rule_violations(FrictionOfPairs<>{.table = {{0, 1, 0.4}}}, one, other)) ==
        "");
  CHECK(to_text(mixing_rule_identity_violations(MixByParameter{}, one)) == "");
  CHECK(to_text(mixing_rule_identity_violations(MixByParameter{}, EnergyConservingSpring{})) == "");
  CHECK(to_text(mixing_rule_identity_violations(FrictionOfPairs<>{.table = {{0, 1, 0.4}}}, one)) ==
        "");
}

TEST_CASE("mixed laws obey the axioms of contact laws") {
  CHECK(to_text(contact_law_violations(MixedContactLaw{{one, other}})) == "");
  CHECK(to_text(contact_law_violations(MixedContactLaw{{EnergyConservingSpring{}}})) == "");
}

TEST_CASE("a rule that depends on the order, and laws that break an axiom, are reported") {
  check_violated(mixing_rule_violations(FirstLaw{}, one, other), "swapped laws give the same law");
  for (const auto& violations : {mixing_rule_violations(NegativeFriction{}, one, other),
                                 mixing_rule_identity_violations(NegativeFriction{}, one)}) {
    REQUIRE(violations.size() == 1);
    CHECK(violations.front().starts_with(
        "the law of each pair is valid: SpringDashpot.friction = -0."));
  }
  check_violated(mixing_rule_identity_violations(FrictionOfEdges{}, one),
                 "two equal laws give that law");
}
