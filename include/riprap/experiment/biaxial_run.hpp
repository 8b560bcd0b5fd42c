// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A biaxial test on its way.

#include <cstddef>
#include <utility>
#include <vector>

#include <riprap/experiment/biaxial_result.hpp>
#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/path_run.hpp>
#include <riprap/experiment/stage.hpp>

namespace riprap {

/// The run of a BiaxialTest, made by its `start`: a PathRun that gives a BiaxialResult.
template <class Sim, class... Observers>
class BiaxialRun : public PathRun<LoadingStage<>, Sim, Observers...> {
 public:
  BiaxialRun(double confining_pressure, double inertial_number, std::vector<LoadingStage<>> stages,
             Sim& sim, Observers&... observers)
      : PathRun<LoadingStage<>, Sim, Observers...>(confining_pressure, std::move(stages), sim,
                                                   observers...),
        inertial_number_(inertial_number) {}

  BiaxialResult run() {
    PathRun<LoadingStage<>, Sim, Observers...>::run();
    return result();
  }

  [[nodiscard]] BiaxialResult result() const {
    const PathResult& path = PathRun<LoadingStage<>, Sim, Observers...>::result();
    BiaxialResult result;
    for (std::size_t k = 0; k < result.stages.size(); ++k) result.stages[k] = path.stages[k];
    result.interrupted = path.interrupted;
    const StageResult& shear = result.stage(Stage::shear);
    if (shear.begun)
      result.axial_rate = this->view().rate_at(inertial_number_, this->view().confining_pressure);
    result.mean_confinement_error = shear.mean_error;
    result.rms_confinement_error = shear.rms_error;
    return result;
  }

 private:
  double inertial_number_;  // of shear
};

}  // namespace riprap
