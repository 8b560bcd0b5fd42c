// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <riprap/measurement/coarse_grained_stress.hpp>

namespace riprap {

namespace internal {

/// Points sorted by the cells of a grid of a given width.
class PointGrid {
 public:
  PointGrid(std::span<const Vec2> points, double width) : width_(width) {
    for (std::size_t k = 0; k < points.size(); ++k)
      entries_.push_back({column(points[k].y()), column(points[k].x()), k});
    std::sort(entries_.begin(), entries_.end());
  }
  /// Calls `visit(k)` for the points of all cells that a box touches.
  template <class Visit>
  void for_each_near(const Vec2& low, const Vec2& high, Visit&& visit) const {
    for (std::int64_t row = column(low.y()); row <= column(high.y()); ++row) {
      const Entry first{row, column(low.x()), 0};
      const std::int64_t last = column(high.x());
      for (auto e = std::lower_bound(entries_.begin(), entries_.end(), first);
           e != entries_.end() && e->row == row && e->column <= last; ++e)
        visit(e->point);
    }
  }

 private:
  struct Entry {
    std::int64_t row;
    std::int64_t column;
    std::size_t point;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  // Far away, where all whole numbers are no longer there, all is one cell.
  [[nodiscard]] std::int64_t column(double x) const {
    constexpr double farthest = 0x1p53;
    return static_cast<std::int64_t>(std::clamp(std::floor(x / width_), -farthest, farthest));
  }

  double width_;
  std::vector<Entry> entries_{};
};

}  // namespace internal

RIPRAP_INLINE std::vector<Stress2> coarse_grained_stresses(std::span<const ForceLine> lines,
                                                           std::span<const Vec2> points,
                                                           const LucyKernel& kernel,
                                                           double thickness) {
  kernel.validate();
  require_positive("coarse_grained_stresses: thickness", thickness);
  for (const Vec2& p : points)
    require_finite("coarse_grained_stresses: coordinate of a point", p.x() + p.y());
  const internal::PointGrid grid(points, kernel.radius);
  std::vector<Stress2> out(points.size());
  const Vec2 reach{kernel.radius, kernel.radius};
  for (const ForceLine& line : lines) {
    require_finite("coarse_grained_stresses: coordinate of a line",
                   line.from.x() + line.from.y() + line.to.x() + line.to.y());
    const Vec2 low = componentwise_min(line.from, line.to) - reach;
    const Vec2 high = componentwise_max(line.from, line.to) + reach;
    grid.for_each_near(low, high, [&](std::size_t k) {
      const double mean = kernel.mean_over(line.from, line.to, points[k]);
      if (mean != 0) out[k] += (mean / thickness) * line.product;
    });
  }
  for (const Stress2& s : out) internal::require_finite_sum(s);
  return out;
}

}  // namespace riprap
