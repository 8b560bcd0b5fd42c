// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <riprap/measurement/rattlers.hpp>

namespace riprap {

namespace internal {

/// Ends of contacts at free bodies, over the number of these.
[[nodiscard]] inline double mean_count(double ends, std::size_t particles) {
  return particles == 0 ? 0 : ends / static_cast<double>(particles);
}

}  // namespace internal

RIPRAP_INLINE std::vector<bool> rattlers(std::span<const LoadedContact> contacts,
                                         const std::vector<bool>& is_free, unsigned fewest) {
  std::vector<std::vector<BodyIndex>> neighbours(is_free.size());
  for (const auto& [a, b] : contacts) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::size_t> left(is_free.size());
  std::vector<bool> removed(is_free.size(), false);
  std::vector<BodyIndex> to_remove;
  const auto check = [&](BodyIndex i) {
    if (!is_free[i] || removed[i] || left[i] >= fewest) return;
    removed[i] = true;
    to_remove.push_back(i);
  };
  for (BodyIndex i = 0; i < is_free.size(); ++i) {
    left[i] = neighbours[i].size();
    check(i);
  }
  while (!to_remove.empty()) {
    const BodyIndex i = to_remove.back();
    to_remove.pop_back();
    for (const BodyIndex j : neighbours[i]) {
      --left[j];
      check(j);
    }
  }
  return removed;
}

RIPRAP_INLINE MechanicalCoordination mechanical_coordination(
    std::span<const LoadedContact> contacts, const std::vector<bool>& is_free, unsigned fewest) {
  const std::vector<bool> is_rattler = rattlers(contacts, is_free, fewest);
  MechanicalCoordination out;
  std::vector<unsigned> counts(is_free.size(), 0);
  double ends = 0;
  double bearing_ends = 0;
  for (const auto& [a, b] : contacts)
    for (const BodyIndex i : {a, b}) {
      ++counts[i];
      if (!is_free[i]) continue;
      ++ends;
      bearing_ends += !is_rattler[a] && !is_rattler[b];
    }
  std::size_t loose = 0;
  double loose_ends = 0;
  for (std::size_t i = 0; i < is_free.size(); ++i) {
    if (!is_free[i]) continue;
    ++out.particles;
    out.rattlers += is_rattler[i];
    if (counts[i] > 1) continue;
    ++loose;
    loose_ends += counts[i];
  }
  out.loaded = internal::mean_count(ends, out.particles);
  out.mechanical = internal::mean_count(ends - loose_ends, out.particles - loose);
  out.rattler_free = internal::mean_count(bearing_ends, out.particles - out.rattlers);
  return out;
}

}  // namespace riprap
