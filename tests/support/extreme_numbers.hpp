// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Numbers of a diverged state, and what pictures and tables of them must satisfy.

#include <array>
#include <limits>
#include <string>

#include <support/svg_document.hpp>

namespace riprap::test {

inline constexpr std::array<double, 11> extreme_numbers{std::numeric_limits<double>::quiet_NaN(),
                                                        std::numeric_limits<double>::infinity(),
                                                        -std::numeric_limits<double>::infinity(),
                                                        std::numeric_limits<double>::max(),
                                                        std::numeric_limits<double>::lowest(),
                                                        1e300,
                                                        -1e300,
                                                        1e18,
                                                        1e10,
                                                        std::numeric_limits<double>::denorm_min(),
                                                        0.0};

/// Parts that the picture says it left out. Throws std::runtime_error if the document is not
/// well-formed, or a shape or a text of it has a coordinate that is not a finite decimal number.
[[nodiscard]] inline std::size_t left_out_of(const std::string& document) {
  std::size_t count = 0;
  for (const SvgElement& e : svg_elements(document)) {
    if (e.text.starts_with("not drawn: ")) {
      count += std::stoul(e.text.substr(11));
      continue;
    }
    const bool is_part = e.name == "text" || e.name == "circle" || e.name == "line" ||
                         e.attributes.count("points") > 0 || e.attribute("x") != "";
    if (is_part && !(e.attributes.count("points") > 0 && e.points().empty()))
      static_cast<void>(box_of(e));
  }
  return count;
}

}  // namespace riprap::test
