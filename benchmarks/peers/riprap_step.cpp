// SPDX-License-Identifier: BSL-1.0
// riprap_step PACKING  times steps without breakage.

#include <exception>
#include <iostream>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/simulation/simulation.hpp>

#include "packing.hpp"
#include "result.hpp"

int main(int count, char** arguments) try {
  using namespace peers;
  if (count != 2) throw std::runtime_error("riprap_step PACKING");
  const Packing packing = read(arguments[1]);
  Simulation sim{Model{}.criterion(NeverFails{}), packing.assembly, Rock{}};
  sim.boundary().set_rate(packing.lateral_rate, packing.axial_rate);
  const auto step = [&] { sim.step(); };
  const auto steer = [] {};
  const std::size_t grains = sim.particles().size();
  (void)time_steps(spring_settling_steps, grains, step, steer);
  const double ns = time_steps(spring_timed_steps, grains, step, steer);
  print_result("riprap " RIPRAP_FLAGS,
               {{"ns", ns},
                {"coordination", coordination(sim.contacts(), sim.particles()).coordination_number},
                {"overlap", state_averages(sim.contacts(), sim.particles()).mean_overlap /
                                packing.mean_diameter},
                {"time_step", sim.time_step()}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
