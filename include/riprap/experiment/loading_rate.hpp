// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How fast a sample is strained.

#include <string>

#include <riprap/core/errors.hpp>

namespace riprap {

/// A strain rate, positive in shortening: by the inertial number at a pressure, or given.
struct LoadingRate {
  double inertial_number = 0;  ///< negative in extension; 0: the rate is given
  double pressure = 0;         ///< of the inertial number [Pa]; 0: the path's confining pressure
  double per_second = 0;       ///< [1/s], where there is no inertial number

  template <class View>
  [[nodiscard]] double value(const View& view) const {
    if (inertial_number == 0) return per_second;
    return view.rate_at(inertial_number, pressure > 0 ? pressure : view.confining_pressure);
  }

  /// The same in the other direction.
  [[nodiscard]] LoadingRate operator-() const { return {-inertial_number, pressure, -per_second}; }

  /// Throws InvalidInput that names the owner and the rule.
  void validate(const std::string& owner) const {
    require_finite(owner + ".inertial_number", inertial_number);
    require_finite(owner + ".per_second", per_second);
    require_non_negative(owner + ".pressure", pressure);
    require((inertial_number == 0) != (per_second == 0), owner + ".inertial_number",
            inertial_number, "must be other than 0, or per_second must, and not both");
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("inertial_number", self.inertial_number);
    visit("pressure", self.pressure);
    visit("per_second", self.per_second);
  }
};

}  // namespace riprap
