// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bonds of a particle that has broken: handed to its pieces.

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include <riprap/bond/bond.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A particle that has become two pieces, or one and dust.
struct DividedBody {
  Body whole;                                      ///< before it broke
  BodyIndex parent = 0;                            ///< its index
  Line line;                                       ///< the crack, in laboratory coordinates
  std::array<std::optional<BodyIndex>, 2> pieces;  ///< left and right; none: dust
};

/// A part of a bond, and the piece that holds it.
template <class BondType>
struct BondPart {
  BondType bond{};
  std::optional<BodyIndex> piece{};  ///< none: dust
};

namespace internal {

/// The part of a bond's edge from the share `first` to the share `last` of its length, with its
/// displacements and arms. Each of its integration points takes the state of the nearer one of the
/// bond.
template <class BondType>
[[nodiscard]] BondType part_of(const BondType& bond, double first, double last) {
  BondType part = bond;
  part.length = (last - first) * bond.length;
  const auto shorten = [&](const std::array<Vec2, 2>& ends) {
    const Vec2 along = ends[1] - ends[0];
    return std::array{ends[0] + first * along, ends[0] + last * along};
  };
  part.on_a.ends = shorten(bond.on_a.ends);
  part.on_b.ends = shorten(bond.on_b.ends);
  const auto& points = bond.view.points;
  const auto displacement = [&](double share) {
    return BondDisplacement{at_share(std::array{points[0].opening, points[1].opening}, share),
                            at_share(std::array{points[0].sliding, points[1].sliding}, share)};
  };
  part.view.ends = {displacement(first), displacement(last)};
  for (std::size_t g = 0; g < 2; ++g) {
    const double place = at_point(std::array{first, last}, g);
    part.view.points[g] = displacement(place);
    part.view.states[g] = bond.view.states[place < 0.5 ? 0 : 1];
    part.arms_a[g] = at_share(bond.arms_a, place);
    part.arms_b[g] = at_share(bond.arms_b, place);
  }
  return part;
}

/// Gives the side of the parent to a piece.
template <class BondType>
void hand_to_piece(BondType& bond, const DividedBody& broken, BodyIndex piece, const Body& body) {
  BondedEdge& edge = bond.a == broken.parent ? bond.on_a : bond.on_b;
  for (Vec2& end : edge.ends)
    end = body.rotation.inverse_times(broken.whole.position + broken.whole.rotation * end -
                                      body.position);
  edge.normal = body.rotation.inverse_times(broken.whole.rotation * edge.normal);
  (bond.a == broken.parent ? bond.a : bond.b) = piece;
  if (bond.a < bond.b) return;
  std::swap(bond.a, bond.b);
  std::swap(bond.on_a, bond.on_b);
  std::swap(bond.material_a, bond.material_b);
  bond.on_a.normal = -bond.on_a.normal;
  bond.on_b.normal = -bond.on_b.normal;
  if constexpr (requires { -bond.image; }) bond.image = -bond.image;
}

}  // namespace internal

/// The parts of a bond of a particle that has broken, one or two, each with the piece that holds
/// its part of the edge. An edge that the crack crosses is divided there, in both bodies; a part
/// shorter than 1e-6 of the edge goes with the other one.
template <class BondType>
[[nodiscard]] std::array<std::optional<BondPart<BondType>>, 2>
divided(const BondType& bond, const DividedBody& broken, const Particles& particles) {
  const BondedEdge& edge = bond.a == broken.parent ? bond.on_a : bond.on_b;
  std::array<double, 2> left{};  // distances of the ends from the crack [m]
  for (std::size_t k = 0; k < 2; ++k)
    left[k] =
        broken.line.left_distance(broken.whole.position + broken.whole.rotation * edge.ends[k]);
  constexpr double shortest = 1e-6;
  const double share = (left[0] < 0) == (left[1] < 0) ? 0 : left[0] / (left[0] - left[1]);
  std::array<std::optional<BondPart<BondType>>, 2> parts;
  const auto add = [&](std::size_t n, double first, double last) {
    const bool on_right =
        left[0] * (1 - first) + left[1] * first + (left[0] * (1 - last) + left[1] * last) < 0;
    const std::optional<BodyIndex> piece = broken.pieces[on_right ? 1 : 0];
    const bool is_whole = first == 0 && last == 1;
    parts[n] = {is_whole ? bond : internal::part_of(bond, first, last), piece};
    if (piece) internal::hand_to_piece(parts[n]->bond, broken, *piece, particles.body(*piece));
  };
  if (share < shortest || share > 1 - shortest) {
    add(0, 0, 1);
  } else {
    add(0, 0, share);
    add(1, share, 1);
  }
  return parts;
}

}  // namespace riprap
