// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A criterion with parameters of its own for each rock.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// Holds one criterion for each material, in the order of the simulation's list of rocks; a
/// particle fails by that of its own. Criteria of different types: by a CriterionChoice.
///
///     Model{}.criterion(CriterionOfRock{{HoekBrown{.compressive_strength = 150e6},
///                                        HoekBrown{.compressive_strength = 50e6}}})
template <Criterion C>
  requires(!MaterialCriterion<C>)
struct CriterionOfRock {
  static constexpr bool never_fails = riprap::never_fails<C>;

  std::vector<C> criteria;  ///< of the materials

  [[nodiscard]] const C& of_material(MaterialIndex material) const { return criteria[material]; }
  [[nodiscard]] std::size_t materials() const { return criteria.size(); }

  // Where no material is named: that of the weakest, stress by stress.
  [[nodiscard]] double major_stress_at_failure(double minor) const {
    return least([minor](const C& c) { return double(c.major_stress_at_failure(minor)); });
  }
  [[nodiscard]] double tensile_strength() const {
    return least([](const C& c) { return double(c.tensile_strength()); });
  }
  [[nodiscard]] PrincipalValues extreme_stresses(const PrincipalValues& in_plane) const
    requires OutOfPlaneCriterion<C>
  {
    PrincipalValues extremes = in_plane;
    for (const C& c : criteria) {
      const PrincipalValues own = riprap::extreme_stresses(c, in_plane);
      extremes.major = std::max(extremes.major, own.major);
      extremes.minor = std::min(extremes.minor, own.minor);
    }
    return extremes;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("criteria", self.criteria); }

  /// Throws InvalidInput for an empty list and for a criterion that breaks a rule, with its place.
  void validate() const {
    if (criteria.empty()) throw InvalidInput("CriterionOfRock.criteria is empty");
    for (std::size_t k = 0; k < criteria.size(); ++k)
      validate_named("criterion of material " + std::to_string(k), criteria[k]);
  }

 private:
  template <class Strength>
  [[nodiscard]] double least(Strength&& strength) const {
    double value = std::numeric_limits<double>::infinity();
    for (const C& c : criteria) value = std::min(value, strength(c));
    return value;
  }
};

template <class C>
CriterionOfRock(std::initializer_list<C>) -> CriterionOfRock<C>;

}  // namespace riprap
