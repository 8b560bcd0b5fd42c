// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <exception>
#include <vector>

#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/curve_charts.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/riprap.hpp>
using namespace riprap;

struct MostFailed {  // an observer: the particle nearest to breaking, at each record
  void record(const auto& view) {
    const auto& sim = view.sim;
    const std::vector<double> rat = sim.failed_ratios();  // in the order of the bodies
    BodyIndex most = 0;
    for (BodyIndex i = 0; i < rat.size(); ++i)
      if (rat[i] > rat[most]) most = i;
    double pushed = 0;  // largest normal force on it [N]
    sim.contacts().for_each_touching([&](const auto& c) {
      if (c.a == most || c.b == most) pushed = std::max(pushed, c.force.normal);
    });
    std::printf("strain %.4f: particle %u, Rat %.2f, pushed with %.0f N\n", view.axial_strain(),
                sim.particles().ancestry(most).id, rat[most], pushed);
  }
};

int main() try {
  Simulation sim{Model{}, random_assembly({.count = 40, .seed = 2}), Rock{}};
  Curve curve;
  ValidityCheck check;
  MostFailed most_failed;
  const BiaxialTest test{.confining_pressure = 8.0_MPa, .axial_strain = 0.005};
  const BiaxialResult result = test.run(sim, curve, check, most_failed);

  std::printf("peak sin phi %.3f, %zu breakages in shear, %zu before\n", curve.peak().sin_phi(),
              curve.points().back().breakages, curve.breakages_before_shear());
  for (const std::string& warning : check.warnings()) std::printf("%s\n", warning.c_str());
  assembly_picture(sim.particles(), sim.failed_ratios(), "At the end").save("assembly.svg");
  force_chain_picture(sim.particles(), sim.contacts(), "Normal forces", ForceClasses{}.scaled(4))
      .save("forces.svg");
  chart_sheet(curve_charts(curve)).save("curves.svg");
  return result.stage(Stage::shear).reached_target ? 0 : 1;
} catch (const std::exception& error) {  // InvalidInput or SimulationError
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
