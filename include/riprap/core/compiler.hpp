// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Refuses compilers that cannot compile riprap, in one sentence before any other error: every
/// header includes this one, directly or through those it includes first. Valid since C++11.

#if defined(_MSC_VER) && !defined(__clang__)
#error "riprap needs g++ 12, clang 16 or later; MSVC is not supported"
#elif __cplusplus < 202002L
#error "riprap needs C++20: compile it with -std=c++20, and g++ 12, clang 16 or later"
#else
#include <version>
#if !defined(__cpp_aggregate_paren_init) || !defined(__cpp_lib_ranges) ||                          \
    (defined(__GLIBCXX__) && !defined(__cpp_lib_to_chars)) ||                                      \
    (defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 12)  // no __builtin_shufflevector
#error "riprap needs g++ 12, clang 16 or later; this compiler or its library lacks parts of C++20"
#endif
#endif
