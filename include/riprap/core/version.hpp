// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The version of riprap. It is written here only; the build reads these three numbers.

#include <string_view>

#include <riprap/core/compiler.hpp>

#define RIPRAP_VERSION_MAJOR 0
#define RIPRAP_VERSION_MINOR 1
#define RIPRAP_VERSION_PATCH 0

#define RIPRAP_DETAIL_QUOTE(number) #number
#define RIPRAP_DETAIL_TEXT(number) RIPRAP_DETAIL_QUOTE(number)

namespace riprap {

/// "MAJOR.MINOR.PATCH"
inline constexpr std::string_view version =
    RIPRAP_DETAIL_TEXT(RIPRAP_VERSION_MAJOR) "." RIPRAP_DETAIL_TEXT(
        RIPRAP_VERSION_MINOR) "." RIPRAP_DETAIL_TEXT(RIPRAP_VERSION_PATCH);

}  // namespace riprap

#undef RIPRAP_DETAIL_TEXT
#undef RIPRAP_DETAIL_QUOTE
