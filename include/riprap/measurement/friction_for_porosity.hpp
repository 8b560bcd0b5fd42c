// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The friction during compaction with which a sample comes to a given porosity.

#include <cmath>
#include <string>

#include <riprap/core/errors.hpp>

namespace riprap {

/// Search for the friction coefficient under which a sample is to be compacted so that it comes to
/// a target porosity at the pressure at which it is measured (Agnolin and Roux 2007: without
/// friction as dense as it can be, with all of its friction loose). Between the two, porosity rises
/// with friction. Compact with `friction()`, measure, and `add` the porosity until it is `found`:
///
///     FrictionForPorosity search(0.17, 0.5);
///     while (!search.found()) search.add(porosity_after_compaction(search.friction()));
///
/// The first two samples are those with no and with all friction; then a secant that stays within
/// the bracket (Illinois method), since porosities of samples scatter.
class FrictionForPorosity {
 public:
  /// @param target    porosity, between 0 and 1
  /// @param largest   friction, that of the final sample [-], above 0
  /// @param tolerance of the porosity
  /// Throws InvalidInput if they are not so.
  FrictionForPorosity(double target, double largest, double tolerance = 1e-3)
      : target_(target), tolerance_(tolerance), high_{largest, 0} {
    require(target > 0 && target < 1, "FrictionForPorosity: target", target,
            "must lie between 0 and 1");
    require_positive("FrictionForPorosity: largest friction", largest);
    require_positive("FrictionForPorosity: tolerance", tolerance);
  }

  /// To compact with next, or with which the target was reached.
  [[nodiscard]] double friction() const { return friction_; }
  [[nodiscard]] bool found() const { return found_; }

  /// The porosity of the sample that was compacted with `friction()`. Throws InvalidInput if it is
  /// not between 0 and 1, or if the target lies outside of what friction can do.
  void add(double porosity) {
    require(porosity > 0 && porosity < 1, "FrictionForPorosity: porosity", porosity,
            "must lie between 0 and 1");
    const double excess = porosity - target_;
    ++tried_;
    found_ = std::abs(excess) <= tolerance_;
    if (found_) return;
    if (tried_ == 1) {
      require(excess < 0, "FrictionForPorosity: target", target_,
              "must be above the porosity without friction, " + std::to_string(porosity));
      low_.excess = excess;
      friction_ = high_.friction;
      return;
    }
    if (tried_ == 2) {
      require(excess > 0, "FrictionForPorosity: target", target_,
              "must be below the porosity with all friction, " + std::to_string(porosity));
      high_.excess = excess;
    } else {
      narrow(excess);
    }
    const double share = low_.excess / (low_.excess - high_.excess);
    friction_ = low_.friction + share * (high_.friction - low_.friction);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("target", self.target_);
    visit("tolerance", self.tolerance_);
    visit("low_friction", self.low_.friction);
    visit("low_excess", self.low_.excess);
    visit("high_friction", self.high_.friction);
    visit("high_excess", self.high_.excess);
    visit("friction", self.friction_);
    visit("last_side", self.last_side_);
    visit("tried", self.tried_);
    visit("found", self.found_);
  }

 private:
  struct End {
    double friction = 0;
    double excess = 0;  // of porosity over the target
  };

  // An end that stays for a second time counts by half.
  void narrow(double excess) {
    const int side = excess < 0 ? -1 : 1;
    End& moved = side < 0 ? low_ : high_;
    End& kept = side < 0 ? high_ : low_;
    moved = {friction_, excess};
    if (side == last_side_) kept.excess *= 0.5;
    last_side_ = side;
  }

  double target_;
  double tolerance_;
  End low_;
  End high_;
  double friction_ = 0;
  int last_side_ = 0;
  unsigned tried_ = 0;
  bool found_ = false;
};

}  // namespace riprap
