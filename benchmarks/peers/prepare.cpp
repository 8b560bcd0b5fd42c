// SPDX-License-Identifier: BSL-1.0
// prepare KIND N FILE  makes a packing for the comparison.
//   polygons   of 5 to 8 corners, in early shear
//   discs      the same with regular polygons of 16 corners in place of discs
//   breakable  riprap's default, sharp polygons, under pressure, not yet sheared

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <numbers>
#include <utility>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/particle/spatial_order.hpp>
#include <riprap/simulation/simulation.hpp>

#include "packing.hpp"

namespace peers {
namespace {

// All bodies of a simulation, `offset` away, where the strain-rate field adds its own velocity.
void append(Assembly& out, const auto& sim, const Vec2& offset = {0, 0},
            const Vec2& rate = {0, 0}) {
  const Particles& particles = sim.particles();
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    const Ring ring = particles.ring(i);
    out.particles.push_back({.polygon = ConvexPolygon({ring.begin(), ring.end()}).moved({}, offset),
                             .motion = body.motion,
                             .velocity = body.velocity - rate.cwiseProduct(offset),
                             .angular_velocity = body.angular_velocity});
  }
}

// The `count` bodies nearest to the origin in a periodic plane. The outermost, as far in as a mean
// diameter, are the ring.
[[nodiscard]] Assembly round_sample(const auto& sim, const Packing& packing, unsigned count) {
  const Vec2 rate{packing.lateral_rate, packing.axial_rate};
  const Vec2 period = sim.boundary().domain().period;
  const double cells = count / static_cast<double>(sim.particles().size());
  const int reach = static_cast<int>(std::ceil(std::sqrt(cells / std::numbers::pi)));
  Assembly out{.thickness = sim.particles().thickness(), .particles = {}};
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) append(out, sim, period.cwiseProduct(Vec2{i, j}), rate);

  const auto distance = [](const PlacedParticle& p) { return centroid(p).norm(); };
  std::ranges::sort(out.particles, {}, distance);
  out.particles.erase(out.particles.begin() + count, out.particles.end());
  const double inside = distance(out.particles.back()) - packing.mean_diameter;
  for (PlacedParticle& p : out.particles)
    if (distance(p) > inside)
      p = {.polygon = p.polygon,
           .motion = Motion::strain_field,
           .velocity = -rate.cwiseProduct(centroid(p))};
  sort_by_morton_code(out.particles);
  return out;
}

// An observer: logarithmic strain at the last two records of a test.
struct LastStrains {
  Vec2 before{0, 0};
  Vec2 last{0, 0};

  void record(const auto& view) {
    before = std::exchange(last, {std::log(view.stretch.x()), std::log(view.stretch.y())});
  }
  // Rate along axis 1 over that along axis 2.
  [[nodiscard]] double ratio() const { return (last - before).x() / (last - before).y(); }
};

[[nodiscard]] Packing test_packing(auto& sim, const RandomAssembly& options,
                                   const BiaxialTest& test) {
  LastStrains strains;
  const double axial_rate = test.run(sim, strains).axial_rate;
  const StateAverages state = state_averages(sim.contacts(), sim.particles());
  const double contacts = coordination(sim.contacts(), sim.particles()).coordination_number;
  std::cerr << sim.particles().size() << " grains: " << contacts << " contacts a grain, overlap "
            << 100 * state.mean_overlap / options.mean_diameter << " % of the size, " << sim.steps()
            << " steps\n";
  return {.mean_diameter = options.mean_diameter,
          .density = sim.rock().density,
          .stiffness = sim.contact_law().normal_stiffness,
          .friction = sim.contact_law().friction,
          .time_step = sim.time_step(),
          .coordination = contacts,
          .axial_rate = axial_rate,
          .lateral_rate = test.axial_strain > 0 ? axial_rate * strains.ratio() : 0};
}

// Cut from one periodic sample whatever the count, so that samples of any size are alike.
[[nodiscard]] Packing in_shear(unsigned count, const PolygonShape& shape, double pressure) {
  const RandomAssembly options{.count = 500, .shape = shape};
  Simulation sim{Model{}.boundary(PeriodicCell{}).criterion(NeverFails{}),
                 random_periodic_assembly(options), Rock{}};
  Packing packing = test_packing(
      sim, options,
      {.confining_pressure = pressure, .axial_strain = 0.005, .rest_unbalanced_force = 0.1});
  packing.assembly = round_sample(sim, packing, count);
  return packing;
}

[[nodiscard]] Packing breakable(unsigned count) {
  const RandomAssembly options{.count = count};
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly(options), Rock{}};
  Packing packing = test_packing(sim, options, {.axial_strain = 0, .rest_unbalanced_force = 0.05});
  packing.assembly.thickness = options.thickness;
  append(packing.assembly, sim);
  return packing;
}

// Pressures [Pa] are those that give about four contacts a grain.
[[nodiscard]] Packing prepare(const std::string& kind, unsigned count) {
  if (kind == "polygons") return in_shear(count, {.fewest_vertices = 5, .most_vertices = 8}, 2e6);
  if (kind == "discs")
    return in_shear(count,
                    {.fewest_vertices = 16,
                     .most_vertices = 16,
                     .smallest_axis_ratio = 1,
                     .largest_axis_ratio = 1,
                     .angle_jitter = 0},
                    5e6);
  if (kind == "breakable") return breakable(count);
  throw std::runtime_error("no packing is called " + kind);
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("prepare KIND N FILE");
  const auto grains = static_cast<unsigned>(std::stoul(arguments[2]));
  peers::write(peers::prepare(arguments[1], grains), arguments[3]);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
