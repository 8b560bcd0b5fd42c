// SPDX-License-Identifier: BSL-1.0
#pragma once
// The policies that the options stand for. What is chosen at run time goes through one more model
// of its role and costs a little in the hot loops.

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/line_fit/line_fit_choice.hpp>
#include <riprap/breakage/trigger/trigger_choice.hpp>
#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/narrow_phase/narrow_phase_choice.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/dynamics/integrator/integrator_choice.hpp>
#include <riprap/riprap.hpp>
#include <riprap/stress/plane_state/plane_state_choice.hpp>
#include <riprap/stress/support/support_choice.hpp>
#ifdef _OPENMP
#include <riprap/core/execution/threads.hpp>
#endif

#include "options.hpp"

using AnyCriterion = riprap::CriterionChoice<riprap::HoekBrown, riprap::MohrCoulomb,
                                             riprap::Griffith, riprap::ModifiedGriffith,
                                             riprap::Murrell, riprap::Hobbs, riprap::Franklin>;
using AnyLineFit = riprap::LineFitChoice<
    riprap::WeightedXY, riprap::WeightedX, riprap::WeightedY, riprap::WeightedXYByMeanStress,
    riprap::MeanTensionLine, riprap::TotalLeastSquares, riprap::FailurePlaneThroughCentroid,
    riprap::LoadedDiameter, riprap::MeanStressLine, riprap::MeanStressFailurePlane>;
// Of those that need no finite elements; without scatter the modulus is infinite.
using AnyLoadTrigger = riprap::WithWeibullStrength<
    riprap::TriggerChoice<riprap::BrazilianStrength, riprap::MeanStressFailure,
                          riprap::HertzianStrength, riprap::TsounguiStrength>>;
using AnyLoadLineFit = riprap::LineFitChoice<riprap::LoadedDiameter, riprap::MeanStressLine,
                                             riprap::MeanStressFailurePlane>;
using AnyContact = riprap::ContactLawChoice<riprap::EnergyConservingSpring,
                                            riprap::LinearSpringCoulomb, riprap::IncrementalSpring,
                                            riprap::OverlapAreaSpring, riprap::SpringDashpot>;
using AnyNarrowPhase = riprap::NarrowPhaseChoice<riprap::OverlapMoments, riprap::OverlapChord>;
using AnyIntegrator = riprap::IntegratorChoice<riprap::SymplecticEuler, riprap::VelocityVerlet>;
using AnySupport = riprap::SupportChoice<riprap::InertiaRelief, riprap::TwoPinnedContacts>;
using AnyPlane = riprap::PlaneStateChoice<riprap::PlaneStress, riprap::PlaneStrain>;

// One thread or several: a choice costs nothing here, for it is made once for all tasks.
struct AnyExecution {
  int threads = 1;

  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
#ifdef _OPENMP
    if (threads > 1) return riprap::Threads{threads}.run(tasks, work);
#endif
    riprap::Serial{}.run(tasks, work);
  }
};
static_assert(riprap::Execution<AnyExecution>);

AnyCriterion chosen_criterion(const Options& options);
AnyLineFit chosen_line_fit(const Options& options);
// The failed-element ratio; without scatter the modulus is infinite. Throws InvalidInput for a
// strength diameter that is not above 0.
riprap::WeibullStrength chosen_element_trigger(const Options& options);
AnyLoadTrigger chosen_load_trigger(const Options& options);
AnyLoadLineFit chosen_load_line_fit(const Options& options);
AnyPlane chosen_plane(const Options& options);
AnyContact chosen_contact(const Options& options);
// The one that the contact law goes with.
AnyNarrowPhase chosen_narrow_phase(const Options& options);
riprap::MassFloor chosen_time_step(const Options& options);
AnyIntegrator chosen_integrator(const Options& options);
AnySupport chosen_support(const Options& options);
