// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A type names its state once: for checkpoints, digests and tables.

#include <type_traits>
#include <utility>

#include <riprap/core/compiler.hpp>

namespace riprap {

namespace internal {

/// Accepts every field.
struct AnyField {
  template <class Field>
  void operator()(const char* /*name*/, Field& /*field*/) {}
};

}  // namespace internal

/// A type with state names its fields, in a fixed order, by a static member
///
///     template <class Self, class Visit>
///     static void for_each_field(Self& self, Visit&& visit) {
///       visit("stiffness", self.stiffness);
///       visit("history", self.history_);
///     }
///
/// `Self` is const where the state is read. What can be computed from the fields is not named; a
/// member `restored()`, where there is one, computes it anew once they have been written.
template <class T>
concept NamesFields = requires(T& object, const T& constant, internal::AnyField visit) {
  T::for_each_field(object, visit);
  T::for_each_field(constant, visit);
};

/// Calls `visit(name, field)` for the fields of an object, in order. An empty class has none.
template <class T, class Visit>
void for_each_field(T& object, Visit&& visit) {
  using Type = std::remove_const_t<T>;
  if constexpr (NamesFields<Type>)
    Type::for_each_field(object, std::forward<Visit>(visit));
  else if constexpr (!std::is_empty_v<Type>)
    static_assert(NamesFields<Type>,
                  "riprap: a type that is saved must name its state: template <class Self, class "
                  "Visit> static void for_each_field(Self&, Visit&&) (docs/checkpoints.md)");
}

}  // namespace riprap
