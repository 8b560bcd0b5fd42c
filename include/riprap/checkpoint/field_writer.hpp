// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From an object to its fields as named arrays.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/field_types.hpp>
#include <riprap/checkpoint/named_size.hpp>
#include <riprap/core/fields.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap::internal {

/// Appends objects to nodes.
struct FieldWriter {
  bool with_types = false;

  template <class T>
  void append(FieldNode& node, const T& value) const {
    if constexpr (Number<T>) {
      node.append(number_type<T>(), 1, &value);
    } else if constexpr (std::same_as<T, Vec2>) {
      node.append(NumberType::f64, 2, value.data());
    } else if constexpr (std::same_as<T, std::string>) {
      append_text(node, value);
    } else if constexpr (is_vector<T>) {
      append_vector(node, value);
    } else if constexpr (is_array<T>) {
      append_array(node, value);
    } else {
      append_group(node, value);
    }
  }

 private:
  template <class T>
  void append_group(FieldNode& node, const T& value) const {
    ++node.rows;
    std::size_t k = 0;
    if constexpr (is_optional<T>) {
      append(node.child_at(0, "present"), value.has_value());
      if (FieldNode& values = sequence(node, 1, "values"); value) append(values, *value);
    } else if constexpr (is_variant<T>) {
      append(node.child_at(0, "alternative"), static_cast<std::uint8_t>(value.index()));
      for (k = 0; k < std::variant_size_v<T>; ++k) (void)sequence(node, k + 1, std::to_string(k));
      std::visit([&](const auto& held) { append(node.children[value.index() + 1], held); }, value);
    } else if constexpr (is_pair<T>) {
      append(node.child_at(0, "first"), value.first);
      append(node.child_at(1, "second"), value.second);
    } else {
      if (with_types) node.type = type_name<T>();
      NamedSize named;
      add_parameters(value, named);
      for_each_field(value, [&]<class Field>(const char* name, const Field& field) {
        append(node.child_at(k++, name), field);
        named.add<Field>();
      });
      require_all_named<T>(named);
    }
  }

  void append_text(FieldNode& node, const std::string& text) const {
    if (node.is_sequence) return append_vector(node, std::vector<char>(text.begin(), text.end()));
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    node.kind = FieldNode::Kind::text;
    node.rows = 1;
    node.bytes.assign(first, first + text.size());
  }

  // A vector in a sequence: where its values start, and all values one after the other.
  template <class T>
  void append_vector(FieldNode& node, const std::vector<T>& values) const {
    if (!node.is_sequence) {
      node.is_sequence = true;
      prepare(node, static_cast<const T*>(nullptr));
      for (const T& value : values) append(node, value);
      return;
    }
    ++node.rows;
    (void)node.child_at(0, "start");
    FieldNode& all = sequence(node, 1, "values");  // a new one moves the one before
    append(node.children[0], static_cast<std::uint64_t>(all.rows));
    prepare(all, static_cast<const T*>(nullptr));
    for (const T& value : values) append(all, value);
  }

  template <class T, std::size_t N>
  void append_array(FieldNode& node, const std::array<T, N>& values) const {
    if constexpr (Number<T>) {
      node.append(number_type<T>(), N, values.data());
    } else {
      ++node.rows;
      for (std::size_t k = 0; k < N; ++k) append(node.child_at(k, std::to_string(k)), values[k]);
    }
  }

  // Shape of an array of numbers that may stay empty.
  template <class T>
  static void prepare(FieldNode& node, const T*) {
    if constexpr (Number<T> || std::same_as<T, Vec2>) {
      node.kind = FieldNode::Kind::numbers;
      if constexpr (Number<T>)
        node.number = number_type<T>();
      else
        node.columns = 2;
    }
  }

  static FieldNode& sequence(FieldNode& node, std::size_t k, const std::string& name) {
    FieldNode& child = node.child_at(k, name);
    child.is_sequence = true;
    return child;
  }
};

}  // namespace riprap::internal
