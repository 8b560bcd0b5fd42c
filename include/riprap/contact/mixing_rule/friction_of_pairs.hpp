// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A table of friction coefficients for pairs of materials, over any other rule.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <riprap/contact/contact_law/with_friction.hpp>
#include <riprap/contact/mixing_rule/concepts.hpp>
#include <riprap/contact/mixing_rule/mix_by_parameter.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// The friction of two materials, in any order.
struct PairFriction {
  MaterialIndex a = 0;
  MaterialIndex b = 0;
  double friction = 0.5;  ///< mu [-]

  static void for_each_field(auto& self, auto&& visit) {
    visit("a", self.a);
    visit("b", self.b);
    visit("friction", self.friction);
  }
};

/// The law that `rule` gives, with the friction of the table where the pair is in it.
template <class Rule = MixByParameter<>>
struct FrictionOfPairs {
  std::vector<PairFriction> table{};
  Rule rule{};

  template <FrictionalLaw L>
    requires MixingRule<Rule, L>
  [[nodiscard]] L operator()(const L& a, const L& b, const MaterialPair& pair) const {
    const L mixed = rule(a, b, pair);
    for (const PairFriction& entry : table)
      if (is_of(entry, pair)) return with_friction(mixed, entry.friction);
    return mixed;
  }
  /// One more than the highest material in the table.
  [[nodiscard]] std::size_t materials() const {
    std::size_t count = 0;
    for (const PairFriction& entry : table)
      count = std::max<std::size_t>(count, std::size_t{1} + std::max(entry.a, entry.b));
    return count;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("table", self.table);
    visit("rule", self.rule);
  }

  /// Throws InvalidInput for a friction below 0 and for a pair that is in the table twice.
  void validate() const {
    riprap::validate(rule);
    for (std::size_t k = 0; k < table.size(); ++k) {
      const PairFriction& entry = table[k];
      require_non_negative("FrictionOfPairs: friction", entry.friction);
      for (std::size_t l = 0; l < k; ++l)
        if (is_of(table[l], {entry.a, entry.b}))
          throw InvalidInput("FrictionOfPairs: materials " + std::to_string(entry.a) + " and " +
                             std::to_string(entry.b) + ": must be in the table once");
    }
  }

 private:
  [[nodiscard]] static bool is_of(const PairFriction& entry, const MaterialPair& pair) {
    return (entry.a == pair.a && entry.b == pair.b) || (entry.a == pair.b && entry.b == pair.a);
  }
};

static_assert(MixingRule<FrictionOfPairs<>, LinearSpringCoulomb>);

}  // namespace riprap
