// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Where the work of the boundary goes, term by term.

#include <algorithm>
#include <array>
#include <utility>

#include <riprap/measurement/contact_sum.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Energy since the ledger was opened [J]:
/// boundary_work + body_force_work + load_work + added
///   = kinetic + stored + slip + dashpot + damping + breakage + bonds + law_residual + unclosed.
struct EnergyTerms {
  double boundary_work = 0;    ///< done by driven bodies, or by the shrinking of a periodic cell
  double body_force_work = 0;  ///< done by the body force
  double load_work = 0;        ///< done by external loads
  double added = 0;            ///< with bodies that were added, less those removed
  double kinetic = 0;          ///< change of kinetic energy of the free bodies
  double stored = 0;           ///< change of energy stored in contacts and bonds
  double slip = 0;             ///< lost in sliding
  double dashpot = 0;          ///< lost in contact dashpots
  double damping = 0;          ///< taken out by damping
  double breakage = 0;         ///< kinetic and stored energy that vanished when particles split
  double law_residual = 0;     ///< work of the forces that their laws' own energy does not explain
  double bonds = 0;            ///< lost in bonds, by damage and when they broke

  /// Spurious energy: work of contact and bond law that stored energy does not explain, and what
  /// splitting adds.
  [[nodiscard]] double made() const {
    return std::max(0.0, -law_residual) + std::max(0.0, -breakage);
  }
  /// What the terms leave over: an error of the bookkeeping or of the integrator.
  [[nodiscard]] double unclosed() const {
    return boundary_work + body_force_work + load_work + added - kinetic - stored - slip - dashpot -
           damping - breakage - bonds - law_residual;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("boundary_work", self.boundary_work);
    visit("body_force_work", self.body_force_work);
    visit("load_work", self.load_work);
    visit("added", self.added);
    visit("kinetic", self.kinetic);
    visit("stored", self.stored);
    visit("slip", self.slip);
    visit("dashpot", self.dashpot);
    visit("damping", self.damping);
    visit("breakage", self.breakage);
    visit("law_residual", self.law_residual);
    visit("bonds", self.bonds);
  }
};

/// An observer that keeps the ledger. Contact work is the trapezoid sum, contact by contact and
/// bond by bond, of the forces before and after each step over the motion in between; it is
/// independent of the work that the simulation books body by body, so that a force without its
/// opposite, a wrong lever arm or an unbooked loss shows up in `unclosed`.
class EnergyLedger {
 public:
  /// Starts anew from the present state.
  template <class Sim>
  void open(const Sim& sim) {
    terms_ = {};
    start_ = totals(sim);
    stored_ = start_.stored;
    slip_ = start_.slip;
    dashpot_ = start_.dashpot;
    bonds_ = start_.bonds;
    added_ = start_.added;
    is_open_ = true;
  }

  template <class Sim>
  void before_forces(const Sim& sim) {
    if (!is_open_) return;
    if (sim.work().added != added_) take_up_changes(sim);
    contact_work_ = 0.5 * contact_power(sim) * sim.time_step();
  }

  template <class Sim>
  void after_forces(const Sim& sim) {
    if (!is_open_) return;
    contact_work_ += 0.5 * contact_power(sim) * sim.time_step();
    const double stored = stored_energy_of(sim);
    const double slip = sim.contacts().friction_loss();
    const double dashpot = sim.contacts().viscous_loss();
    const double bonds = bond_loss(sim);
    terms_.law_residual -= contact_work_ + (stored - stored_) + (slip - slip_) +
                           (dashpot - dashpot_) + (bonds - bonds_);
    stored_ = stored;
    slip_ = slip;
    dashpot_ = dashpot;
    bonds_ = bonds;
  }

  template <class Sim>
  void before_splits(const Sim& sim) {
    if (is_open_) before_split_ = stored_ + kinetic_energy(sim.particles());
  }

