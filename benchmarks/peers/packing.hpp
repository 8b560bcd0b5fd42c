// SPDX-License-Identifier: BSL-1.0
#pragma once
// A packing as a text file: what every code of the comparison starts from.

#include <fstream>
#include <iomanip>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <riprap/geometry/cut.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/assembly.hpp>

namespace peers {

using namespace riprap;

// Steps of the codes with springs before the clock starts and under it: the same strain for all.
inline constexpr int spring_settling_steps = 500;
inline constexpr int spring_timed_steps = 2000;

// A sample in shear: what it is made of, how it is driven and what riprap found in it. Its ring
// (Motion::strain_field) follows the strain-rate field.
struct Packing {
  double mean_diameter = 0;  // [m]
  double density = 0;        // [kg/m^3]
  double stiffness = 0;      // of a contact, normal and tangential [N/m]
  double friction = 0;       // [-]
  double time_step = 0;      // [s]
  double coordination = 0;   // contacts of a free grain
  double axial_rate = 0;     // shortening along axis 2 [1/s]
  double lateral_rate = 0;   // the same along axis 1; negative: it widens
  Assembly assembly{};

  // Velocity that the field gives a grain of the ring [m/s].
  [[nodiscard]] Vec2 field(const Vec2& x) const {
    return {-lateral_rate * x.x(), -axial_rate * x.y()};
  }
};

[[nodiscard]] inline bool is_free(const PlacedParticle& p) { return p.motion == Motion::free; }
[[nodiscard]] inline Vec2 centroid(const PlacedParticle& p) {
  return area_properties(p.polygon.ring()).centroid;
}

inline void write(const Packing& p, const std::string& path) {
  std::ofstream out(path);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const double value : {p.mean_diameter, p.density, p.stiffness, p.friction, p.time_step,
                             p.coordination, p.axial_rate, p.lateral_rate, p.assembly.thickness})
    out << value << '\n';
  out << p.assembly.particles.size() << '\n';
  for (const PlacedParticle& g : p.assembly.particles) {
    out << is_free(g) << ' ' << g.velocity.x() << ' ' << g.velocity.y() << ' ' << g.angular_velocity
        << ' ' << g.polygon.size();
    for (const Vec2& v : g.polygon) out << ' ' << v.x() << ' ' << v.y();
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

[[nodiscard]] inline Packing read(const std::string& path) {
  std::ifstream in(path);
  Packing p;
  for (double* value : {&p.mean_diameter, &p.density, &p.stiffness, &p.friction, &p.time_step,
                        &p.coordination, &p.axial_rate, &p.lateral_rate, &p.assembly.thickness})
    in >> *value;
  std::size_t count = 0;
  in >> count;
  for (std::size_t i = 0; i < count && in; ++i) {
    bool free = true;
    Vec2 velocity{0, 0};
    double spin = 0;
    std::size_t corners = 0;
    in >> free >> velocity.x() >> velocity.y() >> spin >> corners;
    std::vector<Vec2> ring(in ? corners : 0);
    for (Vec2& v : ring) in >> v.x() >> v.y();
    p.assembly.particles.push_back({.polygon = ConvexPolygon(std::move(ring)),
                                    .motion = free ? Motion::free : Motion::strain_field,
                                    .velocity = velocity,
                                    .angular_velocity = spin});
  }
  if (!in || count == 0) throw std::runtime_error("cannot read " + path);
  return p;
}

// The convex ring with every edge moved in: the core of a polygon whose surface lies `skin`
// outside.
[[nodiscard]] inline std::vector<Vec2> inset(Ring ring, double skin) {
  std::vector<Vec2> core{ring.begin(), ring.end()};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = (ring[(i + 1) % ring.size()] - ring[i]).normalized();
    if (const auto parts = cut(core, Line{ring[i] + skin * perpendicular(along), along}))
      core = parts->left;
  }
  return core;
}

}  // namespace peers
