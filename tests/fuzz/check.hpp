// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a fuzz target reports.

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

namespace riprap::fuzz {

/// Prints the sentence that does not hold, and the values it is about, and aborts.
inline void check(bool holds, std::string_view sentence,
                  std::initializer_list<double> values = {}) {
  if (holds) return;
  std::fprintf(stderr, "violated: %.*s", static_cast<int>(sentence.size()), sentence.data());
  const char* separator = ": ";
  for (const double value : values) {
    std::fprintf(stderr, "%s%.17g", separator, value);
    separator = ", ";
  }
  std::fprintf(stderr, "\n");
  std::abort();
}

}  // namespace riprap::fuzz