  template <class Sim>
  void after_splits(const Sim& sim) {
    if (!is_open_) return;
    stored_ = stored_energy_of(sim);
    // A contact that carries less than before may slip at once; that has a term of its own.
    const double slip = std::exchange(slip_, sim.contacts().friction_loss());
    const double dashpot = std::exchange(dashpot_, sim.contacts().viscous_loss());
    const double bonds = std::exchange(bonds_, bond_loss(sim));
    terms_.breakage += before_split_ - stored_ - kinetic_energy(sim.particles()) - (slip_ - slip) -
                       (dashpot_ - dashpot) - (bonds_ - bonds);
  }

  /// The terms as of now.
  template <class Sim>
  [[nodiscard]] EnergyTerms terms(const Sim& sim) const {
    EnergyTerms t = terms_;
    const Totals now = totals(sim);
    t.boundary_work = now.boundary - start_.boundary;
    t.body_force_work = now.body_force - start_.body_force;
    t.load_work = now.load - start_.load;
    t.added = now.added - start_.added;
    t.damping = now.damping - start_.damping;
    t.kinetic = now.kinetic - start_.kinetic;
    t.stored = now.stored - start_.stored;
    t.slip = now.slip - start_.slip;
    t.dashpot = now.dashpot - start_.dashpot;
    t.bonds = now.bonds - start_.bonds;
    return t;
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("terms", self.terms_);
    visit("start", self.start_);
    visit("stored", self.stored_);
    visit("slip", self.slip_);
    visit("dashpot", self.dashpot_);
    visit("bonds", self.bonds_);
    visit("added", self.added_);
    visit("contact_work", self.contact_work_);
    visit("before_split", self.before_split_);
    visit("is_open", self.is_open_);
  }

 private:
  struct Totals {
    double boundary = 0;
    double body_force = 0;
    double load = 0;
    double added = 0;
    double damping = 0;
    double kinetic = 0;
    double stored = 0;
    double slip = 0;
    double dashpot = 0;
    double bonds = 0;

    static void for_each_field(auto& self, auto&& visit) {
      visit("boundary", self.boundary);
      visit("body_force", self.body_force);
      visit("load", self.load);
      visit("added", self.added);
      visit("damping", self.damping);
      visit("kinetic", self.kinetic);
      visit("stored", self.stored);
      visit("slip", self.slip);
      visit("dashpot", self.dashpot);
      visit("bonds", self.bonds);
    }
  };

  template <class Sim>
  [[nodiscard]] static Totals totals(const Sim& sim) {
    return {sim.work().boundary,
            sim.work().body_force,
            sim.work().load,
            sim.work().added,
            sim.work().damping,
            kinetic_energy(sim.particles()),
            stored_energy_of(sim),
            sim.contacts().friction_loss(),
            sim.contacts().viscous_loss(),
            bond_loss(sim)};
  }

  // Bodies were added or removed since the last step, which is not the work of contacts.
  template <class Sim>
  void take_up_changes(const Sim& sim) {
    added_ = sim.work().added;
    stored_ = stored_energy_of(sim);
    slip_ = sim.contacts().friction_loss();
    dashpot_ = sim.contacts().viscous_loss();
    bonds_ = bond_loss(sim);
  }

  // Power of all forces of contacts and bonds on both bodies of each [W].
  template <class Sim>
  [[nodiscard]] static double contact_power(const Sim& sim) {
    double power = sum_over_contacts<1>(sim.contacts(), [&](const auto& c) {
      return std::array{c.force_on_b().dot(sim.contacts().relative_velocity(c, sim.particles()))};
    })[0];
    if constexpr (has_bonds<Sim>)
      power += sim.bonds().power(sim.particles(), sim.contacts().domain());
    return power;
  }

  EnergyTerms terms_;
  Totals start_;
  double stored_ = 0;
  double slip_ = 0;
  double dashpot_ = 0;
  double bonds_ = 0;
  double added_ = 0;
  double contact_work_ = 0;
  double before_split_ = 0;
  bool is_open_ = false;
};

}  // namespace riprap
