#pragma once
// A packing as a text file: what every code of the comparison starts from.

#include <fstream>
#include <iomanip>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace peers {

using namespace riprap;

struct Grain {
  bool free = true;  // false: on the ring, which follows the strain-rate field
  Vec2 velocity{0, 0};
  double spin = 0;
  std::vector<Vec2> ring;  // laboratory coordinates [m]
};

// A sample in shear: what it is made of, how it is driven and what riprap found in it.
struct Packing {
  double mean_diameter = 0;  // [m]
  double thickness = 0;      // [m]
  double density = 0;        // [kg/m^3]
  double stiffness = 0;      // of a contact, normal and tangential [N/m]
  double friction = 0;       // [-]
  double time_step = 0;      // [s]
  double pressure = 0;       // [Pa]
  double coordination = 0;   // contacts of a free grain
  double axial_rate = 0;     // shortening along axis 2 [1/s]
  double lateral_rate = 0;   // the mean one along axis 1 [1/s], negative: it widens
  std::vector<Grain> grains{};

  // Velocity that the field gives a grain of the ring [m/s].
  [[nodiscard]] Vec2 field(const Vec2& x) const {
    return {-lateral_rate * x.x(), -axial_rate * x.y()};
  }
};

inline void write(const Packing& p, const std::string& path) {
  std::ofstream out(path);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const double value : {p.mean_diameter, p.thickness, p.density, p.stiffness, p.friction,
                             p.time_step, p.pressure, p.coordination, p.axial_rate, p.lateral_rate})
    out << value << '\n';
  out << p.grains.size() << '\n';
  for (const Grain& g : p.grains) {
    out << g.free << ' ' << g.velocity.x() << ' ' << g.velocity.y() << ' ' << g.spin << ' '
        << g.ring.size();
    for (const Vec2& v : g.ring) out << ' ' << v.x() << ' ' << v.y();
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

[[nodiscard]] inline Packing read(const std::string& path) {
  std::ifstream in(path);
  Packing p;
  for (double* value : {&p.mean_diameter, &p.thickness, &p.density, &p.stiffness, &p.friction,
                        &p.time_step, &p.pressure, &p.coordination, &p.axial_rate, &p.lateral_rate})
    in >> *value;
  std::size_t count = 0;
  in >> count;
  for (std::size_t i = 0; i < count && in; ++i) {
    Grain g;
    std::size_t corners = 0;
    in >> g.free >> g.velocity.x() >> g.velocity.y() >> g.spin >> corners;
    for (std::size_t k = 0; k < corners && in; ++k) {
      Vec2 v{0, 0};
      in >> v.x() >> v.y();
      g.ring.push_back(v);
    }
    p.grains.push_back(std::move(g));
  }
  if (!in || p.grains.empty()) throw std::runtime_error("cannot read " + path);
  return p;
}

// The convex ring with every edge moved in: the core of a polygon whose surface lies `skin`
// outside.
[[nodiscard]] inline std::vector<Vec2> inset(const std::vector<Vec2>& ring, double skin) {
  std::vector<Vec2> core = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = (ring[(i + 1) % ring.size()] - ring[i]).normalized();
    if (const auto parts = cut(core, Line{ring[i] + skin * perpendicular(along), along}))
      core = parts->left;
  }
  return core;
}

}  // namespace peers
