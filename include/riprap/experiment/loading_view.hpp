// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The state of a test, as its controls, end conditions and observers see it.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <riprap/core/errors.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/dimensionless.hpp>

namespace riprap {

/// The parts of a test, in this order: three prepare the sample, the last loads it. A loading path
/// may have several stages in a part, each with a name of its own.
enum class Stage { compaction, relaxation, hydrostatic, shear, loading = shear };

[[nodiscard]] constexpr const char* to_text(Stage stage) {
  switch (stage) {
  case Stage::compaction:
    return "compaction";
  case Stage::relaxation:
    return "relaxation";
  case Stage::hydrostatic:
    return "hydrostatic";
  case Stage::shear:
    return "shear";
  }
  return "";
}

/// The state of a test, handed to observers' hooks. Strains count from the start of the stage, in
/// loading from the start of its first stage or the last one that has `zero_strain`.
template <class Sim>
struct LoadingView {
  const Sim& sim;
  Stage stage = Stage::compaction;
  double done = 0;                    ///< rough share of the stage that is done, in [0, 1]
  bool reached_target = false;        ///< at end_stage; false: it was missed, or a stop came first
  bool interrupted = false;           ///< an observer's stop_requested ended the test
  double confining_pressure = 0;      ///< [Pa]
  double mean_diameter = 0;           ///< mean_particle_diameter at the start [m]
  Vec2 stretch{1, 1};                 ///< extent over that at zero strain, axes 1 and 2
  Vec2 rate{0, 0};                    ///< shortening rates [1/s]
  double area = 0;                    ///< of the assembly [m^2]
  double mean_confinement_error = 0;  ///< of the stage so far: mean of stress / target - 1
  double saturated_share = 0;         ///< steps of the stage so far with the servo at its limit
  std::string_view stage_name{};      ///< in the path; empty: that of `stage`
  std::size_t stage_index = 0;        ///< in the path
  std::size_t loading_stage = 0;      ///< stages of loading before this one
  std::uint64_t stage_steps = 0;      ///< of the stage so far
  double stage_begun = 0;             ///< sim.time() at the start of the stage [s]
  bool at_check = false;              ///< every 128th step, for what is too dear for every step
  mutable std::optional<Stress2> known_stress{};  ///< of this state, once it was asked for

  /// Engineering strain of the field along axis 2, positive in shortening.
  [[nodiscard]] double axial_strain() const { return 1 - stretch.y(); }
  /// Positive in contraction.
  [[nodiscard]] double volumetric_strain() const { return 1 - stretch.x() * stretch.y(); }
  /// Engineering strain along axis 1 or 2, positive in shortening.
  [[nodiscard]] double strain(int axis) const { return 1 - stretch[axis - 1]; }
  [[nodiscard]] std::string_view name() const {
    return stage_name.empty() ? std::string_view(to_text(stage)) : stage_name;
  }

  /// Over the whole assembly [Pa]; computed once a step. Throws SimulationError if not finite.
  [[nodiscard]] const Stress2& stress() const {
    if (!known_stress) known_stress = measured_stress();
    return *known_stress;
  }
  /// Normal stress along axis 1 or 2 [Pa].
  [[nodiscard]] double stress(int axis) const { return axis == 1 ? stress().s11 : stress().s22; }

  /// The rate at which axis 2 is strained, or axis 1 where axis 2 is not [1/s]; not negative.
  [[nodiscard]] double strain_rate() const { return std::abs(rate.y() != 0 ? rate.y() : rate.x()); }
  /// Since the start of the stage [s].
  [[nodiscard]] double stage_time() const { return sim.time() - stage_begun; }
  /// The strain rate [1/s] of an inertial number at a pressure [Pa].
  [[nodiscard, gnu::noinline]] double rate_at(double inertia, double pressure) const {
    return inertia / inertial_number(1, mean_diameter, sim.particles().mean_density(), pressure);
  }
  /// Of the sample taken as a spring [Pa].
  [[nodiscard]] double sample_stiffness() const {
    return 0.5 * sim.contacts().law().peak_stiffness() / sim.particles().thickness();
  }
  /// The time that a pressure wave takes from the boundary to the centre [s].
  [[nodiscard, gnu::noinline]] double servo_response() const {
    return Vec2(sim.boundary().region(sim.particles()).semi_axes()).maxCoeff() *
           std::sqrt(sim.particles().mean_density() / sample_stiffness());
  }

  static constexpr bool names_all_members = false;
  /// What a run that goes on needs; the rest follows from the path and the simulation.
  static void for_each_field(auto& self, auto&& visit) {
    visit("mean_diameter", self.mean_diameter);
    visit("done", self.done);
    visit("reached_target", self.reached_target);
    visit("interrupted", self.interrupted);
    visit("stretch", self.stretch);
    visit("rate", self.rate);
    visit("area", self.area);
    visit("mean_confinement_error", self.mean_confinement_error);
    visit("saturated_share", self.saturated_share);
    visit("stage_steps", self.stage_steps);
    visit("stage_begun", self.stage_begun);
  }

 private:
  [[nodiscard, gnu::noinline]] Stress2 measured_stress() const {
    try {
      return average_stress(sim.interactions(), area, sim.particles().thickness(),
                            sim.model().execution_policy);
    } catch (const InvalidInput& error) {
      throw SimulationError(error.what());
    }
  }
};

/// That of a biaxial test.
template <class Sim>
using BiaxialView = LoadingView<Sim>;

}  // namespace riprap
