// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The numbers by which a biaxial test is judged, each beside its limit.

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
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
  std::string stage_name{};  ///< in the path; empty: that of `stage`

  /// Whether a value keeps to the limit; one that is not a number does not.
  [[nodiscard]] bool allows(double value) const {
    return is_upper_limit ? value <= limit : value >= limit;
  }
  [[nodiscard]] bool holds() const { return !measured || allows(worst); }

  static void for_each_field(auto& self, auto&& visit) {
    visit("name", self.name);
    visit("reason", self.reason);
    visit("limit", self.limit);
    visit("is_upper_limit", self.is_upper_limit);
    visit("worst", self.worst);
    visit("measured", self.measured);
    visit("stage", self.stage);
    visit("axial_strain", self.axial_strain);
    visit("stage_name", self.stage_name);
  }
};

/// All numbers of a test.
class CheckTable {
 public:
  /// Adds a number and returns its row.
  std::size_t add(std::string name, bool is_upper_limit, double limit, std::string reason);

  [[nodiscard]] const std::vector<CheckedNumber>& rows() const { return rows_; }
  /// Rows whose worst value is beyond the limit.
  [[nodiscard]] std::size_t violations() const;

  /// Takes a value of a row. Returns a sentence the first time that the row is beyond its limit,
  /// else an empty text.
  std::string measure(std::size_t row, double value, Stage stage, double axial_strain,
                      std::string_view stage_name = {});

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("rows", self.rows_); }

 private:
  [[nodiscard, gnu::cold]] static std::string sentence(const CheckedNumber& number);

  std::vector<CheckedNumber> rows_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/experiment/check_table.ipp>
#endif
