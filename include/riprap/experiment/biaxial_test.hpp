// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The biaxial test: compaction, relaxation, hydrostatic pressure, shear.

#include <cstdint>
#include <limits>
#include <type_traits>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/experiment/biaxial_result.hpp>
#include <riprap/experiment/biaxial_run.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/preparation.hpp>

namespace riprap {

/// A drained biaxial test on whatever the boundary encloses: axis 2 is shortened at a constant rate
/// of engineering strain while a servo holds sigma_11.
/// Breakage is on in the last two stages.
struct BiaxialTest {
  double confining_pressure = 2e6;  ///< [Pa]
  double axial_strain = 0.2;        ///< at the end [-]
  double inertial_number = 1e-3;    ///< of shear, at the confining pressure; 5e-4 below 1 MPa
  double record_every = 0.0025;     ///< axial strain between records [-]

  double jam_pressure = 2e5;        ///< mean stress at which a slow sample counts as jammed [Pa]
  double jam_kinetic_ratio = 0.04;  ///< kinetic over stored energy below which it counts as slow
  double compaction_inertial_number = 2e-3;  ///< of compaction, at the jam pressure
  double rest_unbalanced_force = 1e-3;       ///< that ends relaxation
  double hydrostatic_tolerance = 0.01;       ///< on both normal stresses
  double hydrostatic_unbalanced_force = 1e-2;
  /// Mean error of sigma_11 in shear above which the stage has missed its target.
  double confinement_tolerance = 0.05;
  std::uint64_t most_steps = 2'000'000;  ///< per stage before shear

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require_positive("BiaxialTest.confining_pressure", confining_pressure);
    require(axial_strain >= 0 && axial_strain < 0.9, "BiaxialTest.axial_strain", axial_strain,
            "must lie in [0, 0.9)");
    require_positive("BiaxialTest.record_every", record_every);
    preparation().validate("BiaxialTest");
    require_positive("BiaxialTest.confinement_tolerance", confinement_tolerance);
  }

  /// The stages before shear.
  [[nodiscard]] Preparation preparation() const {
    return {.inertial_number = inertial_number,
            .jam_pressure = jam_pressure,
            .jam_kinetic_ratio = jam_kinetic_ratio,
            .compaction_inertial_number = compaction_inertial_number,
            .rest_unbalanced_force = rest_unbalanced_force,
            .hydrostatic_tolerance = hydrostatic_tolerance,
            .hydrostatic_unbalanced_force = hydrostatic_unbalanced_force,
            .most_steps = most_steps};
  }

  /// All four stages, as data.
  [[nodiscard]] LoadingPath<> path() const {
    LoadingPath<> path{.confining_pressure = confining_pressure,
                       .stages = preparation().stages(confining_pressure)};
    const LoadingRate rate{.inertial_number = inertial_number, .pressure = confining_pressure};
    path.stages.push_back(
        {.name = "shear",
         .axis_1 = ControlledStress{.stress = confining_pressure,
                                    .control = {.expected_rate = rate,
                                                .tolerance = confinement_tolerance}},
         .axis_2 = EngineeringRate{.rate_of_strain = rate},
         .end = StrainReached{.strain = axial_strain},
         .record_every = record_every,
         .most_steps = std::numeric_limits<std::uint64_t>::max()});
    return path;
  }

  /// The run before its first step; simulation and observers must outlive it.
  template <class Sim, class... Observers>
  [[nodiscard]] auto start(Sim& sim, Observers&... observers) const {
    (hooks::check_loading_observer<std::remove_cv_t<Observers>, Sim>(), ...);
    using BoundaryT = std::remove_cvref_t<decltype(sim.boundary())>;
    if constexpr (check_sample_boundary<BoundaryT>()) {
      validate();
      return BiaxialRun<Sim, Observers...>(confining_pressure, inertial_number, path().stages, sim,
                                           observers...);
    } else {
      return internal::NoRun{};  // does not compile; this keeps it to one error
    }
  }

  /// Runs all four stages. Observers get the hooks of a simulation step and, with a BiaxialView,
  /// `begin_stage`, `progress` (now and then), `record` (in shear, first and last state included)
  /// and `end_stage`. The test ends early after a step for which an observer's
  /// `stop_requested(view)` is true: the stage is closed, in shear with a last record, and the
  /// result says `interrupted`.
  template <class Sim, class... Observers>
  BiaxialResult run(Sim& sim, Observers&&... observers) const {
    return start(sim, observers...).run();
  }
};

}  // namespace riprap
