// SPDX-License-Identifier: BSL-1.0
#pragma once
// The files of the page in this folder, which CMake has put into the program.

#include <string_view>

namespace replay {

extern const std::string_view page_html;
extern const std::string_view page_style;
extern const std::string_view page_program;

}  // namespace replay
