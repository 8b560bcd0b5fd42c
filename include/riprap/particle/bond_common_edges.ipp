// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

namespace internal {

/// A particle, or an image of it, with its bounding box.
struct BondCandidate {
  std::size_t place = 0;
  PeriodicDomain::Image image{};
  Vec2 low{0, 0};
  Vec2 high{0, 0};
};

/// The segment that edge p of one ring and edge q of another have in common, half-way between the
/// two; none if they are not opposite edges on one line within `tolerance` [m].
[[nodiscard]] inline std::optional<std::array<Vec2, 2>>
common_segment(const std::array<Vec2, 2>& p, const std::array<Vec2, 2>& q, double tolerance) {
  const Vec2 edge = p[1] - p[0];
  const double length = edge.norm();
  const Vec2 along = edge / length;
  if (along.dot(q[1] - q[0]) >= 0) return std::nullopt;
  const std::array away{cross(along, q[0] - p[0]), cross(along, q[1] - p[0])};
  if (std::abs(away[0]) > tolerance || std::abs(away[1]) > tolerance) return std::nullopt;
  const double first = std::max(0.0, along.dot(q[1] - p[0]));
  const double last = std::min(length, along.dot(q[0] - p[0]));
  if (last - first <= tolerance) return std::nullopt;
  const Vec2 half_way = 0.25 * (away[0] + away[1]) * perpendicular(along);
  return std::array{p[0] + first * along + half_way, p[0] + last * along + half_way};
}

/// Half of the images around a cell: the other half has the same pairs.
[[nodiscard]] inline std::array<PeriodicDomain::Image, 4>
half_of_images(const PeriodicDomain& domain) {
  // Of those one period up axis 2, the three that lie nearest.
  const int above = -static_cast<int>(std::lround(domain.shear_offset / domain.period.x()));
  return {{{1, 0}, {above - 1, 1}, {above, 1}, {above + 1, 1}}};
}

[[nodiscard]] inline std::vector<BondCandidate>
bond_candidates(const Assembly& assembly, std::span<const std::size_t> particles) {
  const bool periodic = assembly.period != Vec2{0, 0};
  const PeriodicDomain domain{.period = assembly.period, .shear_offset = assembly.shear_offset};
  std::vector<BondCandidate> all;
  for (const std::size_t place : particles) {
    require(place < assembly.particles.size(), "bond_common_edges: particle",
            static_cast<double>(place), "must be in the assembly");
    const Ring ring = assembly.particles[place].polygon.ring();
    BondCandidate one{.place = place, .low = ring[0], .high = ring[0]};
    for (const Vec2& v : ring) {
      one.low = componentwise_min(one.low, v);
      one.high = componentwise_max(one.high, v);
    }
    all.push_back(one);
    if (!periodic) continue;
    for (const PeriodicDomain::Image& image : half_of_images(domain)) {
      const Vec2 offset = domain.offset(image);
      all.push_back({place, image, one.low + offset, one.high + offset});
    }
  }
  std::sort(all.begin(), all.end(), [](const BondCandidate& p, const BondCandidate& q) {
    return std::tuple(p.low.x(), p.place, p.image) < std::tuple(q.low.x(), q.place, q.image);
  });
  return all;
}

/// Adds the bonds of particle p with an image of particle q.
inline void add_bonds(const Assembly& assembly, std::size_t p, std::size_t q,
                      const PeriodicDomain::Image& image, double tolerance,
                      std::vector<PlacedBond>& bonds) {
  const PeriodicDomain domain{.period = assembly.period, .shear_offset = assembly.shear_offset};
  const Vec2 offset = domain.offset(image);
  const Ring ring_p = assembly.particles[p].polygon.ring();
  const Ring ring_q = assembly.particles[q].polygon.ring();
  const auto size = [](Ring ring) {
    double largest = 0;
    for (const Vec2& v : ring) largest = std::max(largest, (v - ring[0]).norm());
    return 0.5 * largest;
  };
  const double near = tolerance * std::min(size(ring_p), size(ring_q));
  for (std::size_t i = 0; i < ring_p.size(); ++i)
    for (std::size_t j = 0; j < ring_q.size(); ++j) {
      const auto common =
          common_segment({ring_p[i], ring_p[(i + 1) % ring_p.size()]},
                         {ring_q[j] + offset, ring_q[(j + 1) % ring_q.size()] + offset}, near);
      if (common) bonds.push_back({p, q, *common, image});
    }
}

}  // namespace internal

RIPRAP_INLINE std::size_t
bond_common_edges(Assembly& assembly, std::span<const std::size_t> particles, double tolerance) {
  require(tolerance > 0 && tolerance < 0.1, "bond_common_edges: tolerance", tolerance,
          "must be above 0 and below 0.1");
  const std::vector<internal::BondCandidate> all = internal::bond_candidates(assembly, particles);
  std::vector<PlacedBond> bonds;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2 size = all[i].high - all[i].low;
    const double margin = tolerance * (size.x() + size.y());
    for (std::size_t j = i + 1; j < all.size() && all[j].low.x() <= all[i].high.x() + margin; ++j) {
      const internal::BondCandidate* p = &all[i];
      const internal::BondCandidate* q = &all[j];
      if (p->place == q->place || p->low.y() > q->high.y() + margin ||
          q->low.y() > p->high.y() + margin)
        continue;
      const PeriodicDomain::Image none{};
      if (p->image != none && q->image != none) continue;
      if (p->image != none || (q->image == none && q->place < p->place)) std::swap(p, q);
      internal::add_bonds(assembly, p->place, q->place, q->image, tolerance, bonds);
    }
  }
  std::stable_sort(bonds.begin(), bonds.end(), [](const PlacedBond& p, const PlacedBond& q) {
    return std::tuple(p.a, p.b, p.image) < std::tuple(q.a, q.b, q.image);
  });
  const auto of = [](const PlacedBond& b) { return std::tuple(b.a, b.b, b.image); };
  for (const PlacedBond& known : assembly.bonds)
    if (std::ranges::binary_search(bonds, of(known), {}, of))
      throw InvalidInput("bond_common_edges: particles " + std::to_string(known.a) + " and " +
                         std::to_string(known.b) + " are bonded already");
  assembly.bonds.insert(assembly.bonds.end(), bonds.begin(), bonds.end());
  return bonds.size();
}

RIPRAP_INLINE std::size_t bond_common_edges(Assembly& assembly, double tolerance) {
  std::vector<std::size_t> all(assembly.particles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return bond_common_edges(assembly, all, tolerance);
}

}  // namespace riprap
