// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The fields of an object as named arrays, whatever the file they go to.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Type of the numbers of an array. Truth values and enumerations are integers of their size.
enum class NumberType : unsigned char { i8, i16, i32, i64, u8, u16, u32, u64, f32, f64 };

[[nodiscard]] constexpr std::size_t size_of(NumberType type) {
  constexpr std::size_t bytes[] = {1, 2, 4, 8, 1, 2, 4, 8, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

/// A field: an array of numbers, a text, or a group of fields. In a sequence of objects every field
/// is an array with one row for each object.
struct FieldNode {
  enum class Kind : unsigned char { group, numbers, text };

  std::string path;  ///< names from the top, separated by '/'
  Kind kind = Kind::group;
  bool is_sequence = false;  ///< false: one row, a scalar
  std::size_t rows = 0;
  NumberType number = NumberType::f64;  ///< of numbers
  std::size_t columns = 1;              ///< numbers in a row
  std::vector<std::byte> bytes{};       ///< numbers row by row, or the characters of a text
  std::string type{};                   ///< of a group: the name of its class, if it was asked for
  std::vector<FieldNode> children{};    ///< of a group, in order
  std::size_t rows_read = 0;

  [[nodiscard]] std::string_view name() const;
  [[nodiscard]] std::size_t row_size() const { return columns * size_of(number); }
  [[nodiscard]] std::string text() const;

  /// The field of a group with this name. Throws InvalidInput if there is none.
  [[nodiscard]] FieldNode& child(std::string_view of);
  /// The field number `k` of a group; a new one at the end.
  FieldNode& child_at(std::size_t k, std::string_view of);

  /// Appends the bytes of a row of numbers.
  void append(NumberType type_of_row, std::size_t columns_of_row, const void* row);
  /// The next row of numbers. Throws InvalidInput where there is none or it is of another shape.
  [[nodiscard]] const std::byte* next_row(NumberType type_of_row, std::size_t columns_of_row);
};

/// Path of the first field of which a row has not been read; nothing if there is none.
[[nodiscard]] std::optional<std::string> first_unread(const FieldNode& node);

/// 64 bits that differ, with all probability, if a name, a shape or a number does.
[[nodiscard]] std::uint64_t digest(const FieldNode& node);

/// The same of bytes alone.
[[nodiscard]] std::uint64_t digest(std::span<const std::byte> bytes);

/// One sentence about the first field in which two objects differ; nothing if they are equal.
[[nodiscard]] std::optional<std::string> difference(const FieldNode& in_file,
                                                    const FieldNode& in_program);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/checkpoint/field_node.ipp>
#endif
