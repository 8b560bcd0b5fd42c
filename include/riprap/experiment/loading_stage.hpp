// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A stage of a loading path: a control for each axis and a condition that ends it.

#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/crossing_condition.hpp>
#include <riprap/experiment/end_combination.hpp>
#include <riprap/experiment/equilibrium_condition.hpp>
#include <riprap/experiment/loading_concepts.hpp>
#include <riprap/experiment/loading_view.hpp>
#include <riprap/experiment/strain_control.hpp>
#include <riprap/experiment/stress_control.hpp>

namespace riprap {

/// The controls of riprap and those of a program's own.
template <class... Own>
using AxisControlOr =
    std::variant<Fixed, EngineeringRate, LogarithmicRate, ConstantVolume, ControlledStress,
                 FreeBoundary, StressRatio, ConstantMeanStress, Own...>;
using AxisControl = AxisControlOr<>;

/// Conditions that may be combined.
template <class... Own>
using SingleEndOr = std::variant<StepsMade, StrainReached, StressReached, StressesHeld, RestReached,
                                 Jammed, Own...>;

/// The end conditions of riprap and those of a program's own.
template <class... Own>
using EndConditionOr =
    std::variant<StepsMade, StrainReached, StressReached, StressesHeld, RestReached, Jammed,
                 AnyOf<SingleEndOr<Own...>>, AllOf<SingleEndOr<Own...>>, Own...>;
using EndCondition = EndConditionOr<>;

/// What happens when a stage has made its most steps.
enum class AtCap { go_on, error };
[[nodiscard]] constexpr auto names_of(AtCap) { return std::array{"go on", "error"}; }

/// A stage as data. `Control` and `End` are variants: AxisControl and EndCondition, or
/// AxisControlOr<Mine> and EndConditionOr<Mine>.
template <class Control = AxisControl, class End = EndCondition>
struct LoadingStage {
  std::string name{};
  Control axis_1 = Fixed{};
  Control axis_2 = Fixed{};
  End end{};
  Stage part = Stage::loading;
  bool breakage = true;          ///< false: no particle breaks, whatever the simulation has set
  bool friction = true;          ///< false: the contact law is `frictionless(law)`
  bool affine_start = false;     ///< free particles get the velocities of the strain field
  bool zero_strain = false;      ///< strains count from here
  bool records = true;           ///< the first state, unless it has been recorded, and the last
  double record_every = 0.0025;  ///< change of strain along `record_axis` [-]; 0: none between
  int record_axis = 2;
  std::uint64_t record_every_steps = 0;  ///< 0: by strain alone
  std::uint64_t most_steps = 10'000'000;
  AtCap at_cap = AtCap::go_on;  ///< go on: the stage has missed its target

  /// Throws InvalidInput that names the stage, the value and the rule.
  void validate() const {
    const std::string owner = "stage '" + name + "'";
    std::visit([&](const auto& c) { internal::validate_part(c, owner + ": axis_1"); }, axis_1);
    std::visit([&](const auto& c) { internal::validate_part(c, owner + ": axis_2"); }, axis_2);
    std::visit([&](const auto& c) { internal::validate_part(c, owner + ": end"); }, end);
    require_non_negative(owner + ": record_every", record_every);
    require(record_axis == 1 || record_axis == 2, owner + ": record_axis", record_axis,
            "must be 1 or 2");
    require(most_steps > 0, owner + ": most_steps", 0, "must be above 0");
  }

  template <class Self, class Visit>
  static void for_each_parameter(Self& self, Visit&& visit) {
    visit("breakage", self.breakage);
    visit("friction", self.friction);
    visit("affine_start", self.affine_start);
    visit("zero_strain", self.zero_strain);
    visit("records", self.records);
    visit("record_every", self.record_every);
    visit("record_axis", self.record_axis);
    visit("record_every_steps", self.record_every_steps);
    visit("most_steps", self.most_steps);
    visit("at_cap", self.at_cap);
  }

  static constexpr bool names_all_members = false;
  /// Those of the stage's controls and of its condition.
  static void for_each_field(auto& self, auto&& visit) {
    std::visit([&](auto& c) { visit("axis_1", c); }, self.axis_1);
    std::visit([&](auto& c) { visit("axis_2", c); }, self.axis_2);
    std::visit([&](auto& c) { visit("end", c); }, self.end);
  }
};

namespace internal {

template <class View, class... C>
consteval bool check_controls(const std::variant<C...>*) {
  return (check_control<C, View>() && ...);
}
template <class View, class... E>
consteval bool check_ends(const std::variant<E...>*) {
  return (check_end<E, View>() && ...);
}

/// Refuses controls and end conditions that a run in `View` could not call.
template <class View, class Control, class End>
consteval bool check_stage(const LoadingStage<Control, End>*) {
  return check_controls<View>(static_cast<const Control*>(nullptr)) &&
         check_ends<View>(static_cast<const End*>(nullptr));
}

}  // namespace internal
}  // namespace riprap
