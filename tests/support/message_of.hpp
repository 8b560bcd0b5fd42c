// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The text of an error.

#include <string>

#include <riprap/core/errors.hpp>

namespace riprap::test {

/// Text of the InvalidInput that `action` throws; empty where it throws none.
template <typename Action>
[[nodiscard]] std::string message_of(Action&& action) {
  try {
    action();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace riprap::test
