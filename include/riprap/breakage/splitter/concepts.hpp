#pragma once
/// @file
/// The role of the splitter: from a ring and a line to two rings, or a refusal.

#include <concepts>
#include <optional>

#include <riprap/geometry/cut.hpp>

namespace riprap {

/// A `Splitter` cuts a particle in two or refuses. A refusal is remembered by the simulation until
/// the particle's contact partners change.
///
/// - `splitter(ring, line, mean_area)` -> the two rings, or nothing; `mean_area` [m^2] is that of
///   the intact particles. The rings' areas add up to the whole.
/// - `splitter.validate()`: throws InvalidInput for parameters that break a rule.
template <class S>
concept Splitter = requires(const S& splitter, Ring ring, const Line& line, double mean_area) {
  { splitter(ring, line, mean_area) } -> std::convertible_to<std::optional<CutRings>>;
  splitter.validate();
};

}  // namespace riprap
