// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stages of monotonic shear: axis 2 is shortened, and axis 1 does what the kind of test asks for.

#include <riprap/experiment/loading_stage.hpp>

namespace riprap {

/// What all stages of shear have in common.
struct ShearOptions {
  double axial_strain = 0.2;      ///< at the end [-]
  double inertial_number = 1e-3;  ///< at the path's confining pressure
  double record_every = 0.0025;   ///< axial strain between records [-]
  double tolerance = 0.05;        ///< on the mean error of a stress that is held
};

namespace internal {

[[nodiscard]] inline LoadingStage<> shear_stage(const char* name, const AxisControl& lateral,
                                                const ShearOptions& options) {
  return {.name = name,
          .axis_1 = lateral,
          .axis_2 = EngineeringRate{.rate_of_strain = {.inertial_number = options.inertial_number}},
          .end = StrainReached{.strain = options.axial_strain},
          .record_every = options.record_every};
}
[[nodiscard]] inline ServoControl shear_servo(const ShearOptions& options) {
  return {.expected_rate = {.inertial_number = options.inertial_number},
          .tolerance = options.tolerance};
}

}  // namespace internal

/// Drained biaxial shear: sigma_11 stays at a pressure [Pa].
[[nodiscard]] inline LoadingStage<> drained_shear(double pressure,
                                                  const ShearOptions& options = {}) {
  return internal::shear_stage(
      "drained shear",
      ControlledStress{.stress = pressure, .control = internal::shear_servo(options)}, options);
}

/// Shear at constant mean stress [Pa].
[[nodiscard]] inline LoadingStage<> constant_mean_stress_shear(double mean_stress,
                                                               const ShearOptions& options = {}) {
  return internal::shear_stage(
      "constant mean stress shear",
      ConstantMeanStress{.stress = mean_stress, .control = internal::shear_servo(options)},
      options);
}

/// Shear at constant volume: undrained shear of a sample saturated with what does not compress; the
/// pore pressure is what a drained path would have more of sigma_11.
[[nodiscard]] inline LoadingStage<> constant_volume_shear(const ShearOptions& options = {}) {
  return internal::shear_stage("constant volume shear", ConstantVolume{}, options);
}

}  // namespace riprap
