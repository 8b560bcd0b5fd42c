// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A narrow phase chosen at run time: one more model of the role, for programs with options.

#include <optional>
#include <variant>

#include <riprap/contact/narrow_phase/concepts.hpp>

namespace riprap {

/// Holds one of several narrow phases, all of different types, and passes every question on to it,
/// pair by pair. What a pair has cached for another one is forgotten.
template <NarrowPhase... Narrows>
struct NarrowPhaseChoice {
  template <class Narrow>
  struct CacheOf {
    typename Narrow::Cache cache{};
  };
  using Cache = std::variant<CacheOf<Narrows>...>;

  std::variant<Narrows...> chosen;

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    return std::visit(
        [&]<class Narrow>(const Narrow& narrow) -> std::optional<ContactGeometry> {
          if (!std::holds_alternative<CacheOf<Narrow>>(cache)) cache = CacheOf<Narrow>{};
          return narrow(a, b, std::get<CacheOf<Narrow>>(cache).cache);
        },
        chosen);
  }
  [[nodiscard]] double clearance(const Cache& cache) const {
    return std::visit(
        [&]<class Narrow>(const Narrow& narrow) -> double {
          const auto* own = std::get_if<CacheOf<Narrow>>(&cache);
          if constexpr (requires { narrow.clearance(own->cache); })
            return own ? narrow.clearance(own->cache) : 0;
          return 0;
        },
        chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& narrow) { riprap::validate(narrow); }, chosen);
  }
};

}  // namespace riprap
