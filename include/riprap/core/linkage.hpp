// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Header-only, or with the library riprap::compiled: what depends on no policy is declared in a
/// header and defined in the .ipp file beside it. Without RIPRAP_COMPILED the header includes that
/// file, and its functions are inline. With it they come from the library, and a program does not
/// parse them.

#include <riprap/core/compiler.hpp>

#ifdef RIPRAP_COMPILED
#define RIPRAP_INLINE

// Alignment of Eigen's matrices and the number of SIMD lanes depend on the instruction set: a
// program for another one than the library's is refused by the linker, which names this function.
#if defined(__AVX512F__)
#define RIPRAP_INSTRUCTION_SET riprap_compiled_is_for_avx512
#elif defined(__AVX__)
#define RIPRAP_INSTRUCTION_SET riprap_compiled_is_for_avx
#else
#define RIPRAP_INSTRUCTION_SET riprap_compiled_is_for_less_than_avx
#endif

namespace riprap::internal {

void RIPRAP_INSTRUCTION_SET();

namespace {
[[gnu::used]] void (*const instruction_set)() = RIPRAP_INSTRUCTION_SET;
}  // namespace

}  // namespace riprap::internal
#else
#define RIPRAP_INLINE inline
#endif
