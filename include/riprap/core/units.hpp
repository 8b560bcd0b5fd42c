// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Unit literals (MPa, mm, deg), converted to SI. They give plain numbers: the compiler does not
/// see a length where a stress belongs.

#include <numbers>

#include <riprap/core/conventions.hpp>

namespace riprap::inline literals {

// One integer and one floating overload per unit: 2_MPa and 2.5_MPa both work.
constexpr double operator""_Pa(long double v) { return static_cast<double>(v); }
constexpr double operator""_Pa(unsigned long long v) { return static_cast<double>(v); }
constexpr double operator""_kPa(long double v) { return static_cast<double>(v) * 1e3; }
constexpr double operator""_kPa(unsigned long long v) { return static_cast<double>(v) * 1e3; }
constexpr double operator""_MPa(long double v) { return static_cast<double>(v) * 1e6; }
constexpr double operator""_MPa(unsigned long long v) { return static_cast<double>(v) * 1e6; }
constexpr double operator""_GPa(long double v) { return static_cast<double>(v) * 1e9; }
constexpr double operator""_GPa(unsigned long long v) { return static_cast<double>(v) * 1e9; }
constexpr double operator""_mm(long double v) { return static_cast<double>(v) * 1e-3; }
constexpr double operator""_mm(unsigned long long v) { return static_cast<double>(v) * 1e-3; }
constexpr double operator""_deg(long double v) {
  return static_cast<double>(v) * std::numbers::pi / 180;
}
constexpr double operator""_deg(unsigned long long v) {
  return static_cast<double>(v) * std::numbers::pi / 180;
}

}  // namespace riprap::inline literals
