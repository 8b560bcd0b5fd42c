// SPDX-License-Identifier: BSL-1.0
// heap: a column of particles collapses under gravity; the slope with and without friction
// Dashpots in the contacts dissipate the energy; there is no other damping.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <riprap/measurement/regression_line.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

constexpr double d = 0.016;         // diameter of all particles [m]
constexpr double half_width = 0.6;  // of the floor [m]
constexpr double degree = std::numbers::pi / 180;

/// A floor between two walls, and above it 16 rows of 12 random polygons.
Assembly column() {
  const double w = half_width;
  const ConvexPolygon floor{{-w, -0.02}, {w, -0.02}, {w, 0}, {-w, 0}};
  const ConvexPolygon wall{{w, -0.02}, {w + 0.02, -0.02}, {w + 0.02, 0.15}, {w, 0.15}};
  Assembly assembly{.particles = {{floor, Motion::prescribed},
                                  {wall, Motion::prescribed},
                                  {wall.moved({}, {-2 * w - 0.02, 0}), Motion::prescribed}}};
  Random random(1);
  const double spacing = 1.7 * d;  // no two polygons meet, however they are turned
  for (int row = 0; row < 16; ++row)
    for (int i = 0; i < 12; ++i) {
      const ConvexPolygon polygon =
          random_polygon({.fewest_vertices = 4, .most_vertices = 6}, d, random);
      assembly.particles.push_back({polygon.moved({}, spacing * Vec2{i - 5.5, row + 0.5})});
    }
  return assembly;
}

/// Slope of both sides of a heap [rad]: a line through the highest vertices of strips of one
/// diameter, from the summit to where the heap is less than one diameter high.
double slope(const Particles& particles) {
  std::vector<Vec2> surface;  // distance from the middle, height [m]
  for (const double side : {-1.0, 1.0})
    for (double x = 0.5 * d; x < half_width - d; x += d) {
      double height = 0;
      for (BodyIndex i = 3; i < particles.size(); ++i)
        for (const Vec2& v : particles.ring(i))
          if (std::abs(side * v.x() - x) < 0.5 * d) height = std::max(height, v.y());
      if (height < d) break;
      surface.push_back({x, height});
    }
  return std::atan(-regression_line(surface).slope);
}

double heap(double friction, const char* picture) {
  const SpringDashpot law{.normal_stiffness = 1e5,
                          .tangential_stiffness = 1e5,
                          .friction = friction,
                          .damping_ratio = 0.4};
  Simulation sim{Model{}.contact_law(law).damping(NoDamping{}).criterion(NeverFails{}), column(),
                 Rock{}};
  sim.set_body_force({0, -9.81});
  while (sim.time() < 2) sim.step();
  const double angle = slope(sim.particles());
  char title[80];
  std::snprintf(title, sizeof title, "Friction %.1f: slope of %.1f degrees", friction,
                angle / degree);
  std::printf("%s, picture in %s\n", title, picture);
  assembly_picture(sim.particles(), {}, title).save(picture);
  return angle;
}

int main() {
  const double rough = heap(0.5, "heap_rough.svg");
  const double smooth = heap(0, "heap_smooth.svg");
  std::printf("angle of friction of a contact, atan 0.5: %.1f degrees\n", std::atan(0.5) / degree);
  // Without friction the surface is level, to a diameter over the width of the floor.
  return std::abs(smooth) <= d / half_width && rough > d / half_width ? 0 : 1;
}
