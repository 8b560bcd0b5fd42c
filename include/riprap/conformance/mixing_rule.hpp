// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the mixing rule.

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include <riprap/conformance/collision.hpp>
#include <riprap/conformance/contact_law.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/contact/mixing_rule/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {
namespace internal {

/// Whether two laws give the same forces in a collision, as shares of the largest that may occur.
template <ContactLaw Law>
void check_same_forces(std::string_view axiom, const Law& one, const Law& other,
                       const ContactRange& range, double tolerance, AxiomCheck& check) {
  const double large = one.peak_stiffness() * range.deepest;
  check.equal(axiom, other.peak_stiffness() / one.peak_stiffness(), 1, tolerance);
  typename Law::History of_one{};
  typename Law::History of_other{};
  visit_collision(range, true, collision_time(one, range), [&](const CollisionInstant& now) {
    const ContactForce p = one(now.geometry, now.motion, of_one);
    const ContactForce q = other(now.geometry, now.motion, of_other);
    check.equal(axiom, q.normal / large, p.normal / large, tolerance);
    check.equal(axiom, q.tangential / large, p.tangential / large, tolerance);
    const double energy = large * range.deepest;
    check.equal(axiom, other.stored_energy(now.geometry, of_other) / energy,
                one.stored_energy(now.geometry, of_one) / energy, tolerance);
  });
}

/// A sentence for the first law whose parameters break a rule: axioms are those of valid laws.
template <ContactLaw Law>
[[nodiscard]] Violations invalid_laws(std::initializer_list<Law> laws) {
  try {
    for (const Law& law : laws) validate(law);
    return {};
  } catch (const InvalidInput& error) {
    return {std::string("the law of each pair is valid: ") + error.what()};
  }
}

}  // namespace internal

/// Which axioms a mixing rule breaks for the contact laws of two materials: the law of each pair is
/// valid, swapped laws give the same law, and the law of each pair obeys the axioms of contact
/// laws.
template <ContactLaw Law, class Rule>
  requires MixingRule<Rule, Law>
[[nodiscard]] Violations mixing_rule_violations(const Rule& rule, const Law& a, const Law& b,
                                                const ContactRange& range = {}) {
  const MaterialPair pair{0, 1};
  const Law mixed = rule(a, b, pair);
  const Law swapped = rule(b, a, pair);
  const Law of_pairs[] = {rule(a, a, MaterialPair{0, 0}), mixed, rule(b, b, MaterialPair{1, 1})};
  if (auto invalid = internal::invalid_laws({of_pairs[0], mixed, swapped, of_pairs[2]});
      !invalid.empty())
    return invalid;
  AxiomCheck check;
  internal::check_same_forces("swapped laws give the same law", mixed, swapped, range, 1e-9, check);
  Violations violations = std::move(check).violations();
  for (const Law& law : of_pairs)
    for (auto& violation : contact_law_violations(law, range))
      violations.push_back(std::move(violation));
  return violations;
}

/// A choice: two equal laws give that law, to the last bit of its forces.
template <ContactLaw Law, class Rule>
  requires MixingRule<Rule, Law>
[[nodiscard]] Violations mixing_rule_identity_violations(const Rule& rule, const Law& law,
                                                         const ContactRange& range = {}) {
  const Law mixed = rule(law, law, MaterialPair{});
  if (auto invalid = internal::invalid_laws({mixed}); !invalid.empty()) return invalid;
  AxiomCheck check;
  internal::check_same_forces("two equal laws give that law", law, mixed, range, 0, check);
  return std::move(check).violations();
}

}  // namespace riprap
