// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the mixing rule: from the contact laws of two materials to that of their contacts.

#include <concepts>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// Two materials, a <= b.
struct MaterialPair {
  MaterialIndex a = 0;
  MaterialIndex b = 0;
};

namespace requirements {

/// `rule(law_a, law_b, pair)` -> the law of contacts of the two materials, of the type of theirs.
/// It is asked once for each pair when the laws are put together, that of a material with itself
/// included, and not in any step. Swapped laws must give the same law.
template <class R, class L>
concept MixingRuleCall = requires(const R& rule, const L& law, const MaterialPair& pair) {
  { rule(law, law, pair) } -> std::convertible_to<L>;
};

}  // namespace requirements

/// A `MixingRule` of contact laws of type L.
///
/// Optional: `rule.materials()`, one more than the highest material that it has an entry for.
template <class R, class L>
concept MixingRule = Policy<R> && ContactLaw<L> && requirements::MixingRuleCall<R, L>;

template <class R, class L>
consteval bool check_mixing_rule() {
  check_policy<R>();
  static_assert(requirements::MixingRuleCall<R, L>,
                "riprap: a MixingRule must have Law operator()(const Law& a, const Law& b, const "
                "MaterialPair&) const for the contact laws that it mixes");
  return MixingRule<R, L>;
}

}  // namespace riprap
