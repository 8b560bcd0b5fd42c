// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which policies a simulator is made of.

#include <utility>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/inheritance/rigid_field.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/contact/law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mesh/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/support/inertia_relief.hpp>

namespace riprap {

/// From poses to contact forces.
template <BroadPhase Broad = UniformGrid, NarrowPhase Narrow = OverlapChord,
          ContactLaw Law = LinearSpringCoulomb>
struct ContactModel {
  Broad broad_phase{};
  Narrow narrow_phase{};
  Law law{};
};
template <class B, class N, class L>
ContactModel(B, N, L) -> ContactModel<B, N, L>;

/// From forces to motion.
template <Integrator IntegratorT = SymplecticEuler, Damping DampingT = LocalDamping,
          TimeStepRule Step = MassFloor, Boundary BoundaryT = StrainField>
struct MotionModel {
  IntegratorT integrator{};
  DampingT damping{};
  Step time_step{};
  BoundaryT boundary{};
};
template <class I, class D, class T, class B>
MotionModel(I, D, T, B) -> MotionModel<I, D, T, B>;

/// From contact forces to the stress in every triangle of a particle.
template <Mesher Meshing = UniformMesher, Element ElementT = ConstantStrainTriangle,
          PlaneState Plane = PlaneStress, Support SupportT = InertiaRelief>
struct StressModel {
  Meshing mesher{};
  ElementT element{};
  Plane plane_state{};
  SupportT support{};
};
template <class M, class E, class P, class S>
StressModel(M, E, P, S) -> StressModel<M, E, P, S>;

/// Has it failed, along which line, into which pieces.
template <FailureCriterion Criterion = HoekBrown, BreakageTrigger Trigger = FailedElementRatio,
          LineFit Fit = WeightedXY, Splitter Split = StraightCut, Inheritance Inherit = RigidField>
struct BreakageModel {
  static constexpr bool never_fails = riprap::never_fails<Criterion>;

  Criterion criterion{};
  Trigger trigger{};
  Fit line_fit{};
  Split splitter{};
  Inherit inheritance{};
  unsigned check_every = 1;  ///< steps between checks
};
template <class C, class T, class F, class S, class I>
BreakageModel(C, T, F, S, I, unsigned) -> BreakageModel<C, T, F, S, I>;

/// All policies of a simulator. Every setter returns a model of a new type, in which one policy has
/// been exchanged and the others stay; what is not set is the paper's choice. A policy that breaks
/// a clause of its role leaves the model as it was, so that this is the only error:
///
///     auto model = Model{}.criterion(MohrCoulomb{}).line_fit(WeightedX{});
template <class ContactPart = ContactModel<>, class MotionPart = MotionModel<>,
          class StressPart = StressModel<>, class BreakagePart = BreakageModel<>,
          Execution Executor = Serial>
struct Model {
  ContactPart contact_model{};
  MotionPart motion_model{};
  StressPart stress_model{};
  BreakagePart breakage_model{};
  Executor execution_policy{};

  /// How contacts turn geometry and motion into forces.
  template <class Law>
  [[nodiscard]] auto contact(Law law) const {
    const auto& m = contact_model;
    if constexpr (check_contact_law<Law>())
      return with_contact(ContactModel{m.broad_phase, m.narrow_phase, std::move(law)});
    else
      return *this;
  }
  /// How pairs of near bodies are found.
  template <class Broad>
  [[nodiscard]] auto broad_phase(Broad broad) const {
    const auto& m = contact_model;
    if constexpr (check_broad_phase<Broad>())
      return with_contact(ContactModel{std::move(broad), m.narrow_phase, m.law});
    else
      return *this;
  }
  /// How the contact of two rings is described.
  template <class Narrow>
  [[nodiscard]] auto narrow_phase(Narrow narrow) const {
    const auto& m = contact_model;
    if constexpr (check_narrow_phase<Narrow>())
      return with_contact(ContactModel{m.broad_phase, std::move(narrow), m.law});
    else
      return *this;
  }

  /// How free bodies advance.
  template <class IntegratorT>
  [[nodiscard]] auto integrator(IntegratorT integrator) const {
    const auto& m = motion_model;
    if constexpr (check_integrator<IntegratorT>())
      return with_motion(MotionModel{std::move(integrator), m.damping, m.time_step, m.boundary});
    else
      return *this;
  }
  /// What takes energy out beside the contacts.
  template <class DampingT>
  [[nodiscard]] auto damping(DampingT damping) const {
    const auto& m = motion_model;
    if constexpr (check_damping<DampingT>())
      return with_motion(MotionModel{m.integrator, std::move(damping), m.time_step, m.boundary});
    else
      return *this;
  }
  /// How the time step is chosen.
  template <class Rule>
  [[nodiscard]] auto time_step(Rule rule) const {
    const auto& m = motion_model;
    if constexpr (check_time_step<Rule>())
      return with_motion(MotionModel{m.integrator, m.damping, std::move(rule), m.boundary});
    else
      return *this;
  }
  /// What moves the driven bodies.
  template <class BoundaryT>
  [[nodiscard]] auto boundary(BoundaryT boundary) const {
    const auto& m = motion_model;
    if constexpr (check_boundary<BoundaryT>())
      return with_motion(MotionModel{m.integrator, m.damping, m.time_step, std::move(boundary)});
    else
      return *this;
  }

