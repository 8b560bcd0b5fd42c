// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The fields of an object as named arrays, and back.

#include <concepts>
#include <string_view>
#include <type_traits>
#include <variant>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/field_reader.hpp>
#include <riprap/checkpoint/field_types.hpp>
#include <riprap/checkpoint/field_writer.hpp>
#include <riprap/core/fields.hpp>

namespace riprap {

namespace internal {

/// Calls `restored()` of everything in an object that has it, the object itself last.
template <class T>
void call_restored(T& value) {
  if constexpr (is_vector<T> || is_array<T>) {
    using Element = typename T::value_type;
    if constexpr (std::is_class_v<Element> && !std::same_as<Element, Vec2>)
      for (Element& element : value) call_restored(element);
  } else if constexpr (is_optional<T>) {
    if (value) call_restored(*value);
  } else if constexpr (is_variant<T>) {
    std::visit([](auto& held) { call_restored(held); }, value);
  } else if constexpr (is_pair<T>) {
    call_restored(value.first);
    call_restored(value.second);
  } else if constexpr (NamesFields<T>) {
    for_each_field(value, [](const char*, auto& field) { call_restored(field); });
  }
  if constexpr (requires { value.restored(); }) value.restored();
}

}  // namespace internal

/// The fields of an object.
/// @param with_types also the names of classes
template <class T>
[[nodiscard]] FieldNode fields_of(const T& object, std::string_view name, bool with_types = false) {
  FieldNode node;
  node.path = name;
  internal::FieldWriter{with_types}.append(node, object);
  return node;
}

/// Writes the fields to an object of the same type. Throws InvalidInput, naming the field, if they
/// are those of another one. What the object computes from them is left to `restored`.
template <class T>
void read_fields(FieldNode& node, T& object) {
  internal::FieldReader{}.read(node, object);
}

/// After the fields of an object have been written: computes the rest of its state.
template <class T>
void restored(T& object) {
  internal::call_restored(object);
}

}  // namespace riprap
