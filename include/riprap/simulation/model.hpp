// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which policies a simulator is made of.

#include <utility>

#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/contact/detection/evaluate_each_pair.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/simulation/model_parts.hpp>
#include <riprap/stress/operator_store/keep_all_operators.hpp>

namespace riprap {

/// All policies of a simulator. Every setter returns a model of a new type, in which one policy has
/// been exchanged and the others stay; what is not set is the paper's choice. A policy that breaks
/// a requirement of its role leaves the model as it was, so that this is the only error:
///
///     auto model = Model{}.criterion(MohrCoulomb{}).line_fit(WeightedX{});
template <class ContactPart = ContactModel<>, class MotionPart = MotionModel<>,
          class StressPart = StressModel<>, class BreakagePart = BreakageModel<>,
          class AccelerationPart = AccelerationModel<>, Execution Executor = Serial>
struct Model {
  ContactPart contact_model{};
  MotionPart motion_model{};
  StressPart stress_model{};
  BreakagePart breakage_model{};
  AccelerationPart acceleration_model{};
  Executor execution_policy{};

  /// How contacts turn geometry and motion into forces.
  template <class P>
  [[nodiscard]] auto contact_law(P policy) const {
    return with_contact<check_contact_law<P>()>([&](const auto& m) {
      return ContactModel{m.broad_phase, m.narrow_phase, std::move(policy), m.bond_law};
    });
  }
  /// How pairs of near bodies are found.
  template <class P>
  [[nodiscard]] auto broad_phase(P policy) const {
    return with_contact<check_broad_phase<P>()>([&](const auto& m) {
      return ContactModel{std::move(policy), m.narrow_phase, m.law, m.bond_law};
    });
  }
  /// How the contact of two rings is described.
  template <class P>
  [[nodiscard]] auto narrow_phase(P policy) const {
    return with_contact<check_narrow_phase<P>()>([&](const auto& m) {
      return ContactModel{m.broad_phase, std::move(policy), m.law, m.bond_law};
    });
  }
  /// What joins particles along common edges.
  template <class P>
  [[nodiscard]] auto bond_law(P policy) const {
    return with_contact<check_bond_law<P>()>([&](const auto& m) {
      return ContactModel{m.broad_phase, m.narrow_phase, m.law, std::move(policy)};
    });
  }

  /// How free bodies advance.
  template <class P>
  [[nodiscard]] auto integrator(P policy) const {
    return with_motion<check_integrator<P>()>([&](const auto& m) {
      return MotionModel{std::move(policy), m.damping, m.time_step, m.boundary, m.body_force};
    });
  }
  /// What takes energy out beside the contacts.
  template <class P>
  [[nodiscard]] auto damping(P policy) const {
    return with_motion<check_damping<P>()>([&](const auto& m) {
      return MotionModel{m.integrator, std::move(policy), m.time_step, m.boundary, m.body_force};
    });
  }
  /// How the time step is chosen.
  template <class P>
  [[nodiscard]] auto time_step(P policy) const {
    return with_motion<check_time_step<P>()>([&](const auto& m) {
      return MotionModel{m.integrator, m.damping, std::move(policy), m.boundary, m.body_force};
    });
  }
  /// What moves the driven bodies.
  template <class P>
  [[nodiscard]] auto boundary(P policy) const {
    return with_motion<check_boundary<P>()>([&](const auto& m) {
      return MotionModel{m.integrator, m.damping, m.time_step, std::move(policy), m.body_force};
    });
  }
  /// Gravity, or another acceleration of free bodies.
  template <class P>
  [[nodiscard]] auto body_force(P policy) const {
    return with_motion<check_body_force<P>()>([&](const auto& m) {
      return MotionModel{m.integrator, m.damping, m.time_step, m.boundary, std::move(policy)};
    });
  }

  /// How particles are cut into triangles.
  template <class P>
  [[nodiscard]] auto mesher(P policy) const {
    return with_stress<check_mesher<P>()>([&](const auto& m) {
      return StressModel{std::move(policy), m.element, m.plane_state, m.support};
    });
  }
  /// The finite element of a triangle.
  template <class P>
  [[nodiscard]] auto element(P policy) const {
    return with_stress<check_element<P>()>([&](const auto& m) {
      return StressModel{m.mesher, std::move(policy), m.plane_state, m.support};
    });
  }
  /// Plane stress or plane strain.
  template <class P>
  [[nodiscard]] auto plane_state(P policy) const {
    return with_stress<check_plane_state<P>()>([&](const auto& m) {
      return StressModel{m.mesher, m.element, std::move(policy), m.support};
    });
  }
  /// How a particle is supported in its finite-element model.
  template <class P>
  [[nodiscard]] auto support(P policy) const {
    return with_stress<check_support<P>()>([&](const auto& m) {
      return StressModel{m.mesher, m.element, m.plane_state, std::move(policy)};
    });
  }

  /// When an element fails.
  template <class P>
  [[nodiscard]] auto criterion(P policy) const {
    return with_breakage<check_criterion<P>()>([&](const auto& m) {
      return BreakageModel{std::move(policy), m.trigger,     m.line_fit,
                           m.splitter,        m.inheritance, m.check_every};
    });
  }
  /// When a particle breaks.
  template <class P>
  [[nodiscard]] auto trigger(P policy) const {
    return with_breakage<check_trigger<P>()>([&](const auto& m) {
      return BreakageModel{m.criterion, std::move(policy), m.line_fit,
                           m.splitter,  m.inheritance,     m.check_every};
    });
  }
  /// Where the crack runs.
  template <class P>
  [[nodiscard]] auto line_fit(P policy) const {
    return with_breakage<check_line_fit<P>()>([&](const auto& m) {
      return BreakageModel{m.criterion, m.trigger,     std::move(policy),
                           m.splitter,  m.inheritance, m.check_every};
    });
  }
  /// How a particle is cut, and when a cut is refused.
  template <class P>
  [[nodiscard]] auto splitter(P policy) const {
    return with_breakage<check_splitter<P>()>([&](const auto& m) {
      return BreakageModel{m.criterion,       m.trigger,     m.line_fit,
                           std::move(policy), m.inheritance, m.check_every};
    });
  }
  /// Initial velocities of pieces.
  template <class P>
  [[nodiscard]] auto inheritance(P policy) const {
    return with_breakage<check_inheritance<P>()>([&](const auto& m) {
      return BreakageModel{m.criterion, m.trigger,         m.line_fit,
                           m.splitter,  std::move(policy), m.check_every};
    });
  }

