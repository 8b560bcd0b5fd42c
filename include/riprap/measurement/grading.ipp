// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <riprap/measurement/grading.hpp>

namespace riprap {

RIPRAP_INLINE Grading Grading::of_fractions(std::vector<SizeFraction> fractions) {
  for (const SizeFraction& f : fractions) {
    require_positive("SizeFraction.size", f.size);
    require_non_negative("SizeFraction.mass", f.mass);
  }
  std::sort(fractions.begin(), fractions.end(), [](const auto& p, const auto& q) {
    return std::pair(p.size, p.mass) < std::pair(q.size, q.mass);
  });
  double total = 0;
  for (const SizeFraction& f : fractions) total += f.mass;
  require_positive("Grading: mass of all fractions", total);
  Grading grading;
  double finer = 0;
  for (const SizeFraction& f : fractions) {
    grading.points_.push_back({f.size, finer / total});
    finer += f.mass;
    grading.points_.push_back({f.size, finer / total});
  }
  return grading;
}

RIPRAP_INLINE Grading Grading::of_sieves(std::vector<GradingPoint> points) {
  GradingPoint before;
  for (const GradingPoint& p : points) {
    require_positive("GradingPoint.size", p.size);
    require(p.size >= before.size, "GradingPoint.size", p.size, "must not descend");
    require(p.passing >= before.passing && p.passing <= 1, "GradingPoint.passing", p.passing,
            "must lie in [0, 1] and not descend");
    before = p;
  }
  require(before.passing == 1, "GradingPoint.passing of the last point", before.passing,
          "must be 1");
  Grading grading;
  grading.points_ = std::move(points);
  return grading;
}

RIPRAP_INLINE double Grading::passing(double size) const {
  const auto next = std::upper_bound(points_.begin(), points_.end(), size,
                                     [](double s, const GradingPoint& p) { return s < p.size; });
  if (next == points_.begin()) return 0;
  const GradingPoint& p = *(next - 1);
  if (next == points_.end()) return 1;
  return p.passing +
         (next->passing - p.passing) * std::log(size / p.size) / std::log(next->size / p.size);
}

RIPRAP_INLINE double Grading::size_at(double share) const {
  require(share > 0 && share <= 1, "share that passes", share, "must lie in (0, 1]");
  const auto next = std::lower_bound(points_.begin(), points_.end(), share,
                                     [](const GradingPoint& p, double s) { return p.passing < s; });
  if (next == points_.begin()) return next->size;
  const GradingPoint& p = *(next - 1);
  return p.size * std::pow(next->size / p.size, (share - p.passing) / (next->passing - p.passing));
}

RIPRAP_INLINE double Grading::area_above(double limit) const {
  require_positive("lower limit of size", limit);
  double area = 0;
  double before = 0;
  double from = std::log10(points_.front().size / limit);
  for (const GradingPoint& p : points_) {
    const double to = std::log10(p.size / limit);
    const double share = p.passing - before;
    if (from >= 0)
      area += share * 0.5 * (from + to);
    else if (to > 0)
      area += share * 0.5 * to * to / (to - from);
    before = p.passing;
    from = to;
  }
  return area;
}

namespace internal {

// Free bodies and dust of the materials of which `counts(material)`: root, area and mass, this over
// that of the unit of area of a reference material.
template <class Counts, class Add>
void visit_grains(const Particles& particles, MaterialIndex reference, Counts&& counts, Add&& add) {
  const auto grain = [&](ParticleId root, MaterialIndex material, double area) {
    if (counts(material)) add(root, area, area * particles.density_ratio(material, reference));
  };
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free())
      grain(particles.ancestry(i).root, particles.material(i), particles.shape(i).area);
  for (const DustPiece& piece : particles.dust()) grain(piece.root, piece.material, piece.area);
}

template <class Counts>
[[nodiscard]] Grading grading_of(const Particles& particles, MaterialIndex reference,
                                 Counts&& counts) {
  std::vector<SizeFraction> fractions;
  visit_grains(particles, reference, counts, [&](ParticleId, double area, double mass) {
    fractions.push_back({equivalent_diameter(area), mass});
  });
  return Grading::of_fractions(std::move(fractions));
}

template <class Counts>
[[nodiscard]] Grading grading_before(const Particles& particles, MaterialIndex reference,
                                     Counts&& counts) {
  struct Root {
    double area = 0;
    double mass = 0;
  };
  std::map<ParticleId, Root> roots;
  visit_grains(particles, reference, counts, [&](ParticleId id, double area, double mass) {
    roots[id].area += area;
    roots[id].mass += mass;
  });
  std::vector<SizeFraction> fractions;
  for (const auto& [id, root] : roots)
    fractions.push_back({equivalent_diameter(root.area), root.mass});
  return Grading::of_fractions(std::move(fractions));
}

}  // namespace internal

RIPRAP_INLINE Grading grading(const Particles& particles) {
  return internal::grading_of(particles, 0, [](MaterialIndex) { return true; });
}

RIPRAP_INLINE Grading grading_before_breakage(const Particles& particles) {
  return internal::grading_before(particles, 0, [](MaterialIndex) { return true; });
}

RIPRAP_INLINE Grading grading(const Particles& particles, MaterialIndex material) {
  return internal::grading_of(particles, material, [=](MaterialIndex m) { return m == material; });
}

RIPRAP_INLINE Grading grading_before_breakage(const Particles& particles, MaterialIndex material) {
  return internal::grading_before(particles, material,
                                  [=](MaterialIndex m) { return m == material; });
}

}  // namespace riprap
