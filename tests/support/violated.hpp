// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Does a list of violations name an axiom?

#include <doctest/doctest.h>

#include <algorithm>
#include <string_view>

#include <riprap/conformance/violations.hpp>

namespace riprap::test {

/// One sentence is about this axiom; others may stand beside it.
inline void check_violated(const Violations& violations, std::string_view axiom) {
  CAPTURE(axiom);
  CAPTURE(to_text(violations));
  CHECK(std::ranges::any_of(violations, [axiom](std::string_view sentence) {
    return sentence.starts_with(axiom) && sentence.substr(axiom.size()).starts_with(": found ");
  }));
}

}  // namespace riprap::test
