// prepare KIND N FILE  makes a packing for the comparison.
//   polygons   of 5 to 8 corners, in shear
//   discs      the same with regular polygons of 16 corners in place of discs
//   breakable  riprap's default, sharp polygons, under pressure, not yet sheared

#include <exception>
#include <iostream>
#include <utility>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/particle/random_assembly.hpp>

#include "sheared.hpp"

namespace peers {
namespace {

// [Pa]. Those that give a sheared sample of each kind about four contacts a grain.
[[nodiscard]] double pressure_of(const std::string& kind) {
  return kind == "polygons" ? 5e6 : kind == "discs" ? 14e6 : 2e6;
}

[[nodiscard]] RandomAssembly sample(const std::string& kind, unsigned count) {
  RandomAssembly options{.count = count, .solid_fraction = 0.5};
  if (kind == "breakable") return options;
  options.shape = {.fewest_vertices = 5, .most_vertices = 8};
  if (kind == "discs")
    options.shape = {.fewest_vertices = 16,
                     .most_vertices = 16,
                     .smallest_axis_ratio = 1,
                     .largest_axis_ratio = 1,
                     .angle_jitter = 0};
  return options;
}

// Brings the grains near each other, without friction, and all over the sample alike: colliding
// grains fall back behind the ring, which leaves a large sample loose inside, so that they get the
// velocity of the field anew time and again.
template <class Sim>
void contract(Sim& sim) {
  constexpr double rate = 9;              // [1/s]
  constexpr double enough = 2e4;          // mean stress [Pa]
  constexpr int between_velocities = 50;  // steps
  const double friction = std::exchange(sim.contact_law().friction, 0);
  sim.boundary().set_rate(rate, rate);
  const auto stress = [&] {
    return average_stress(sim.contacts(), sim.boundary().region(sim.particles()).area(),
                          sim.particles().thickness())
        .mean();
  };
  while (stress() < enough) {
    for (BodyIndex i = 0; i < sim.particles().size(); ++i)
      if (const Body& body = sim.particles().body(i); body.is_free())
        sim.set_velocity(i, -rate * body.position);
    for (int i = 0; i < between_velocities; ++i) sim.step();
  }
  sim.contact_law().friction = friction;
}

[[nodiscard]] Packing prepare(const std::string& kind, unsigned count) {
  const RandomAssembly options = sample(kind, count);
  const double pressure = pressure_of(kind);
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly(options), Rock{}};
  const BiaxialTest test{.confining_pressure = pressure,
                         .axial_strain = kind == "breakable" ? 0 : 0.004,
                         // Slower the larger it is: the ring is to be felt in the middle.
                         .inertial_number = 5e-4 * std::sqrt(500.0 / count),
                         .compaction_inertial_number = 8e-3,
                         .rest_unbalanced_force = 0.05};
  contract(sim);
  const double axial_rate = test.run(sim).axial_rate;

  Packing packing{.mean_diameter = options.mean_diameter,
                  .thickness = options.thickness,
                  .density = sim.rock().density,
                  .stiffness = sim.contact_law().normal_stiffness,
                  .friction = sim.contact_law().friction,
                  .time_step = sim.time_step(),
                  .pressure = pressure,
                  .axial_rate = axial_rate};
  if (kind != "breakable") {
    // On in shear, to find how fast it widens.
    constexpr int steps = 1000;
    Shear shear(sim, pressure, axial_rate);
    for (int i = 0; i < steps; ++i) {
      packing.lateral_rate += shear.steer(sim, sim.time_step()) / steps;
      sim.step();
    }
  }
  packing.coordination = coordination(sim.contacts(), sim.particles()).coordination_number;
  packing.grains = grains(sim);
  const StateNumbers state = state_numbers(sim.contacts(), sim.particles());
  std::cerr << kind << ' ' << count << ": " << packing.coordination << " contacts a grain, overlap "
            << 100 * state.mean_overlap / packing.mean_diameter << " % of the size, " << sim.steps()
            << " steps, widens by " << -packing.lateral_rate / axial_rate << " of the shortening\n";
  return packing;
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
