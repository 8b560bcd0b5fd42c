// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/core/random.hpp>
#include <riprap/particle/placement_grid.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/particle/random_stones.hpp>

namespace riprap {

namespace internal {

/// Stones that are to be placed, about their own centroids, the largest first.
struct RandomStones {
  std::vector<Stone> stones;
  double area = 0;      ///< of all [m^2]
  double farthest = 0;  ///< vertex of a cell from the centroid of that cell [m]
  std::size_t cells = 0;
};

[[nodiscard]] inline RandomStones random_stones(const RandomAssembly& options,
                                                const std::vector<Stone>& library, Random& random) {
  if (library.empty()) throw InvalidInput("random stones: library is empty: must have a stone");
  for (std::size_t k = 0; k < library.size(); ++k)
    if (library[k].cells.empty())
      throw InvalidInput("random stones: stone " + std::to_string(k) +
                         " of the library has no cells: must have one or more");
  std::vector<double> diameters = random_diameters(options, random);
  std::sort(diameters.rbegin(), diameters.rend());
  RandomStones made;
  for (const double d : diameters) {
    const Stone& drawn =
        library[random.uniform_integer(0, static_cast<unsigned>(library.size() - 1))];
    const Rotation turn = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
    const double scale = d / equivalent_diameter(drawn.area());
    made.stones.push_back(drawn.moved(scale, turn, -scale * (turn * drawn.centroid())));
    made.area += made.stones.back().area();
    made.cells += drawn.cells.size();
    for (const ConvexPolygon& cell : made.stones.back().cells) {
      const Vec2 centroid = area_properties(cell.ring()).centroid;
      for (const Vec2& v : cell) made.farthest = std::max(made.farthest, (v - centroid).norm());
    }
  }
  return made;
}

/// Random places in a box. @param is_clear(grid, cell, its centroid)
template <class IsClear>
[[nodiscard]] StoneAssembly place_stones(const RandomStones& made, Assembly assembly,
                                         const Vec2& half, Random& random, IsClear&& is_clear) {
  StoneAssembly out{std::move(assembly), {}};
  std::vector<PlacedParticle>& particles = out.assembly.particles;
  out.stone.assign(particles.size(), no_stone);
  // The grid points into the list, which must not move.
  particles.reserve(particles.size() + made.cells);
  PlacementGrid grid(2 * made.farthest);
  constexpr unsigned most_tries = 100000;
  for (std::size_t k = 0; k < made.stones.size(); ++k)
    for (unsigned tries = 0;; ++tries) {
      if (tries == most_tries)
        throw InvalidInput("random stones: no room for stone " + std::to_string(k) + " in " +
                           std::to_string(most_tries) + " tries; lower solid_fraction");
      const Vec2 centre = place_in_box(half, random);
      Stone candidate = made.stones[k].moved(1, {}, centre);
      const bool clear =
          std::all_of(candidate.cells.begin(), candidate.cells.end(), [&](const auto& cell) {
            return is_clear(grid, cell, area_properties(cell.ring()).centroid);
          });
      if (!clear) continue;
      for (ConvexPolygon& cell : candidate.cells) {
        particles.push_back({.polygon = std::move(cell), .motion = Motion::free});
        const ConvexPolygon& placed = particles.back().polygon;
        grid.insert(placed, area_properties(placed.ring()).centroid);
        out.stone.push_back(static_cast<std::uint32_t>(k));
      }
      break;
    }
  return out;
}

}  // namespace internal

RIPRAP_INLINE std::uint32_t StoneAssembly::count() const {
  std::uint32_t count = 0;
  for (const std::uint32_t s : stone)
    if (s != no_stone) count = std::max(count, s + 1);
  return count;
}

RIPRAP_INLINE std::vector<std::vector<std::size_t>> StoneAssembly::clusters() const {
  std::vector<std::vector<std::size_t>> out(count());
  for (std::size_t i = 0; i < stone.size(); ++i)
    if (stone[i] != no_stone) out[stone[i]].push_back(i);
  return out;
}

RIPRAP_INLINE StoneAssembly random_platen_stones(const RandomAssembly& options,
                                                 const std::vector<Stone>& library) {
  options.validate();
  Random random(options.seed);
  const internal::RandomStones made = internal::random_stones(options, library, random);
  const Vec2 half =
      internal::half_extents(made.area / options.solid_fraction, options.aspect_ratio);
  return internal::place_stones(
      made, internal::four_platens(options, half), half, random,
      [half](const internal::PlacementGrid& placed, const ConvexPolygon& cell, const Vec2& at) {
        return internal::lies_in_box(cell.ring(), half) && placed.is_clear(cell.ring(), at);
      });
}

RIPRAP_INLINE StoneAssembly random_periodic_stones(const RandomAssembly& options,
                                                   const std::vector<Stone>& library) {
  options.validate();
  Random random(options.seed);
  const internal::RandomStones made = internal::random_stones(options, library, random);
  const Vec2 half =
      internal::half_extents(made.area / options.solid_fraction, options.aspect_ratio);
  const Vec2 period = 2 * half;
  return internal::place_stones(
      made, {.thickness = options.thickness, .particles = {}, .period = period}, half, random,
      [period](const internal::PlacementGrid& placed, const ConvexPolygon& cell, const Vec2& at) {
        return internal::is_clear_of_images(placed, cell, at, period);
      });
}

}  // namespace riprap
