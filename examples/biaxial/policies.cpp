// SPDX-License-Identifier: BSL-1.0
// The policies that the options stand for.

#include "policies.hpp"

#include <limits>
#include <numbers>

AnyCriterion chosen_criterion(const Options& options) {
  if (options.criterion == "mohr-coulomb") return {options.mohr_coulomb};
  if (options.criterion == "griffith") return {options.griffith};
  if (options.criterion == "modified-griffith") return {options.modified_griffith};
  if (options.criterion == "murrell") return {options.murrell};
  if (options.criterion == "hobbs") return {options.hobbs};
  if (options.criterion == "franklin") return {options.franklin};
  return {options.hoek_brown};
}

AnyLineFit chosen_line_fit(const Options& options) {
  if (options.line_fit == "x") return {riprap::WeightedX{}};
  if (options.line_fit == "y") return {riprap::WeightedY{}};
  if (options.line_fit == "xy-mean-stress") return {riprap::WeightedXYByMeanStress{}};
  if (options.line_fit == "mean-tension") return {riprap::MeanTensionLine{}};
  if (options.line_fit == "tls") return {riprap::TotalLeastSquares{}};
  if (options.line_fit == "plane") return {riprap::FailurePlaneThroughCentroid{}};
  if (options.line_fit == "loaded-diameter") return {riprap::LoadedDiameter{}};
  if (options.line_fit == "mean-stress") return {riprap::MeanStressLine{}};
  if (options.line_fit == "mean-stress-plane") return {riprap::MeanStressFailurePlane{}};
  return {riprap::WeightedXY{}};
}

riprap::WeibullStrength chosen_element_trigger(const Options& options) {
  riprap::WeibullStrength strength = options.weibull;
  if (options.strength_scatter == "none") {
    strength.modulus = std::numeric_limits<double>::infinity();
    return strength;
  }
  riprap::require_positive("strength diameter", options.strength_diameter);
  strength.reference_area =
      0.25 * std::numbers::pi * options.strength_diameter * options.strength_diameter;
  strength.seed = options.assembly.seed;
  return strength;
}

AnyLoadTrigger chosen_load_trigger(const Options& options) {
  const riprap::WeibullStrength strength = chosen_element_trigger(options);
  AnyLoadTrigger any{.trigger = {options.brazilian},
                     .modulus = strength.modulus,
                     .reference_area = strength.reference_area,
                     .seed = strength.seed,
                     .dimension = strength.dimension};
  if (options.trigger == "mean-stress") any.trigger.chosen = riprap::MeanStressFailure{};
  if (options.trigger == "hertz") any.trigger.chosen = options.hertzian;
  if (options.trigger == "tsoungui") any.trigger.chosen = options.tsoungui;
  return any;
}

AnyLoadLineFit chosen_load_line_fit(const Options& options) {
  if (options.line_fit == "mean-stress") return {riprap::MeanStressLine{}};
  if (options.line_fit == "mean-stress-plane") return {riprap::MeanStressFailurePlane{}};
  return {riprap::LoadedDiameter{}};
}

AnyPlane chosen_plane(const Options& options) {
  if (options.plane == "strain") return {riprap::PlaneStrain{}};
  return {riprap::PlaneStress{}};
}

AnyContact chosen_contact(const Options& options) {
  if (options.contact == "linear") return {options.linear};
  if (options.contact == "incremental") return {options.incremental};
  if (options.contact == "area") return {options.area};
  if (options.contact == "dashpot") return {options.dashpot};
  return {options.energy_conserving};
}

AnyNarrowPhase chosen_narrow_phase(const Options& options) {
  if (options.contact == "energy-conserving") return {riprap::OverlapMoments{}};
  return {riprap::OverlapChord{}};
}

riprap::MassFloor chosen_time_step(const Options& options) {
  return options.contact == "energy-conserving" ? options.time_step : options.time_step_of_others;
}

AnyIntegrator chosen_integrator(const Options& options) {
  if (options.integrator == "verlet") return {riprap::VelocityVerlet{}};
  return {riprap::SymplecticEuler{}};
}

AnySupport chosen_support(const Options& options) {
  if (options.support == "pinned") return {riprap::TwoPinnedContacts{}};
  return {riprap::InertiaRelief{}};
}
