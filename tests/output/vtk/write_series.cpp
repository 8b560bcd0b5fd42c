// SPDX-License-Identifier: BSL-1.0
// Writes a series for ParaView of a sample that is being crushed, and beside it the same numbers as
// plain text, straight from the simulation: what a reader has to find.

#include <filesystem>
#include <fstream>
#include <string>

#include <riprap/output/paraview.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

using namespace riprap;

namespace {

template <class... Numbers>
void line(std::ofstream& out, const std::string& kind, Numbers... numbers) {
  out << kind;
  ((out << ' ' << to_text(static_cast<double>(numbers))), ...);
  out << '\n';
}

template <class Sim>
void describe(std::ofstream& out, const Sim& sim, const std::vector<MaterialPoint>& reference) {
  const Particles& particles = sim.particles();
  const auto stresses = contact_stresses(sim.contacts(), particles);
  const auto ratios = sim.failed_ratios();
  const auto is_rattler = rattlers(sim.contacts(), particles);
  const auto gradients = internal::gradients_since(reference, particles);
  const LucyKernel kernel{3 * equivalent_diameter(sim.mean_area())};
  const auto smooth = coarse_grained_stresses(sim.contacts(), particles, kernel);
  line(out, "state", sim.time());
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Ancestry& a = particles.ancestry(i);
    const Body& b = particles.body(i);
    const double parent = a.generation > 0 ? a.parent : -1.0;
    line(out, "particle", a.id, parent, a.root, a.generation, int{particles.material(i)},
         static_cast<int>(b.motion), b.velocity.x(), b.velocity.y(), 0, b.angular_velocity,
         stresses[i].s11, stresses[i].s22, stresses[i].s12, is_rattler[i], ratios[i],
         gradients[i].volumetric_strain(), gradients[i].deviatoric_strain(),
         gradients[i].rotation(), smooth[i].s11, smooth[i].s22, smooth[i].s12,
         particles.shape(i).area, b.position.x(), b.position.y());
    out << "ring";
    for (const Vec2& v : particles.ring(i)) out << ' ' << to_text(v.x()) << ' ' << to_text(v.y());
    out << '\n';
  }
  sim.contacts().for_each_touching([&](const auto& c) {
    const Body& a = particles.body(c.a);
    const Body& b = particles.body(c.b);
    line(out, "contact", particles.ancestry(c.a).id, particles.ancestry(c.b).id, c.force.normal,
         c.force.tangential, c.geometry.depth, a.position.x(), a.position.y(), b.position.x(),
         b.position.y());
  });
}

}  // namespace

int main(int /*argc*/, char** argv) {
  const std::filesystem::path folder = argv[1];
  std::filesystem::remove_all(folder);
  ParaViewSeries series(folder);
  Simulation sim{Model{}, random_assembly({.count = 60, .seed = 2}), Rock{}};
  sim.boundary().set_rate(30, 60);
  const auto reference = root_centroids(sim.particles());
  series.write(sim, sim.time());  // loose: contacts are few or none
  std::ofstream expected(folder / "expected.txt");
  describe(expected, sim, reference);
  for (const std::size_t breaks : {1u, 6u}) {
    while (sim.breaks().size() < breaks) sim.step();
    series.write(sim, sim.time());
    describe(expected, sim, reference);
  }
  return expected.good() ? 0 : 1;
}