  /// When neighbours are searched anew. Changes no result, nor do the next three.
  template <class P>
  [[nodiscard]] auto neighbour_list(P policy) const {
    return with_acceleration<check_neighbour_list<P>()>([&](const auto& m) {
      return AccelerationModel{std::move(policy), m.detection, m.screening, m.operator_store};
    });
  }
  /// In which way the pairs of neighbours are evaluated.
  template <class P>
  [[nodiscard]] auto detection(P policy) const {
    return with_acceleration<check_detection<P>()>([&](const auto& m) {
      return AccelerationModel{m.neighbour_list, std::move(policy), m.screening, m.operator_store};
    });
  }
  /// Which particles are left out of a breakage pass.
  template <class P>
  [[nodiscard]] auto screening(P policy) const {
    return with_acceleration<check_screening<P>()>([&](const auto& m) {
      return AccelerationModel{m.neighbour_list, m.detection, std::move(policy), m.operator_store};
    });
  }
  /// Which influence operators stay in memory.
  template <class P>
  [[nodiscard]] auto operator_store(P policy) const {
    return with_acceleration<check_operator_store<P>()>([&](const auto& m) {
      return AccelerationModel{m.neighbour_list, m.detection, m.screening, std::move(policy)};
    });
  }

  /// Execution: one thread or several. Changes no result.
  template <class P>
  [[nodiscard]] auto execution(P policy) const {
    if constexpr (check_execution<P>())
      return of(contact_model, motion_model, stress_model, breakage_model, acceleration_model,
                std::move(policy));
    else
      return *this;
  }
  /// Nothing is skipped, batched or cached: the physics alone.
  [[nodiscard]] auto without_acceleration() const {
    return neighbour_list(RebuildEveryStep{})
        .detection(EvaluateEachPair{})
        .screening(EvaluateAll{})
        .operator_store(KeepAllOperators{});
  }
  /// Steps between two checks of every particle.
  [[nodiscard]] Model check_every(unsigned steps) const {
    Model copy = *this;
    copy.breakage_model.check_every = steps;
    return copy;
  }

  /// What results depend on: all but acceleration and execution.
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("contact", self.contact_model);
    visit("motion", self.motion_model);
    visit("stress", self.stress_model);
    visit("breakage", self.breakage_model);
  }

  /// Calls `validate()` of every policy that has one; throws InvalidInput.
  void validate() const {
    const auto all = [](const auto&... policies) { (riprap::validate(policies), ...); };
    all(contact_model.broad_phase, contact_model.narrow_phase, contact_model.law,
        contact_model.bond_law);
    all(motion_model.integrator, motion_model.damping, motion_model.time_step,
        motion_model.boundary, motion_model.body_force);
    all(stress_model.mesher, stress_model.element, stress_model.plane_state, stress_model.support);
    all(acceleration_model.neighbour_list, acceleration_model.detection,
        acceleration_model.screening, acceleration_model.operator_store, execution_policy);
    all(breakage_model.criterion, breakage_model.trigger, breakage_model.line_fit,
        breakage_model.splitter, breakage_model.inheritance);
    const double tensile_strength = breakage_model.criterion.tensile_strength();
    require(tensile_strength > 0, "criterion.tensile_strength()", tensile_strength,
            "must be above 0");
    require(breakage_model.check_every >= 1, "Model.check_every", breakage_model.check_every,
            "must be 1 or more");
  }

 private:
  template <class... Parts>
  [[nodiscard]] static Model<Parts...> of(Parts... parts) {
    return {std::move(parts)...};
  }
  // A model with the part that `make` builds from the present one; this one if the policy is
  // refused.
  template <bool accepted, class Make>
  [[nodiscard]] auto with_contact(Make make) const {
    if constexpr (accepted)
      return of(make(contact_model), motion_model, stress_model, breakage_model, acceleration_model,
                execution_policy);
    else
      return *this;
  }
  template <bool accepted, class Make>
  [[nodiscard]] auto with_motion(Make make) const {
    if constexpr (accepted)
      return of(contact_model, make(motion_model), stress_model, breakage_model, acceleration_model,
                execution_policy);
    else
      return *this;
  }
  template <bool accepted, class Make>
  [[nodiscard]] auto with_stress(Make make) const {
    if constexpr (accepted)
      return of(contact_model, motion_model, make(stress_model), breakage_model, acceleration_model,
                execution_policy);
    else
      return *this;
  }
  template <bool accepted, class Make>
  [[nodiscard]] auto with_breakage(Make make) const {
    if constexpr (accepted)
      return of(contact_model, motion_model, stress_model, make(breakage_model), acceleration_model,
                execution_policy);
    else
      return *this;
  }
  template <bool accepted, class Make>
  [[nodiscard]] auto with_acceleration(Make make) const {
    if constexpr (accepted)
      return of(contact_model, motion_model, stress_model, breakage_model, make(acceleration_model),
                execution_policy);
    else
      return *this;
  }
};

}  // namespace riprap
