// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <utility>

#include <riprap/experiment/check_table.hpp>

namespace riprap {

RIPRAP_INLINE std::size_t CheckTable::add(std::string name, bool is_upper_limit, double limit,
                                          std::string reason) {
  rows_.push_back({std::move(name), std::move(reason), limit, is_upper_limit});
  return rows_.size() - 1;
}

RIPRAP_INLINE std::size_t CheckTable::violations() const {
  std::size_t count = 0;
  for (const CheckedNumber& row : rows_) count += !row.holds();
  return count;
}

RIPRAP_INLINE std::string CheckTable::measure(std::size_t row, double value, Stage stage,
                                              double axial_strain, std::string_view stage_name) {
  CheckedNumber& number = rows_[row];
  const bool held = number.holds();
  const bool is_worse =
      std::isnan(value) || (number.is_upper_limit ? value > number.worst : value < number.worst);
  if (!number.measured || (is_worse && !std::isnan(number.worst))) {
    number.worst = value;
    number.stage = stage;
    number.axial_strain = axial_strain;
    number.stage_name = stage_name;
  }
  number.measured = true;
  return held && !number.holds() ? sentence(number) : std::string{};
}

RIPRAP_INLINE std::string CheckTable::sentence(const CheckedNumber& number) {
  return number.name + " = " + to_text(number.worst) +
         (number.is_upper_limit ? " above " : " below ") + to_text(number.limit) + " at strain " +
         to_text(number.axial_strain) + " of " +
         (number.stage_name.empty() ? to_text(number.stage) : number.stage_name) + ": " +
         number.reason;
}

}  // namespace riprap
