// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Whether a class names all of its members: one that was added later is easily forgotten.

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>

#include <riprap/checkpoint/field_types.hpp>
#include <riprap/core/errors.hpp>

namespace riprap::internal {

/// Size of a class whose members are the fields seen, in their order.
class NamedSize {
 public:
  template <class Field>
  void add() {
    const std::size_t align = alignof(Field);
    size_ = (size_ + align - 1) / align * align + sizeof(Field);
    align_ = std::max(align_, align);
  }
  [[nodiscard]] std::size_t size() const { return (size_ + align_ - 1) / align_ * align_; }

 private:
  std::size_t size_ = 0;
  std::size_t align_ = 1;
};

/// Parameters that an object names apart from its state (`for_each_parameter`) count as well.
template <class T>
void add_parameters(const T& object, NamedSize& named) {
  const auto add = [&]<class Parameter>(const char* /*name*/, const Parameter&) {
    named.add<Parameter>();
  };
  if constexpr (requires { T::for_each_parameter(object, add); })
    T::for_each_parameter(object, add);
}

/// Whether a class has to name all of its members: an aggregate, unless it says that the rest is
/// derived (`static constexpr bool names_all_members = false`), and another class that says so.
template <class T>
[[nodiscard]] consteval bool must_name_all() {
  if constexpr (requires { T::names_all_members; })
    return T::names_all_members;
  else
    return std::is_aggregate_v<T> && !std::is_empty_v<T>;
}

/// Throws InvalidInput for a class that is larger than what it names, if it must name all.
template <class T>
void require_all_named(const NamedSize& named) {
  if constexpr (must_name_all<T>())
    if (named.size() < sizeof(T))
      throw InvalidInput("for_each_field of " + std::string(type_name<T>()) + " names " +
                         std::to_string(named.size()) + " of " + std::to_string(sizeof(T)) +
                         " bytes: all members, in their order, or names_all_members = false");
}

}  // namespace riprap::internal
