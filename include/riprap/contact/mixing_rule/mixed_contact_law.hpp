// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law for each material, and for each pair of them the law that a rule makes of theirs.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/contact/contact_law/with_friction.hpp>
#include <riprap/contact/mixing_rule/concepts.hpp>
#include <riprap/contact/mixing_rule/mix_by_parameter.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// Evaluates each contact by the law of the two materials that touch. The laws of all pairs are
/// mixed once, here; a step looks the pair's up, and its place is kept in the history of the
/// contact, so that energy and breaks know it. Walls and platens have materials, too.
///
///     Model{}.contact_law(MixedContactLaw{{LinearSpringCoulomb{.friction = 0.6},
///                                          LinearSpringCoulomb{.friction = 0.3}}})
template <ContactLaw Law, class Rule = MixByParameter<>>
class MixedContactLaw {
 public:
  struct History {
    typename Law::History own{};
    std::uint32_t pair = 0;  ///< place in the table of laws

    static void for_each_field(auto& self, auto&& visit) {
      visit("own", self.own);
      visit("pair", self.pair);
    }
  };

  /// @param laws of the materials, in the order of the simulation's list of rocks
  /// Throws InvalidInput for an empty list, and where the rule does.
  explicit MixedContactLaw(std::vector<Law> laws, Rule rule = {})
      : laws_(std::move(laws)), rule_(std::move(rule)),
        count_(static_cast<std::uint32_t>(laws_.size())) {
    if (laws_.empty()) throw InvalidInput("MixedContactLaw: the list of laws is empty");
    if constexpr (check_mixing_rule<Rule, Law>())
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < count_; ++j) {
          const MaterialPair pair{static_cast<MaterialIndex>(std::min(i, j)),
                                  static_cast<MaterialIndex>(std::max(i, j))};
          pairs_.push_back(std::as_const(rule_)(laws_[pair.a], laws_[pair.b], pair));
        }
  }

  /// Number of materials; a simulation must have as many rocks.
  [[nodiscard]] std::size_t materials() const { return count_; }
  /// The law of contacts between two materials.
  [[nodiscard]] const Law& of(MaterialIndex a, MaterialIndex b) const {
    return pairs_[place_of(a, b)];
  }
  [[nodiscard]] const Rule& rule() const { return rule_; }

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    history.pair = place_of(motion.material_a, motion.material_b);
    return pairs_[history.pair](geometry, motion, history.own);
  }
  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    return pairs_[history.pair].stored_energy(geometry, history.own);
  }
  [[nodiscard]] History divided_history(const History& history, const ContactGeometry& geometry,
                                        const DividedContact& part) const {
    return {riprap::divided_history(pairs_[history.pair], history.own, geometry, part),
            history.pair};
  }
  [[nodiscard]] History history_after_bond(const ContactGeometry& geometry,
                                           const FormerBond& bond) const {
    const std::uint32_t pair = place_of(bond.material_a, bond.material_b);
    return {riprap::history_after_bond(pairs_[pair], geometry, bond), pair};
  }
  /// Of the stiffest pair [N/m].
  [[nodiscard]] double peak_stiffness() const {
    double largest = 0;
    for (const Law& law : pairs_) largest = std::max<double>(largest, law.peak_stiffness());
    return largest;
  }
  [[nodiscard]] MixedContactLaw frictionless() const {
    return with_pairs([](const Law& law) { return riprap::frictionless(law); });
  }
  /// All pairs get the same friction coefficient mu [-].
  [[nodiscard]] MixedContactLaw with_friction(double mu) const
    requires FrictionalLaw<Law>
  {
    return with_pairs([mu](const Law& law) { return riprap::with_friction(law, mu); });
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("laws", self.laws_);
    visit("rule", self.rule_);
    visit("pairs", self.pairs_);
  }

  /// Throws InvalidInput for a law that breaks a rule, of a material or a pair, with its place.
  void validate() const {
    riprap::validate(rule_);
    for (std::size_t k = 0; k < laws_.size(); ++k)
      validate_named("contact law of material " + std::to_string(k), laws_[k]);
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      validate_named("contact law of materials " + std::to_string(k / count_) + " and " +
                         std::to_string(k % count_),
                     pairs_[k]);
    if constexpr (requires { rule_.materials(); })
      require(rule_.materials() <= count_, "MixedContactLaw: materials of the rule",
              static_cast<double>(rule_.materials()),
              "must be at most those of the laws, " + std::to_string(count_));
  }

 private:
  [[nodiscard]] std::uint32_t place_of(MaterialIndex a, MaterialIndex b) const {
    return a * count_ + b;
  }
  template <class Change>
  [[nodiscard]] MixedContactLaw with_pairs(Change&& change) const {
    MixedContactLaw copy = *this;
    for (Law& law : copy.pairs_) law = change(law);
    return copy;
  }

  std::vector<Law> laws_;  // of the materials, as they were given
  Rule rule_;
  std::uint32_t count_;
  std::vector<Law> pairs_;  // of material i and j at i * count_ + j
};

template <class Law>
MixedContactLaw(std::initializer_list<Law>) -> MixedContactLaw<Law>;
template <class Law, class Rule>
MixedContactLaw(std::initializer_list<Law>, Rule) -> MixedContactLaw<Law, Rule>;

}  // namespace riprap
