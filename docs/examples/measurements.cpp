// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <numbers>
#include <optional>

#include <riprap/measurement/coarse_grained_stress.hpp>
#include <riprap/measurement/force_distribution.hpp>
#include <riprap/measurement/force_networks.hpp>
#include <riprap/measurement/rattlers.hpp>
#include <riprap/output/local_strain_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

struct StartOfShear {  // an observer that keeps the particles
  std::optional<Particles> particles;
  void begin_stage(const auto& view) {
    if (view.stage == Stage::shear) particles = view.sim.particles();
  }
};

int main() {
  Simulation sim{Model{}, random_assembly({.count = 300}), Rock{}};
  StartOfShear start;
  BiaxialTest{.axial_strain = 0.1}.run(sim, start);
  const Particles& particles = sim.particles();
  const double area = sim.boundary().region(particles).area();

  const MechanicalCoordination z = mechanical_coordination(sim.contacts(), particles);
  std::printf("Z %.2f, Z_m %.2f, without rattlers %.2f; %zu of %zu are rattlers\n", z.loaded,
              z.mechanical, z.rattler_free, z.rattlers, z.particles);

  const ForceNetworks forces = force_networks(sim.contacts(), area, particles.thickness());
  for (const ForceNetwork& network : {forces.strong, forces.weak})
    std::printf("%.0f %% of contacts: %.0f %% of mean stress, %.0f %% of deviator, a = %.2f\n",
                100 * network.contact_share, 100 * network.mean_share, 100 * network.deviator_share,
                network.fabric.normals.coefficient);
  const ExponentialTail tail = exponential_tail(normal_forces(sim.contacts()));
  std::printf("tail of normal forces: exp(-(%.2f +- %.2f) f/<f>)\n", tail.rate,
              tail.standard_error);

  const auto before = root_centroids(*start.particles);
  const auto triangles = local_strain(before, root_centroids(particles));
  const StrainLocalisation band = strain_localisation(triangles);
  const DisplacementGradient mean = mean_gradient(triangles);
  std::printf("mean of h_11 %.3f, of h_22 %.3f; a tenth of the area has %.0f %% of the strain\n",
              mean.h11, mean.h22, 100 * band.strain_share);
  std::printf("band at %.0f degrees to axis 1, %.1f times as long as thick\n",
              band.direction * 180 / std::numbers::pi, band.elongation);
  local_strain_picture(*start.particles, triangles, band, 0.6, "Local strain at 10 % axial strain")
      .save("local_strain.svg");

  const double radius = 3 * equivalent_diameter(sim.mean_area());
  const std::vector<Vec2> middle{centre_of(sim.boundary().region(particles))};
  const Stress2 stress = coarse_grained_stresses(force_lines(sim.contacts()), middle,
                                                 LucyKernel{radius}, particles.thickness())[0];
  const Stress2 whole = average_stress(sim.contacts(), area, particles.thickness());
  std::printf("stress in the middle %.2f and %.2f MPa, of the sample %.2f and %.2f MPa\n",
              1e-6 * stress.s11, 1e-6 * stress.s22, 1e-6 * whole.s11, 1e-6 * whole.s22);
}
