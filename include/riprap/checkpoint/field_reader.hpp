// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From named arrays back to the fields of an object.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/field_types.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/fields.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap::internal {

/// Reads the next objects from nodes.
struct FieldReader {
  /// @param in_sequence whether the object is one of a sequence
  template <class T>
  void read(FieldNode& node, T& value, bool in_sequence = false) const {
    if constexpr (Number<T>) {
      std::memcpy(&value, node.next_row(number_type<T>(), 1), sizeof value);
    } else if constexpr (std::same_as<T, Vec2>) {
      std::memcpy(value.data(), node.next_row(NumberType::f64, 2), sizeof value);
    } else if constexpr (std::same_as<T, std::string>) {
      read_text(node, value, in_sequence);
    } else if constexpr (is_vector<T>) {
      read_vector(node, value, in_sequence);
    } else if constexpr (is_array<T>) {
      read_array(node, value, in_sequence);
    } else {
      read_group(node, value, in_sequence);
    }
  }

 private:
  template <class T>
  void read_group(FieldNode& node, T& value, bool in_sequence) const {
    next_row_of_group(node);
    if constexpr (is_optional<T>) {
      bool present = false;
      read(node.child("present"), present);
      value.reset();
      if (present) read(node.child("values"), value.emplace(), true);
    } else if constexpr (is_variant<T>) {
      std::uint8_t alternative = 0;
      read(node.child("alternative"), alternative);
      read_alternative(node, alternative, value,
                       std::make_index_sequence<std::variant_size_v<T>>());
    } else if constexpr (is_pair<T>) {
      read(node.child("first"), value.first, in_sequence);
      read(node.child("second"), value.second, in_sequence);
    } else {
      for_each_field(value, [&](const char* name, auto& field) {
        read(node.child(name), field, in_sequence);
      });
    }
  }

  template <class V, std::size_t... K>
  void read_alternative(FieldNode& node, std::size_t alternative, V& value,
                        std::index_sequence<K...>) const {
    const auto is_read = [&]<std::size_t k>(std::integral_constant<std::size_t, k>) {
      if (k != alternative) return false;
      if (value.index() != k) value.template emplace<k>();
      read(node.child(std::to_string(k)), std::get<k>(value), true);
      return true;
    };
    if (!(is_read(std::integral_constant<std::size_t, K>{}) || ...))
      throw InvalidInput(node.path + ": no alternative " + std::to_string(alternative));
  }

  void read_text(FieldNode& node, std::string& text, bool in_sequence) const {
    if (in_sequence) {
      std::vector<char> characters;
      read_vector(node, characters, true);
      text.assign(characters.begin(), characters.end());
    } else {
      if (node.kind != FieldNode::Kind::text) throw InvalidInput(node.path + ": must be a text");
      text = node.text();
      node.rows_read = node.rows;
    }
  }

  template <class T>
  void read_vector(FieldNode& node, std::vector<T>& values, bool in_sequence) const {
    values.clear();
    if (!in_sequence) return read_rows(node, values, node.rows);
    next_row_of_group(node);
    FieldNode& all = node.child("values");
    FieldNode& starts = node.child("start");
    std::uint64_t start = 0;
    read(starts, start);
    std::uint64_t end = all.rows;
    if (starts.rows_read < starts.rows)
      std::memcpy(&end, starts.bytes.data() + sizeof end * starts.rows_read, sizeof end);
    if (start != all.rows_read || end < start || end > all.rows)
      throw InvalidInput(starts.path + ": must be the numbers of values before");
    read_rows(all, values, end - start);
  }

  template <class T>
  void read_rows(FieldNode& node, std::vector<T>& values, std::size_t rows) const {
    values.resize(rows);
    for (T& value : values) read(node, value, true);
  }

  template <class T, std::size_t N>
  void read_array(FieldNode& node, std::array<T, N>& values, bool in_sequence) const {
    if constexpr (Number<T>) {
      std::memcpy(values.data(), node.next_row(number_type<T>(), N), sizeof values);
    } else {
      next_row_of_group(node);
      for (std::size_t k = 0; k < N; ++k)
        read(node.child(std::to_string(k)), values[k], in_sequence);
    }
  }

  static void next_row_of_group(FieldNode& node) {
    if (node.kind != FieldNode::Kind::group || node.rows_read == node.rows)
      throw InvalidInput(node.path + ": must be a group with another row");
    ++node.rows_read;
  }
};

}  // namespace riprap::internal
