// SPDX-License-Identifier: BSL-1.0
// reading_results: a short biaxial test; curve, breakages and contacts as an observer reads them
// An observer has hooks that a test calls: here at every record and at every breakage.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include <riprap/output/curve_charts.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

struct Reader {
  std::size_t breaks = 0;
  double contacts_per_particle = 0;  // at the last record

  void record(const auto& view) {
    const Particles& particles = view.sim.particles();
    std::size_t contacts = 0;
    double largest = 0;  // normal force [N]
    view.sim.contacts().for_each_touching([&](const auto& contact) {
      const bool inside =
          particles.body(contact.a).is_free() && particles.body(contact.b).is_free();
      contacts += inside;
      if (inside) largest = std::max(largest, contact.force.normal);
    });
    std::size_t free = 0;
    for (const Body& body : particles.bodies()) free += body.is_free();
    contacts_per_particle = static_cast<double>(contacts) / static_cast<double>(free);
    std::printf("strain %.4f: %zu particles, %.3f contacts each, largest force %.0f N\n",
                view.axial_strain(), free, contacts_per_particle, largest);
  }
  void record_break(const auto& view, const BreakEvent& event) {
    ++breaks;
    std::printf("  particle %u breaks in the %s stage, Rat %.2f, in %s, into %.0f and %.0f mm^2\n",
                event.particle.id, to_text(view.stage), event.failures.ratio(), to_text(event.mode),
                1e6 * event.areas[0], 1e6 * event.areas[1]);
  }
};

int main() {
  Simulation sim{Model{}, random_assembly({.count = 80, .seed = 2}), Rock{}};
  Curve curve;  // an observer too: the points of the stress-strain curve
  Reader reader;
  const BiaxialTest test{.confining_pressure = 14.0_MPa, .axial_strain = 0.02};
  const BiaxialResult result = test.run(sim, curve, reader);

  std::printf("\nstrain  axial stress [MPa]  sin phi\n");
  for (const auto& point : curve.points())
    std::printf("%.4f  %18.3f  %.4f\n", point.axial_strain, 1e-6 * point.stress.s22,
                point.sin_phi());
  chart_sheet(curve_charts(curve)).save("reading_results_curves.svg");
  force_chain_picture(sim.particles(), sim.contacts(), "Normal forces", ForceClasses{}.scaled(7))
      .save("reading_results_forces.svg");
  std::printf("pictures in reading_results_curves.svg and reading_results_forces.svg\n");

  std::printf("breakages: %zu counted, %zu in the curve, %zu in the simulation\n", reader.breaks,
              curve.breaks().size(), sim.breaks().size());
  const bool same = reader.breaks == curve.breaks().size() && reader.breaks == sim.breaks().size();
  return result.stage(Stage::shear).reached_target && same ? 0 : 1;
}
