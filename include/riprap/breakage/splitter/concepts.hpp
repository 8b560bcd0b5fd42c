// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the splitter: from a ring and a line to two rings, or a refusal.

#include <concepts>
#include <cstddef>
#include <optional>

#include <riprap/core/policy.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

namespace requirements {

/// `splitter(ring, line, mean_area)` -> the two rings, whose areas add up to the whole, or nothing.
/// A piece that breaks a rule of ConvexPolygon (more than 64 vertices, not convex) counts as a
/// refusal; areas that do not add up end the run. A refusal is remembered until the particle's
/// contact partners change. `mean_area` [m^2] is that of the intact particles, by which a piece is
/// too small or not. Const, for one splitter serves all particles.
template <class S>
concept SplitterCall =
    requires(const S& splitter, const Ring ring, const Line& line, const double mean_area) {
      { splitter(ring, line, mean_area) } -> std::convertible_to<std::optional<CutRings>>;
    };

/// Optional: `splitter.maximum_pieces` that one intact particle may break into; the next break ends
/// the run with a SimulationError.
template <class S>
concept SplitterMaximumPieces =
    !requires(const S& splitter) { splitter.maximum_pieces; } || requires(const S& splitter) {
      { splitter.maximum_pieces } -> std::convertible_to<std::size_t>;
    };

/// Optional: `splitter.is_dust(piece, mean_area)`, whether a piece is counted and no longer
/// simulated. It takes its mass, momentum and energy with it. If both pieces are dust, the cut is
/// refused.
template <class S>
concept SplitterDust = !requires { &S::is_dust; } ||
                       requires(const S& splitter, const Ring piece, const double mean_area) {
                         { splitter.is_dust(piece, mean_area) } -> std::convertible_to<bool>;
                       };

}  // namespace requirements

/// A `Splitter` cuts a particle in two or refuses.
template <class S>
concept Splitter = Policy<S> && requirements::SplitterCall<S> &&
                   requirements::SplitterMaximumPieces<S> && requirements::SplitterDust<S>;

template <class S>
consteval bool check_splitter() {
  check_policy<S>();
  static_assert(requirements::SplitterCall<S>,
                "riprap: a Splitter must have std::optional<CutRings> "
                "operator()(Ring, const Line&, double mean_area) const");
  static_assert(requirements::SplitterMaximumPieces<S>,
                "riprap: maximum_pieces of a Splitter must be a std::size_t");
  static_assert(requirements::SplitterDust<S>,
                "riprap: is_dust of a Splitter must be bool is_dust(Ring, double mean_area) const");
  return Splitter<S>;
}

}  // namespace riprap
