// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Classes of normal contact force, as the legend of a picture tells them apart.

#include <algorithm>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/output/unit_prefix.hpp>

namespace riprap {

/// Forces sorted into classes by the bounds between them; a bound belongs to the class above it.
struct ForceClasses {
  /// Rising [N]. Default: Fig. 11 of the paper, drawn at 2 MPa. It prints 100 N as the lower bound
  /// of the second class, inside the first; 200 N leaves neither gap nor overlap.
  std::vector<double> bounds{200, 500, 700, 1000, 1400};

  /// Throws InvalidInput unless bounds are positive and rise.
  void validate() const {
    if (bounds.empty()) throw InvalidInput("ForceClasses.bounds is empty");
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      require_positive("ForceClasses.bounds", bounds[k]);
      require(k == 0 || bounds[k] > bounds[k - 1], "ForceClasses.bounds", bounds[k],
              "must be larger than the bound before it");
    }
  }

  /// The same classes for forces larger by `factor`.
  [[nodiscard]] ForceClasses scaled(double factor) const {
    ForceClasses out = *this;
    for (double& bound : out.bounds) bound *= factor;
    return out;
  }

  [[nodiscard]] std::size_t size() const { return bounds.size() + 1; }

  /// Class of a normal force [N], 0 for the weakest; not-a-number counts as the strongest.
  [[nodiscard]] std::size_t operator()(double force) const {
    return static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), force) -
                                    bounds.begin());
  }

  /// What the legend says, such as "200 to 500 N"; all in the unit that suits the lowest bound.
  [[nodiscard]] std::string name(std::size_t k) const {
    const UnitPrefix prefix = unit_prefix(bounds.front());
    const auto number = [&](std::size_t b) { return rounded_text(bounds[b] / prefix.factor); };
    const std::string unit = std::string(" ") + prefix.symbol + "N";
    if (k == 0) return "below " + number(0) + unit;
    if (k == bounds.size()) return "from " + number(k - 1) + unit;
    return number(k - 1) + " to " + number(k) + unit;
  }
};

}  // namespace riprap
