#pragma once
// riprap's own side of the comparison: packings into simulations and back, and the servo of shear.

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/simulation/simulation.hpp>

#include "packing.hpp"

namespace peers {

// The packing as it lies, moving as it moved; tangential springs begin anew.
[[nodiscard]] inline Assembly assembly(const Packing& packing) {
  Assembly out{.thickness = packing.thickness, .particles = {}};
  for (const Grain& g : packing.grains)
    out.particles.push_back({.polygon = ConvexPolygon(g.ring),
                             .motion = g.free ? Motion::free : Motion::strain_field,
                             .velocity = g.velocity,
                             .angular_velocity = g.spin});
  return out;
}

template <class Sim>
[[nodiscard]] std::vector<Grain> grains(const Sim& sim) {
  std::vector<Grain> out;
  const Particles& particles = sim.particles();
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    const Ring ring = particles.ring(i);
    out.push_back({.free = body.is_free(),
                   .velocity = body.velocity,
                   .spin = body.angular_velocity,
                   .ring = {ring.begin(), ring.end()}});
  }
  return out;
}

// Shortens axis 2 at a constant rate and holds the stress along axis 1, as in the test.
class Shear {
 public:
  template <class Sim>
  Shear(const Sim& sim, double pressure, double axial_rate)
      : pressure_(pressure), axial_rate_(axial_rate),
        servo_(stiffness(sim), response(sim), 10 * axial_rate) {}

  // After `time` [s]; returns the rate along axis 1.
  template <class Sim>
  double steer(Sim& sim, double time) {
    const double area = sim.boundary().region(sim.particles()).area();
    const double stress = average_stress(sim.contacts(), area, sim.particles().thickness()).s11;
    const double lateral_rate = servo_.rate(pressure_ - stress, time);
    sim.boundary().set_rate(lateral_rate, axial_rate_);
    return lateral_rate;
  }

 private:
  template <class Sim>
  [[nodiscard]] static double stiffness(const Sim& sim) {
    return 0.5 * sim.contacts().law().peak_stiffness() / sim.particles().thickness();
  }
  // The time of a pressure wave.
  template <class Sim>
  [[nodiscard]] static double response(const Sim& sim) {
    const double reach = sim.boundary().region(sim.particles()).semi_axes().maxCoeff();
    return reach * std::sqrt(sim.rock().density / stiffness(sim));
  }

  double pressure_;
  double axial_rate_;
  PressureServo servo_;
};

}  // namespace peers
