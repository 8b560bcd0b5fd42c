// SPDX-License-Identifier: BSL-1.0
// riprap_checks PACKING PRESSURE STRAIN  times what all checking of stress costs in the shear stage
// of a biaxial test at a pressure [Pa], up to an axial strain.

#include <exception>
#include <iostream>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/measurement/step_timer.hpp>
#include <riprap/simulation/simulation.hpp>

#include "packing.hpp"
#include "result.hpp"

namespace peers {
namespace {

// An observer of the last stage, shear.
class ShearTimer {
 public:
  void begin_stage(const auto& /*view*/) {
    timer_ = {};
    begun_ = cpu_seconds();
  }
  void on_phase_end(StepPhase part) { timer_.on_phase_end(part); }
  void after_step(const auto& sim) { timer_.after_step(sim); }
  void end_stage(const auto& /*view*/) { cpu_ = cpu_seconds() - begun_; }

  // Nanoseconds of CPU time a particle and step. The phases are wall-clock time: they say which
  // share it is, so that what else the machine does cancels.
  [[nodiscard]] double checking() const {
    const double share =
        (timer_.seconds(StepPhase::stress_bound) + timer_.seconds(StepPhase::stress_check) +
         timer_.seconds(StepPhase::splitting)) /
        timer_.seconds();
    return 1e9 * share * cpu_ / static_cast<double>(timer_.particle_steps());
  }

 private:
  StepTimer timer_;
  double begun_ = 0;
  double cpu_ = 0;
};

}  // namespace
}  // namespace peers

int main(int count, char** arguments) try {
  using namespace peers;
  if (count != 4) throw std::runtime_error("riprap_checks PACKING PRESSURE STRAIN");
  const double axial_strain = std::stod(arguments[3]);
  Simulation sim{Model{}, read(arguments[1]).assembly, Rock{}};
  ShearTimer timer;
  BiaxialTest{.confining_pressure = std::stod(arguments[2]),
              .axial_strain = axial_strain,
              .rest_unbalanced_force = 0.05}
      .run(sim, timer);
  print_result("riprap " RIPRAP_FLAGS, {{"ns", timer.checking()},
                                        {"breaks", static_cast<double>(sim.breaks().size())},
                                        {"strain", axial_strain}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
