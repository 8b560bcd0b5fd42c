// SPDX-License-Identifier: BSL-1.0
#include "shear_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace report {

namespace {

using Particles = std::vector<ShearedParticle>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Particles most_sheared_tenth(Particles all) {
  std::stable_sort(all.begin(), all.end(), [](const ShearedParticle& a, const ShearedParticle& b) {
    return a.shear > b.shear;
  });
  all.resize((all.size() + 9) / 10);
  return all;
}

// Distance of neighbours if the particles filled the ellipse that has their second moments.
double mean_spacing(const Particles& all) {
  riprap::Vec2 squares{0, 0};
  for (const ShearedParticle& p : all) squares += p.place.cwiseAbs2();
  const riprap::Vec2 semi_axes = 2 * (squares / static_cast<double>(all.size())).cwiseSqrt();
  return std::sqrt(std::numbers::pi * semi_axes.prod() / static_cast<double>(all.size()));
}

bool is_in_range(const riprap::Vec2& from_to) {
  constexpr double degree = std::numbers::pi / 180;
  const double angle = std::atan2(std::abs(from_to.y()), std::abs(from_to.x()));
  return std::abs(angle - 54 * degree) <= 22.5 * degree;
}

double share_in_range(const Particles& particles, double nearest, double farthest) {
  double in_range = 0;
  double all = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t k = i + 1; k < particles.size(); ++k) {
      const riprap::Vec2 from_to = particles[k].place - particles[i].place;
      const double distance = from_to.norm();
      if (distance < nearest || distance > farthest) continue;
      ++all;
      in_range += is_in_range(from_to);
    }
  return all > 0 ? in_range / all : none;
}

}  // namespace

double radius_of_bands(const ShearWindow& window) {
  const Particles tenth = most_sheared_tenth(window.particles);
  double sum = 0;
  for (const ShearedParticle& p : tenth) sum += p.unstrained.norm();
  return tenth.empty() ? none : sum / static_cast<double>(tenth.size());
}

double band_direction_excess(const ShearWindow& window, double nearest, double farthest) {
  if (window.particles.empty()) return none;
  const double spacing = mean_spacing(window.particles);
  const auto share = [&](const Particles& particles) {
    return share_in_range(particles, nearest * spacing, farthest * spacing);
  };
  return share(most_sheared_tenth(window.particles)) - share(window.particles);
}

}  // namespace report
