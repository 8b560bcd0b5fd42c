// riprap_step PACKING  times steps without breakage.

#include <exception>
#include <iostream>

#include <riprap/breakage/criterion/never_fails.hpp>

#include "result.hpp"
#include "sheared.hpp"

int main(int count, char** arguments) try {
  using namespace peers;
  if (count != 2) throw std::runtime_error("riprap_step PACKING");
  const Packing packing = read(arguments[1]);
  Simulation sim{Model{}.criterion(NeverFails{}), assembly(packing), Rock{}};
  Shear shear(sim, packing.pressure, packing.axial_rate);
  sim.boundary().set_rate(packing.lateral_rate, packing.axial_rate);
  const auto step = [&] { sim.step(); };
  const auto steer = [&](int steps) { shear.steer(sim, steps * sim.time_step()); };
  const std::size_t grains = sim.particles().size();
  (void)time_steps(200, grains, step, steer);
  const double ns = time_steps(grains < 2000 ? 2000 : 600, grains, step, steer);
  print_result("riprap " RIPRAP_FLAGS,
               {{"ns", ns},
                {"coordination", coordination(sim.contacts(), sim.particles()).coordination_number},
                {"overlap", state_numbers(sim.contacts(), sim.particles()).mean_overlap /
                                packing.mean_diameter},
                {"time_step", sim.time_step()}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
