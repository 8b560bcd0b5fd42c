// SPDX-License-Identifier: BSL-1.0
// The policies that the options stand for.

#include "policies.hpp"

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

AnyLoadTrigger chosen_load_trigger(const Options& options) {
  if (options.trigger == "mean-stress") return {riprap::MeanStressFailure{}};
  if (options.trigger == "hertz") return {options.hertzian};
  if (options.trigger == "tsoungui") return {options.tsoungui};
  return {options.brazilian};
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
