// SPDX-License-Identifier: BSL-1.0
// Breakage by the contact forces alone: Cundall and Hart (1985), Tsoungui et al. (1999), the
// largest force by Hertz, the mean stress.

#include <cmath>
#include <utility>

#include <riprap/breakage/line_fit/line_fit_choice.hpp>
#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/line_fit/mean_stress_failure_plane.hpp>
#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/hertzian_strength.hpp>
#include <riprap/breakage/trigger/mean_stress_failure.hpp>
#include <riprap/breakage/trigger/trigger_choice.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>

#include "run_model.hpp"

namespace rivals {

namespace {

using namespace riprap;
using AnyTrigger =
    TriggerChoice<BrazilianStrength, TsounguiStrength, HertzianStrength, MeanStressFailure>;
using AnyLine = LineFitChoice<LoadedDiameter, MeanStressLine, MeanStressFailurePlane>;

// One type for all of them: it takes long to compile.
auto model_of(AnyTrigger trigger, AnyLine line, const HoekBrown& criterion = {}) {
  return Model{}.criterion(criterion).trigger(std::move(trigger)).line_fit(std::move(line));
}

}  // namespace

Json run_opposed_forces(const Case& c) {
  BrazilianStrength trigger{};
  trigger.strength *= strength_factor(Model{}.trigger(trigger), c);
  return run_model(model_of({trigger}, {LoadedDiameter{}}), c);
}

Json run_all_forces(const Case& c) {
  TsounguiStrength trigger{};
  trigger.strength *= strength_factor(Model{}.trigger(trigger), c);
  return run_model(model_of({trigger}, {MeanStressLine{}}), c);
}

Json run_largest_force(const Case& c) {
  HertzianStrength trigger{};
  // The pressure grows with the root of the force.
  trigger.pressure *= std::sqrt(strength_factor(Model{}.trigger(trigger), c));
  return run_model(model_of({trigger}, {MeanStressLine{}}), c);
}

Json run_mean_stress(const Case& c) {
  HoekBrown criterion{};
  criterion.compressive_strength *= strength_factor(Model{}.trigger(MeanStressFailure{}), c);
  return run_model(model_of({MeanStressFailure{}}, {MeanStressFailurePlane{}}, criterion), c);
}

}  // namespace rivals
