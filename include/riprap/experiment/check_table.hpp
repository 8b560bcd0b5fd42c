// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The numbers by which a biaxial test is judged, each beside its limit.

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/stage.hpp>

namespace riprap {

/// One number and the worst value that a test has had of it.
struct CheckedNumber {
  std::string name;
  std::string reason;  ///< what it means to be beyond the limit
  double limit = 0;
  bool is_upper_limit = true;
  double worst = 0;  ///< farthest towards or beyond the limit
  bool measured = false;
  Stage stage = Stage::compaction;  ///< where `worst` was met
  double axial_strain = 0;

  /// Whether a value keeps to the limit; one that is not a number does not.
  [[nodiscard]] bool allows(double value) const {
    return is_upper_limit ? value <= limit : value >= limit;
  }
  [[nodiscard]] bool holds() const { return !measured || allows(worst); }
};

/// All numbers of a test.
class CheckTable {
 public:
  /// Adds a number and returns its row.
  std::size_t add(std::string name, bool is_upper_limit, double limit, std::string reason) {
    rows_.push_back({std::move(name), std::move(reason), limit, is_upper_limit});
    return rows_.size() - 1;
  }

  [[nodiscard]] const std::vector<CheckedNumber>& rows() const { return rows_; }
  /// Rows whose worst value is beyond the limit.
  [[nodiscard]] std::size_t violations() const {
    std::size_t count = 0;
    for (const CheckedNumber& row : rows_) count += !row.holds();
    return count;
  }

  /// Takes a value of a row. Returns a sentence the first time that the row is beyond its limit,
  /// else an empty text.
  std::string measure(std::size_t row, double value, Stage stage, double axial_strain) {
    CheckedNumber& number = rows_[row];
    const bool held = number.holds();
    const bool is_worse =
        std::isnan(value) || (number.is_upper_limit ? value > number.worst : value < number.worst);
    if (!number.measured || (is_worse && !std::isnan(number.worst))) {
      number.worst = value;
      number.stage = stage;
      number.axial_strain = axial_strain;
    }
    number.measured = true;
    return held && !number.holds() ? sentence(number) : std::string{};
  }

 private:
  [[nodiscard, gnu::cold]] static std::string sentence(const CheckedNumber& number) {
    return number.name + " = " + to_text(number.worst) +
           (number.is_upper_limit ? " above " : " below ") + to_text(number.limit) + " at strain " +
           to_text(number.axial_strain) + " of " + to_text(number.stage) + ": " + number.reason;
  }

  std::vector<CheckedNumber> rows_;
};

}  // namespace riprap
