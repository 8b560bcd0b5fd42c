// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The rocks of an assembly: each particle is of one of them.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/material/rock.hpp>

namespace riprap {

/// A list of rocks; `PlacedParticle::material` is a place in it. One rock converts to a list of
/// one.
class Rocks {
 public:
  Rocks(const Rock& rock) : rocks_{rock} {}
  Rocks(std::initializer_list<Rock> rocks) : rocks_(rocks) {}
  explicit Rocks(std::vector<Rock> rocks) : rocks_(std::move(rocks)) {}

  [[nodiscard]] std::size_t size() const { return rocks_.size(); }
  [[nodiscard]] const Rock& operator[](MaterialIndex i) const { return rocks_[i]; }
  [[nodiscard]] const Rock& front() const { return rocks_.front(); }
  [[nodiscard]] const std::vector<Rock>& list() const { return rocks_; }

  [[nodiscard]] std::vector<double> densities() const {  ///< [kg/m^3]
    std::vector<double> values;
    for (const Rock& rock : rocks_) values.push_back(rock.density);
    return values;
  }

  /// Throws InvalidInput for an empty list and for a rock that breaks a rule, with its place.
  void validate() const {
    if (rocks_.empty()) throw InvalidInput("Rocks: the list is empty");
    if (rocks_.size() == 1) return rocks_[0].validate();
    for (std::size_t k = 0; k < rocks_.size(); ++k)
      validate_named("rock " + std::to_string(k), rocks_[k]);
  }

 private:
  std::vector<Rock> rocks_;
};

}  // namespace riprap
