// SPDX-License-Identifier: BSL-1.0
#pragma once
// Numbers of a command line, read strictly: no other base, no blanks, nothing that wraps round.

#include <charconv>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <riprap/core/errors.hpp>

namespace command_line {

// A finite decimal number, or a whole one that the type can hold; nothing for any other text.
template <class Number>
  requires std::floating_point<Number> || std::unsigned_integral<Number>
std::optional<Number> number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  if constexpr (std::floating_point<Number>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

// What number_from takes.
template <class Number>
std::string rule_of_number() {
  if constexpr (std::floating_point<Number>) return "a finite decimal number";
  return "a whole number from 0 to " + std::to_string(std::numeric_limits<Number>::max());
}

// The shortest text that number_from reads back as the same number.
template <class Number>
std::string text_of(Number value) {
  if constexpr (std::floating_point<Number>) return riprap::to_text(value);
  return std::to_string(value);
}

}  // namespace command_line
