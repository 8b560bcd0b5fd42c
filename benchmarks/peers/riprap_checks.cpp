// riprap_checks PACKING PRESSURE STRAIN  times what all checking of stress costs in the shear stage
// of a biaxial test at a pressure [Pa], up to an axial strain.

#include <cstdint>
#include <exception>
#include <iostream>

#include "result.hpp"
#include "sheared.hpp"

namespace peers {
namespace {

// An observer: CPU time and particle-steps of shear.
struct ShearClock {
  double seconds = 0;
  std::uint64_t particle_steps = 0;
  bool in_shear = false;

  void begin_stage(const auto& view) {
    in_shear = view.stage == Stage::shear;
    if (in_shear) seconds = -cpu_seconds();
  }
  void after_step(const auto& sim) {
    if (in_shear) particle_steps += sim.particles().size();
  }
  void end_stage(const auto& /*view*/) {
    if (in_shear) seconds += cpu_seconds();
  }
  [[nodiscard]] double ns_per_particle_step() const {
    return 1e9 * seconds / static_cast<double>(particle_steps);
  }
};

struct Checking {
  double ns = 0;  // per particle-step
  std::size_t breaks = 0;
};

// The same test with breakage and without; the difference is what breakage costs: checks, operators
// for new pieces, splits and the contacts of the pieces.
[[nodiscard]] Checking cost_of_checking(const Packing& packing, double pressure,
                                        double axial_strain) {
  const BiaxialTest test{
      .confining_pressure = pressure, .axial_strain = axial_strain, .rest_unbalanced_force = 0.05};
  Checking checking;
  for (const bool breakage : {false, true}) {
    Simulation sim{Model{}, assembly(packing), Rock{}};
    sim.set_breakage(breakage);
    ShearClock clock;
    test.run(sim, clock);
    checking.ns += (breakage ? 1 : -1) * clock.ns_per_particle_step();
    checking.breaks = sim.breaks().size();
  }
  return checking;
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("riprap_checks PACKING PRESSURE STRAIN");
  const double axial_strain = std::stod(arguments[3]);
  const peers::Checking checking =
      peers::cost_of_checking(peers::read(arguments[1]), std::stod(arguments[2]), axial_strain);
  peers::print_result("riprap " RIPRAP_FLAGS, {{"ns", checking.ns},
                                               {"breaks", static_cast<double>(checking.breaks)},
                                               {"strain", axial_strain}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
