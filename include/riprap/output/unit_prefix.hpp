// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Numbers for labels: a prefix to the unit and a few digits.

#include <array>
#include <charconv>
#include <string>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// A prefix of the SI and the factor it stands for; ASCII, so micro is `u`.
struct UnitPrefix {
  double factor = 1;
  const char* symbol = "";
};

/// The prefix that leaves `value` >= 0 between 1 and 1000; beyond nano and giga the last one. Zero
/// has none.
[[nodiscard]] inline UnitPrefix unit_prefix(double value) {
  constexpr std::array<UnitPrefix, 7> prefixes{
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}}};
  if (value == 0) return {};
  // A power of ten that was computed may lie a last digit below itself.
  for (const UnitPrefix& prefix : prefixes)
    if (value >= prefix.factor * (1 - 1e-9)) return prefix;
  return prefixes.back();
}

/// Three significant digits without an exponent or needless zeros: 0.3, 12.5, 1400.
[[nodiscard]] inline std::string rounded_text(double value) {
  char buffer[512];  // holds the largest and the smallest double
  char* const last = buffer + sizeof buffer;
  const char* end = std::to_chars(buffer, last, value, std::chars_format::scientific, 2).ptr;
  double rounded = value;  // and stays so where three digits are beyond the largest double
  std::from_chars(buffer, end, rounded);
  end = std::to_chars(buffer, last, rounded, std::chars_format::fixed).ptr;
  return {buffer, static_cast<std::size_t>(end - buffer)};
}

}  // namespace riprap
