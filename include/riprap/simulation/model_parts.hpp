// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The parts of a model: groups of policies.

#include <riprap/bond/bond_law/no_bonds.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/inheritance/rigid_field.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <riprap/dynamics/body_force/uniform_body_force.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <riprap/simulation/default_acceleration.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/support/inertia_relief.hpp>

namespace riprap {

/// From poses to the forces of contacts and bonds.
template <BroadPhase BroadT = UniformGrid, NarrowPhase NarrowT = OverlapMoments,
          ContactLaw LawT = EnergyConservingSpring, BondLaw BondT = NoBonds>
struct ContactModel {
  BroadT broad_phase{};
  NarrowT narrow_phase{};
  LawT law{};
  [[no_unique_address]] BondT bond_law{};

  /// But for the broad phase, on which no result depends.
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("narrow_phase", self.narrow_phase);
    visit("contact_law", self.law);
    if constexpr (makes_bonds<BondT>) visit("bond_law", self.bond_law);
  }
};
template <class B, class N, class L>
ContactModel(B, N, L) -> ContactModel<B, N, L>;
template <class B, class N, class L, class K>
ContactModel(B, N, L, K) -> ContactModel<B, N, L, K>;

/// From forces to motion.
template <Integrator IntegratorT = SymplecticEuler, Damping DampingT = LocalDamping,
          TimeStep TimeStepT = MassFloor, Boundary BoundaryT = StrainField,
          BodyForce BodyForceT = UniformBodyForce>
struct MotionModel {
  IntegratorT integrator{};
  DampingT damping{};
  TimeStepT time_step{};
  BoundaryT boundary{};
  BodyForceT body_force{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("integrator", self.integrator);
    visit("damping", self.damping);
    visit("time_step", self.time_step);
    visit("boundary", self.boundary);
    visit("body_force", self.body_force);
  }
};
template <class I, class D, class T, class B, class F>
MotionModel(I, D, T, B, F) -> MotionModel<I, D, T, B, F>;

/// From contact forces to the stress in every triangle of a particle.
template <Mesher MesherT = UniformMesher, Element ElementT = ConstantStrainTriangle,
          PlaneState PlaneStateT = PlaneStress, Support SupportT = InertiaRelief>
struct StressModel {
  MesherT mesher{};
  ElementT element{};
  PlaneStateT plane_state{};
  SupportT support{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("mesher", self.mesher);
    visit("element", self.element);
    visit("plane_state", self.plane_state);
    visit("support", self.support);
  }
};
template <class M, class E, class P, class S>
StressModel(M, E, P, S) -> StressModel<M, E, P, S>;

/// Has it failed, along which line, into which pieces.
template <Criterion CriterionT = HoekBrown, Trigger TriggerT = FailedElementRatio,
          LineFit LineFitT = WeightedXY, Splitter SplitterT = StraightCut,
          Inheritance InheritanceT = RigidField>
struct BreakageModel {
  static constexpr bool never_fails = riprap::never_fails<CriterionT>;

  CriterionT criterion{};
  TriggerT trigger{};
  LineFitT line_fit{};
  SplitterT splitter{};
  InheritanceT inheritance{};
  unsigned check_every = 1;  ///< steps between checks

  static void for_each_field(auto& self, auto&& visit) {
    visit("criterion", self.criterion);
    visit("trigger", self.trigger);
    visit("line_fit", self.line_fit);
    visit("splitter", self.splitter);
    visit("inheritance", self.inheritance);
    visit("check_every", self.check_every);
  }
};
template <class C, class T, class F, class S, class I>
BreakageModel(C, T, F, S, I, unsigned) -> BreakageModel<C, T, F, S, I>;

/// What only skips, batches or caches; no result depends on it. See acceleration/README.md.
template <NeighbourList ListT = DefaultNeighbourList, Detection DetectionT = DefaultDetection,
          Screening ScreeningT = DefaultScreening, OperatorStore StoreT = DefaultOperatorStore>
struct AccelerationModel {
  ListT neighbour_list{};
  DetectionT detection{};
  ScreeningT screening{};
  StoreT operator_store{};
};
template <class N, class D, class S, class O>
AccelerationModel(N, D, S, O) -> AccelerationModel<N, D, S, O>;

}  // namespace riprap
