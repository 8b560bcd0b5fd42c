// SPDX-License-Identifier: BSL-1.0
#include "shear_bands.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include <riprap/core/errors.hpp>

namespace study {

namespace {

using riprap::Vec2;

constexpr std::size_t neighbours = 12;

struct Displaced {
  Vec2 from;
  Vec2 by;
};

// Nearest first, itself the very first.
std::vector<Displaced> nearest(const std::vector<Displaced>& all, const Vec2& place) {
  std::vector<Displaced> out = all;
  const std::size_t count = std::min(out.size(), neighbours + 1);
  const auto closer = [&](const Displaced& a, const Displaced& b) {
    return (a.from - place).squaredNorm() < (b.from - place).squaredNorm();
  };
  std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), out.end(),
                    closer);
  out.resize(count);
  return out;
}

// By least squares about the mean; 0 where the particles stand in a line.
double maximum_shear(const std::vector<Displaced>& group) {
  Vec2 from{0, 0};
  Vec2 by{0, 0};
  for (const Displaced& d : group) {
    from += d.from / static_cast<double>(group.size());
    by += d.by / static_cast<double>(group.size());
  }
  Eigen::Matrix2d places = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d movements = Eigen::Matrix2d::Zero();
  for (const Displaced& d : group) {
    places += (d.from - from) * (d.from - from).transpose();
    movements += (d.by - by) * (d.from - from).transpose();
  }
  if (places.determinant() <= 1e-12 * places.squaredNorm()) return 0;
  const Eigen::Matrix2d gradient = movements * places.inverse();
  return std::hypot(gradient(0, 0) - gradient(1, 1), gradient(0, 1) + gradient(1, 0)) / 2;
}

}  // namespace

std::vector<Sheared> shear_around(const std::vector<riprap::Move>& moves, const Vec2& stretch) {
  std::vector<Displaced> free;
  for (const riprap::Move& move : moves)
    if (move.is_free) free.push_back({move.from, move.to - move.from});
  std::vector<Sheared> out;
  for (const Displaced& d : free)
    out.push_back({d.from.cwiseQuotient(stretch), maximum_shear(nearest(free, d.from))});
  return out;
}

double band_share(const std::vector<Sheared>& all, const Vec2& place) {
  riprap::require(!all.empty(), "number of free particles", 0, "must be above 0");
  const auto here =
      std::min_element(all.begin(), all.end(), [&](const Sheared& a, const Sheared& b) {
        return (a.place - place).squaredNorm() < (b.place - place).squaredNorm();
      });
  const auto less = std::count_if(all.begin(), all.end(),
                                  [&](const Sheared& s) { return s.shear < here->shear; });
  return static_cast<double>(less) / static_cast<double>(all.size());
}

}  // namespace study