  /// How particles are cut into triangles.
  template <class Meshing>
  [[nodiscard]] auto mesher(Meshing meshing) const {
    const auto& m = stress_model;
    if constexpr (check_mesher<Meshing>())
      return with_stress(StressModel{std::move(meshing), m.element, m.plane_state, m.support});
    else
      return *this;
  }
  /// What a triangle is.
  template <class ElementT>
  [[nodiscard]] auto element(ElementT element) const {
    const auto& m = stress_model;
    if constexpr (check_element<ElementT>())
      return with_stress(StressModel{m.mesher, std::move(element), m.plane_state, m.support});
    else
      return *this;
  }
  /// What the third direction does.
  template <class Plane>
  [[nodiscard]] auto plane_state(Plane plane) const {
    const auto& m = stress_model;
    if constexpr (check_plane_state<Plane>())
      return with_stress(StressModel{m.mesher, m.element, std::move(plane), m.support});
    else
      return *this;
  }
  /// What takes the rigid modes away.
  template <class SupportT>
  [[nodiscard]] auto support(SupportT support) const {
    const auto& m = stress_model;
    if constexpr (check_support<SupportT>())
      return with_stress(StressModel{m.mesher, m.element, m.plane_state, std::move(support)});
    else
      return *this;
  }

  /// When an element fails.
  template <class Criterion>
  [[nodiscard]] auto criterion(Criterion chosen) const {
    const auto& m = breakage_model;
    if constexpr (check_criterion<Criterion>())
      return with_breakage(BreakageModel{std::move(chosen), m.trigger, m.line_fit, m.splitter,
                                         m.inheritance, m.check_every});
    else
      return *this;
  }
  /// When a particle breaks.
  template <class Trigger>
  [[nodiscard]] auto trigger(Trigger chosen) const {
    const auto& m = breakage_model;
    if constexpr (check_trigger<Trigger>())
      return with_breakage(BreakageModel{m.criterion, std::move(chosen), m.line_fit, m.splitter,
                                         m.inheritance, m.check_every});
    else
      return *this;
  }
  /// Where the crack runs.
  template <class Fit>
  [[nodiscard]] auto line_fit(Fit fit) const {
    const auto& m = breakage_model;
    if constexpr (check_line_fit<Fit>())
      return with_breakage(BreakageModel{m.criterion, m.trigger, std::move(fit), m.splitter,
                                         m.inheritance, m.check_every});
    else
      return *this;
  }
  /// How a particle is cut, and when a cut is refused.
  template <class Split>
  [[nodiscard]] auto splitter(Split split) const {
    const auto& m = breakage_model;
    if constexpr (check_splitter<Split>())
      return with_breakage(BreakageModel{m.criterion, m.trigger, m.line_fit, std::move(split),
                                         m.inheritance, m.check_every});
    else
      return *this;
  }
  /// How pieces move at birth.
  template <class Inherit>
  [[nodiscard]] auto inheritance(Inherit inherit) const {
    const auto& m = breakage_model;
    if constexpr (check_inheritance<Inherit>())
      return with_breakage(BreakageModel{m.criterion, m.trigger, m.line_fit, m.splitter,
                                         std::move(inherit), m.check_every});
    else
      return *this;
  }
  /// Execution: one thread or several. Changes no result.
  template <class Chosen>
  [[nodiscard]] auto execution(Chosen chosen) const {
    if constexpr (check_execution<Chosen>())
      return Model<ContactPart, MotionPart, StressPart, BreakagePart, Chosen>{
          contact_model, motion_model, stress_model, breakage_model, std::move(chosen)};
    else
      return *this;
  }
  /// Steps between two checks of every particle.
  [[nodiscard]] Model check_every(unsigned steps) const {
    Model copy = *this;
    copy.breakage_model.check_every = steps;
    return copy;
  }

  /// Calls `validate()` of every policy that has one; throws InvalidInput.
  void validate() const {
    const auto all = [](const auto&... policies) { (riprap::validate(policies), ...); };
    all(contact_model.broad_phase, contact_model.narrow_phase, contact_model.law);
    all(motion_model.integrator, motion_model.damping, motion_model.time_step,
        motion_model.boundary);
    all(stress_model.mesher, stress_model.element, stress_model.plane_state, stress_model.support);
    all(execution_policy);
    all(breakage_model.criterion, breakage_model.trigger, breakage_model.line_fit,
        breakage_model.splitter, breakage_model.inheritance);
    const double tensile_strength = breakage_model.criterion.tensile_strength();
    require(tensile_strength > 0, "criterion.tensile_strength()", tensile_strength,
            "must be above 0");
    require(breakage_model.check_every >= 1, "Model.check_every", breakage_model.check_every,
            "must be 1 or more");
  }

 private:
  template <class Part>
  [[nodiscard]] auto with_contact(Part part) const {
    return Model<Part, MotionPart, StressPart, BreakagePart, Executor>{
        std::move(part), motion_model, stress_model, breakage_model, execution_policy};
  }
  template <class Part>
  [[nodiscard]] auto with_motion(Part part) const {
    return Model<ContactPart, Part, StressPart, BreakagePart, Executor>{
        contact_model, std::move(part), stress_model, breakage_model, execution_policy};
  }
  template <class Part>
  [[nodiscard]] auto with_stress(Part part) const {
    return Model<ContactPart, MotionPart, Part, BreakagePart, Executor>{
        contact_model, motion_model, std::move(part), breakage_model, execution_policy};
  }
  template <class Part>
  [[nodiscard]] auto with_breakage(Part part) const {
    return Model<ContactPart, MotionPart, StressPart, Part, Executor>{
        contact_model, motion_model, stress_model, std::move(part), execution_policy};
  }
};

}  // namespace riprap
