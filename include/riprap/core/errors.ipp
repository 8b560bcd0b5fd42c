// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <charconv>
#include <cmath>

#include <riprap/core/errors.hpp>

namespace riprap {

RIPRAP_INLINE std::string to_text(double value) {
  if (std::isnan(value)) return "nan";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

namespace internal {

RIPRAP_INLINE void throw_invalid(std::string_view name, double value, std::string_view rule) {
  throw InvalidInput(std::string(name) + " = " + to_text(value) + ": " + std::string(rule));
}

}  // namespace internal

RIPRAP_INLINE std::string particle_text(ParticleId id) { return "particle " + std::to_string(id); }

}  // namespace riprap
