// SPDX-License-Identifier: BSL-1.0
#include "closed_forms.hpp"

#include <cmath>
#include <numbers>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/core/stress2.hpp>

#include "strength.hpp"

namespace convergence {

using namespace riprap;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double thickness = 0.016;  // [m]

Stress2 disc_stress(double radius, const Vec2& x) {
  const double unit = 1 / (pi * radius * thickness);
  Stress2 sum{-unit, -unit, 0};
  for (const double side : {1.0, -1.0}) {
    const Vec2 d = x - Vec2{0, side * radius};
    const double r2 = d.squaredNorm();
    const double f = 2 / (pi * thickness) * (-side * d.y()) / (r2 * r2);
    sum += f * Stress2{d.x() * d.x(), d.y() * d.y(), d.x() * d.y()};
  }
  return sum;
}

}  // namespace

KnownStrength disc_between_forces() {
  constexpr double radius = 0.008;
  LoadedParticle disc;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * pi * i / 64;
    disc.ring.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  disc.forces = {{{0, radius}, {0, -1}}, {{0, -radius}, {0, 1}}};

  // A quarter of the disc in equal areas; the rest is its mirror image.
  constexpr int rings = 400;
  constexpr int sectors = 400;
  ElementStress stress;
  stress.reset(std::size_t{rings} * sectors);
  std::size_t point = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double r = radius * std::sqrt((i + 0.5) / rings);
      const double angle = 0.5 * pi * (j + 0.5) / sectors;
      stress.set(point++, disc_stress(radius, r * Vec2{std::cos(angle), std::sin(angle)}));
    }
  const std::vector<double> areas(point, 1);
  return {{thickness, pi * radius * radius, {disc}},
          critical_load(HoekBrown{}, stress, areas, 0.4)};
}

KnownStrength bent_bar() {
  constexpr double half_length = 0.024;
  constexpr double half_height = 0.008;
  LoadedParticle bar;
  bar.ring = {{-half_length, -half_height},
              {half_length, -half_height},
              {half_length, half_height},
              {-half_length, half_height}};
  // Forces in the Gauss points of short parts of the ends, where stress along the bar is M y / I.
  constexpr int parts = 240;
  const double second_moment = thickness * std::pow(2 * half_height, 3) / 12;
  const double part = 2 * half_height / parts;
  for (int i = 0; i < parts; ++i)
    for (const double gauss : {-0.5 / std::numbers::sqrt3, 0.5 / std::numbers::sqrt3}) {
      const double y = -half_height + part * (i + 0.5 + gauss);
      const double force = y / second_moment * 0.5 * part * thickness;
      for (const double side : {-1.0, 1.0})
        bar.forces.push_back({{side * half_length, y}, {side * force, 0}});
    }
  // (1 - sigma_t / sigma) / 2 = 0.4, with sigma = M half_height / I at the edge. In uniaxial
  // tension sigma_1f(-sigma_t) = 0 is reached first (Hoek and Brown 1980).
  const HoekBrown rock;
  const double tensile_strength =
      0.5 * rock.compressive_strength * (std::sqrt(rock.m_b * rock.m_b + 4 * rock.s) - rock.m_b);
  const double edge_stress = 5 * tensile_strength;
  return {{thickness, 4 * half_length * half_height, {bar}},
          edge_stress * second_moment / half_height};
}

}  // namespace convergence
