// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which types of fields there are, besides classes that name their own.

#include <array>
#include <concepts>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>

namespace riprap {

/// The name of a type, as the compiler writes it.
template <class T>
[[nodiscard]] constexpr std::string_view type_name() {
  const std::string_view text =
      __PRETTY_FUNCTION__;  // "... [with T = NAME; ...]", "... [T = NAME]"
  const std::size_t first = text.find("T = ") + 4;
  const std::size_t end = text.find(';', first);
  return text.substr(first, (end == text.npos ? text.size() - 1 : end) - first);
}

namespace internal {

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <Number T>
[[nodiscard]] consteval NumberType number_type() {
  using enum NumberType;
  if constexpr (std::is_enum_v<T>) {
    return number_type<std::underlying_type_t<T>>();
  } else if constexpr (std::is_floating_point_v<T>) {
    static_assert(sizeof(T) <= 8, "riprap: numbers of more than 64 bits are not saved");
    return sizeof(T) == 4 ? f32 : f64;
  } else {
    constexpr NumberType is_signed[] = {i8, i16, i32, i64};
    constexpr NumberType is_unsigned[] = {u8, u16, u32, u64};
    constexpr std::size_t log_size = sizeof(T) == 1   ? 0
                                     : sizeof(T) == 2 ? 1
                                     : sizeof(T) == 4 ? 2
                                                      : 3;
    return (std::is_signed_v<T> ? is_signed : is_unsigned)[log_size];
  }
}

// What the members of the classes below do with a type that is not a class with fields.
template <class T>
inline constexpr bool is_vector = false;
template <class T, class A>
inline constexpr bool is_vector<std::vector<T, A>> = true;
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_variant = false;
template <class... T>
inline constexpr bool is_variant<std::variant<T...>> = true;
template <class T>
inline constexpr bool is_pair = false;
template <class P, class Q>
inline constexpr bool is_pair<std::pair<P, Q>> = true;

}  // namespace internal
}  // namespace riprap
