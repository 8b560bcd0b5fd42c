// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Memory brought to the cache ahead of its use.

#include <cstddef>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Has `bytes` from `from` on brought to the cache while something else is done. Changes nothing;
/// pays where a program knows better than the processor what it will need. Always inlined, as have
/// to be functions that do nothing but call it: g++ leaves out calls without an effect.
[[gnu::always_inline]] inline void prefetch(const void* from, std::size_t bytes) {
  constexpr std::size_t line = 64;
  const char* const begin = static_cast<const char*>(from);
  for (std::size_t byte = 0; byte < bytes; byte += line) __builtin_prefetch(begin + byte);
  __builtin_prefetch(begin + bytes - 1);
}

}  // namespace riprap
