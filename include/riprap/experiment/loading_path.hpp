// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A loading path: a list of stages, and how it is run.

#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/path_run.hpp>
#include <riprap/experiment/stage.hpp>

namespace riprap {

/// A test as data: its stages in order. With controls or end conditions of a program's own:
/// `LoadingPath<LoadingStage<AxisControlOr<Mine>>>`.
template <class StageT = LoadingStage<>>
struct LoadingPath {
  /// Of rates by inertial number, and for the checks of the sample [Pa].
  double confining_pressure = 2e6;
  std::vector<StageT> stages{};

  /// Throws InvalidInput that names the stage, the value and the rule.
  void validate() const {
    require_positive("LoadingPath.confining_pressure", confining_pressure);
    require(!stages.empty(), "LoadingPath.stages: number of stages", 0, "must be above 0");
    for (const StageT& stage : stages) stage.validate();
  }

  /// Adds stages at the end, also those of a path with fewer kinds of controls and conditions.
  template <class Other>
  LoadingPath& append(const std::vector<Other>& others) {
    for (const Other& other : others) stages.push_back(converted(other));
    return *this;
  }

  /// The run before its first step; simulation and observers must outlive it. Observers get the
  /// hooks of a simulation step and, with a LoadingView, `begin_stage`, `progress` (now and then),
  /// `record`, `record_break`, `stop_requested` and `end_stage`.
  template <class Sim, class... Observers>
  [[nodiscard]] auto start(Sim& sim, Observers&... observers) const {
    (hooks::check_loading_observer<std::remove_cv_t<Observers>, Sim>(), ...);
    using BoundaryT = std::remove_cvref_t<decltype(sim.boundary())>;
    constexpr bool stage_is_good =
        internal::check_stage<LoadingView<Sim>>(static_cast<const StageT*>(nullptr));
    if constexpr (check_sample_boundary<BoundaryT>() && stage_is_good) {
      validate();
      for (const StageT& stage : stages)
        require(!(internal::follows<LoadingView<Sim>>(stage.axis_1) &&
                  internal::follows<LoadingView<Sim>>(stage.axis_2)),
                "stage '" + stage.name + "': axis_2", 2, "both axes would follow each other");
      return PathRun<StageT, Sim, Observers...>(confining_pressure, stages, sim, observers...);
    } else {
      return internal::NoRun{};  // does not compile; this keeps it to one error
    }
  }

  /// Runs all stages. Ends early after a step for which an observer's `stop_requested(view)` is
  /// true: the stage is closed, and the result says `interrupted`.
  template <class Sim, class... Observers>
  PathResult run(Sim& sim, Observers&&... observers) const {
    return start(sim, observers...).run();
  }

 private:
  template <class Other>
  [[nodiscard]] static StageT converted(const Other& other) {
    if constexpr (std::is_same_v<Other, StageT>) {
      return other;
    } else {
      const auto as = []<class V>(const auto& value, std::type_identity<V>) {
        return std::visit([](const auto& c) { return internal::widened<V>(c); }, value);
      };
      return {.name = other.name,
              .axis_1 = as(other.axis_1, std::type_identity<decltype(StageT::axis_1)>{}),
              .axis_2 = as(other.axis_2, std::type_identity<decltype(StageT::axis_2)>{}),
              .end = as(other.end, std::type_identity<decltype(StageT::end)>{}),
              .part = other.part,
              .breakage = other.breakage,
              .friction = other.friction,
              .affine_start = other.affine_start,
              .zero_strain = other.zero_strain,
              .records = other.records,
              .record_every = other.record_every,
              .record_axis = other.record_axis,
              .record_every_steps = other.record_every_steps,
              .most_steps = other.most_steps,
              .at_cap = other.at_cap};
    }
  }
};

}  // namespace riprap
