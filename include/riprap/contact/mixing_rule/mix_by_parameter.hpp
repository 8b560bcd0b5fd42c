// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Mixes contact laws parameter by parameter: the default rule.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/mixing_rule/concepts.hpp>
#include <riprap/contact/mixing_rule/means.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/fields.hpp>

namespace riprap {

/// The friction coefficient by one mean, every parameter whose name ends in `stiffness` by another,
/// other numbers by the arithmetic mean; what is true or false must be the same in both laws. For
/// laws that name their parameters by `for_each_field`.
template <MeanOfTwo FrictionMean = Smaller, MeanOfTwo StiffnessMean = InSeries>
struct MixByParameter {
  FrictionMean friction{};
  StiffnessMean stiffness{};

  /// Throws InvalidInput for laws that differ in what is true or false.
  template <ContactLaw L>
    requires NamesFields<L>
  [[nodiscard]] L operator()(const L& a, const L& b, const MaterialPair& pair) const {
    std::vector<double> of_b;
    riprap::for_each_field(b, [&](const char*, const auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      static_assert(std::is_arithmetic_v<Value>,
                    "riprap: MixByParameter is for contact laws whose parameters are numbers");
      of_b.push_back(static_cast<double>(value));
    });
    L mixed = a;
    std::size_t k = 0;
    riprap::for_each_field(mixed, [&]<class Value>(const char* name, Value& value) {
      const double other = of_b[k++];
      if constexpr (std::same_as<Value, bool>)
        require_same(name, value == (other != 0), pair);
      else
        value = static_cast<Value>(mean(name, static_cast<double>(value), other));
    });
    return mixed;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("friction", self.friction);
    visit("stiffness", self.stiffness);
  }

 private:
  [[nodiscard]] double mean(std::string_view name, double a, double b) const {
    if (name == "friction") return friction(a, b);
    if (name.ends_with("stiffness")) return stiffness(a, b);
    return ArithmeticMean{}(a, b);
  }
  static void require_same(const char* name, bool same, const MaterialPair& pair) {
    if (!same)
      throw InvalidInput(std::string("MixByParameter: ") + name + " must be the same in the " +
                         "contact laws of the materials " + std::to_string(pair.a) + " and " +
                         std::to_string(pair.b));
  }
};

static_assert(MixingRule<MixByParameter<>, LinearSpringCoulomb>);

}  // namespace riprap
