// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Errors that name the value, the rule, and where there is one the particle.

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include <riprap/core/ids.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Thrown for input that breaks a rule, before anything was computed from it.
struct InvalidInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Thrown when a simulation reaches a state from which it cannot go on; everything computed and
/// recorded up to the previous step is intact.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Shortest text that reads back as the same number; "nan" whatever its sign.
[[nodiscard, gnu::cold]] std::string to_text(double value);

namespace internal {

// Out of line and made small: its text is not composed anew wherever a rule is checked.
[[noreturn, gnu::cold]] void throw_invalid(std::string_view name, double value,
                                           std::string_view rule);

}  // namespace internal

/// Throws InvalidInput "<name> = <value>: <rule>" unless `holds`.
inline void require(bool holds, std::string_view name, double value, std::string_view rule) {
  if (!holds) internal::throw_invalid(name, value, rule);
}

inline void require_positive(std::string_view name, double value) {
  require(std::isfinite(value) && value > 0, name, value, "must be a finite number above 0");
}

inline void require_finite(std::string_view name, double value) {
  require(std::isfinite(value), name, value, "must be a finite number");
}

inline void require_non_negative(std::string_view name, double value) {
  require(std::isfinite(value) && value >= 0, name, value, "must be a finite number, 0 or above");
}

[[nodiscard, gnu::cold]] std::string particle_text(ParticleId id);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/core/errors.ipp>
#endif
