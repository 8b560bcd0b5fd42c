// SPDX-License-Identifier: BSL-1.0
#pragma once
// Curve, grading, energy and numbers of a run, as run.json has them.

#include <string>
#include <vector>

#include <riprap/experiment/biaxial_result.hpp>
#include <riprap/experiment/curve.hpp>

#include "plan.hpp"

namespace study {

Json curve_json(const riprap::Curve& curve);
Json grading_json(const riprap::Particles& particles);
Json numbers_json(const riprap::Curve& curve, const riprap::BiaxialResult& result, double kappa);
// Since the start of shear [J].
Json energy_json(const riprap::Curve& curve);
Json stages_json(const riprap::BiaxialResult& result);

}  // namespace study
