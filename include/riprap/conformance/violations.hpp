// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What comes back from checking the axioms of a role: a sentence for every one that does not hold.

#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>

namespace riprap {

/// One sentence for each axiom that does not hold; empty where all hold.
using Violations = std::vector<std::string>;

/// The sentences, a line each; empty where all axioms hold.
[[nodiscard]] inline std::string to_text(const Violations& violations) {
  std::string text;
  for (const std::string& violation : violations) text += violation + "\n";
  return text;
}

/// Runs comparisons and writes down those that fail. Of each axiom only the first failure is kept,
/// for hundreds of the same kind tell no more. NaN fails every comparison.
class AxiomCheck {
 public:
  /// Where the next comparisons are made: goes into their sentences.
  void at(std::string_view quantity, double value) { place_ = {quantity, value}; }

  void equal(std::string_view axiom, double found, double expected, double tolerance) {
    if (!(std::abs(found - expected) <= tolerance) && found != expected)
      violate(axiom, found, to_text(expected) + " to within " + to_text(tolerance));
  }
  void at_least(std::string_view axiom, double found, double limit) {
    if (!(found >= limit)) violate(axiom, found, to_text(limit) + " or more");
  }
  void at_most(std::string_view axiom, double found, double limit) {
    if (!(found <= limit)) violate(axiom, found, to_text(limit) + " or less");
  }
  void holds(std::string_view axiom, bool found) {
    if (!found) violate(axiom, "no", "yes");
  }

  [[nodiscard]] const Violations& violations() const& { return violations_; }
  [[nodiscard]] Violations violations() && { return std::move(violations_); }

 private:
  void violate(std::string_view axiom, double found, const std::string& expected) {
    violate(axiom, to_text(found), expected);
  }
  void violate(std::string_view axiom, const std::string& found, const std::string& expected) {
    if (!violated_.emplace(axiom).second) return;
    std::string sentence(axiom);
    sentence += ": found " + found + ", expected " + expected;
    if (!place_.first.empty())
      sentence += ", at " + std::string(place_.first) + " = " + to_text(place_.second);
    violations_.push_back(std::move(sentence));
  }

  std::pair<std::string_view, double> place_{"", 0};
  std::set<std::string, std::less<>> violated_;
  Violations violations_;
};

}  // namespace riprap
