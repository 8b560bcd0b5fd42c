#pragma once
/// @file
/// The role of the splitter: from a ring and a line to two rings, or a refusal.

#include <concepts>
#include <optional>

#include <riprap/core/policy.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

namespace clauses {

/// `splitter(ring, line, mean_area)` -> the two rings, whose areas add up to the whole, or nothing:
/// a refusal is remembered until the particle's contact partners change. `mean_area` [m^2] is that
/// of the intact particles, by which a piece is too small or not. Const, for one splitter serves
/// all particles.
template <class S>
concept SplitterCall =
    requires(const S& splitter, const Ring ring, const Line& line, const double mean_area) {
      { splitter(ring, line, mean_area) } -> std::convertible_to<std::optional<CutRings>>;
    };

}  // namespace clauses

/// A `Splitter` cuts a particle in two or refuses.
template <class S>
concept Splitter = Policy<S> && clauses::SplitterCall<S>;

template <class S>
consteval bool check_splitter() {
  check_policy<S>();
  static_assert(clauses::SplitterCall<S>, "riprap: a Splitter must have std::optional<CutRings> "
                                          "operator()(Ring, const Line&, double mean_area) const");
  return Splitter<S>;
}

}  // namespace riprap
