// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Warns when a quantity leaves the range in which a biaxial test is meaningful.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/experiment/check_table.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/material/rocks.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/measurement/porosity.hpp>

namespace riprap {

/// Ends of the ranges.
struct Limits {
  double stiffness_level = 0.05;   ///< kappa; above: particles too soft
  double inertial_number = 1e-3;   ///< above: not quasi-static
  double overlap_ratio = 0.05;     ///< mean overlap over mean diameter; above: particles too soft
  double kinetic_ratio = 0.02;     ///< kinetic over stored energy, after 1 % strain
  double unbalanced_force = 0.15;  ///< mean resultant over mean contact force, after 1 % strain
  double time_step_ratio = 0.25;   ///< dt over sqrt(m / k) of the lightest body
  double least_stiffness_level = 1e-6;  ///< kappa; below: the run takes too long, or wrong units
  /// Confining pressure over the criterion's uniaxial compressive strength; above: all particles
  /// fail at once, or wrong units.
  double pressure_over_strength = 0.5;
  double smallest_diameter = 1e-5;  ///< mean diameter [m]; below: wrong units
  double largest_diameter = 2;      ///< [m]; above: wrong units
  double thickness_ratio = 10;      ///< thickness over mean diameter, or one over it
  double porosity = 0;              ///< below: the solid area exceeds the region
  double confinement_error = 0.05;  ///< of the mean lateral stress in shear
  double saturated_share = 0.05;    ///< steps of shear with the servo's rate at its limit
  double energy_made = 0.05;        ///< by contact law and splitting, over the work put in
  double lost_particles = 0;        ///< free particles outside the boundary
};

/// An observer of a test that keeps the worst value of every number beside its limit, and
/// collects a warning the first time that one is out of range.
class ValidityCheck {
 public:
  explicit ValidityCheck(const Limits& limits = {}) : limits_(limits) {}

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] const CheckTable& table() const { return table_; }

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    if (view.stage == Stage::compaction) check_input(view);
    if (view.stage != Stage::hydrostatic) return;
    check(view, relaxed_, stress(view).mean() / view.confining_pressure);
    check(view, kappa_, kappa(view));
  }

  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    const Particles& particles = view.sim.particles();
    const auto& contacts = view.sim.contacts();
    const auto region = view.sim.boundary().region(particles);
    const StateAverages state = state_averages(view.sim);
    check(view, inertia_,
          inertial_number(view.strain_rate(), view.mean_diameter, particles.mean_density(),
                          stress(view).mean()));
    check(view, overlap_, state.mean_overlap / view.mean_diameter);
    check(view, time_step_,
          time_step_ratio(view.sim.time_step(), particles, contacts.law().peak_stiffness()));
    check(view, lost_, static_cast<double>(region.lost()));
    check(view, porosity_, porosity(region, contacts));
    if (view.axial_strain() < 0.01) return;
    check(view, kinetic_, state.kinetic_ratio());
    check(view, unbalanced_, state.unbalanced_force);
  }

  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    if (view.stage == Stage::shear) {
      check(view, confinement_, std::abs(view.mean_confinement_error));
      check(view, saturated_, view.saturated_share);
    }
    check(view, missed_, view.reached_target || view.interrupted ? 0 : 1);
  }

  /// Energy that contact law and splitting have made since the start of shear, over the work that
  /// was put in: from an EnergyLedger, such as that of Curve.
  void check_energy(const EnergyTerms& energy, double axial_strain) {
    const double work = energy.boundary_work + energy.body_force_work;
    if (work > 0) check(made_, energy.made() / work, Stage::shear, axial_strain);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("warnings", self.warnings_);
    visit("table", self.table_);
  }

 private:
  template <class Sim>
  [[nodiscard]] static Stress2 stress(const BiaxialView<Sim>& view) {
    return average_stress(view.sim.interactions(), view.area, view.sim.particles().thickness());
  }

  template <class Sim>
  [[nodiscard]] static double kappa(const BiaxialView<Sim>& view) {
    return stiffness_level(view.confining_pressure, view.sim.particles().thickness(),
                           view.sim.contacts().law().peak_stiffness());
  }

  // The uniaxial compressive strength of the weakest rock [Pa].
  template <Criterion C>
  [[nodiscard]] static double least_strength(const C& criterion, const Rocks& rocks) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < rocks.size(); ++k) {
      const auto m = static_cast<MaterialIndex>(k);
      least = std::min(least, rocks[m].strength_factor *
                                  criterion_of(criterion, m).major_stress_at_failure(0));
    }
    return least;
  }

  // Before the first step, for what is wrong now costs hours.
  template <class Sim>
  [[gnu::cold]] void check_input(const BiaxialView<Sim>& view) {
    check(view, least_kappa_, kappa(view));
    if constexpr (requires { view.sim.model().breakage_model.criterion; }) {
      const auto& breakage = view.sim.model().breakage_model;
      check(view, strength_,
            view.confining_pressure / least_strength(breakage.criterion, view.sim.rocks()));
      if constexpr (requires { double{breakage.trigger.critical}; })
        check(view, critical_, breakage.trigger.critical);
    }
    check(view, small_, view.mean_diameter);
    check(view, large_, view.mean_diameter);
    const double thickness = view.sim.particles().thickness() / view.mean_diameter;
    check(view, thickness_, std::max(thickness, 1 / thickness));
  }

  template <class Sim>
  void check(const BiaxialView<Sim>& view, std::size_t row, double value) {
    check(row, value, view.stage, view.axial_strain(), view.stage_name);
  }
  void check(std::size_t row, double value, Stage stage, double axial_strain,
             std::string_view stage_name = {}) {
    std::string warning = table_.measure(row, value, stage, axial_strain, stage_name);
    if (!warning.empty()) warnings_.push_back(std::move(warning));
  }

  std::size_t at_most(const char* name, double limit, const char* reason) {
    return table_.add(name, true, limit, reason);
  }
  std::size_t at_least(const char* name, double limit, const char* reason) {
    return table_.add(name, false, limit, reason);
  }

  Limits limits_;
  std::vector<std::string> warnings_;
  CheckTable table_;
  // Rows of the table.
  std::size_t least_kappa_ = at_least("stiffness level kappa", limits_.least_stiffness_level,
                                      "is the confining pressure in Pa?");
  std::size_t strength_ = at_most("confining pressure over uniaxial strength",
                                  limits_.pressure_over_strength, "is the strength in Pa?");
  std::size_t critical_ =
      at_most("share of failed elements that breaks a particle", 1, "no particle can break");
  std::size_t small_ = at_least("mean diameter [m]", limits_.smallest_diameter, "is it in m?");
  std::size_t large_ = at_most("mean diameter [m]", limits_.largest_diameter, "is it in m?");
  std::size_t thickness_ = at_most("thickness over mean diameter, or its inverse",
                                   limits_.thickness_ratio, "are both in m?");
  std::size_t kappa_ = at_most("stiffness level kappa", limits_.stiffness_level,
                               "particles are too soft for the pressure");
  std::size_t relaxed_ = at_most("mean stress after relaxation over confining pressure", 1,
                                 "the sample is unloaded to the confining pressure");
  std::size_t missed_ = at_most("missed targets of stages", 0,
                                "its cap on steps ended the stage, or the servo did not hold");
  std::size_t inertia_ = at_most("inertial number", limits_.inertial_number, "not quasi-static");
  std::size_t overlap_ = at_most("mean overlap over mean diameter", limits_.overlap_ratio,
                                 "particles are too soft for the stress");
  std::size_t time_step_ = at_most("time step over sqrt(m/k)", limits_.time_step_ratio,
                                   "too long for the lightest particle");
  std::size_t lost_ = at_most("particles outside the boundary", limits_.lost_particles,
                              "the boundary no longer encloses the sample");
  std::size_t porosity_ =
      at_least("porosity", limits_.porosity, "the boundary no longer encloses the sample");
  std::size_t kinetic_ =
      at_most("kinetic over stored energy", limits_.kinetic_ratio, "not in equilibrium");
  std::size_t unbalanced_ =
      at_most("unbalanced force", limits_.unbalanced_force, "not in equilibrium");
  std::size_t confinement_ = at_most("mean error of the lateral stress", limits_.confinement_error,
                                     "the servo has lost the sample");
  std::size_t saturated_ = at_most("share of steps with the servo at its limit",
                                   limits_.saturated_share, "the servo has lost the sample");
  std::size_t made_ = at_most("energy made by contact law and splitting over the work put in",
                              limits_.energy_made, "the contact law does not conserve energy");
};

}  // namespace riprap
