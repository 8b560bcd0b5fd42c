// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The curves of a test: everything measured, at each record.

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/measurement/fabric.hpp>
#include <riprap/measurement/fragments.hpp>
#include <riprap/measurement/porosity.hpp>
#include <riprap/measurement/stress_force_fabric.hpp>
#include <riprap/simulation/break_event.hpp>

namespace riprap {

/// One state of a test; SI units, strains and ratios as fractions. With bonds the particles
/// and their coordination are those of fragments, breakages are `breakages(sim)`, and the fabric is
/// that of all contacts.
struct CurvePoint {
  double axial_strain = 0;
  double volumetric_strain = 0;
  double porosity = 0;
  Stress2 stress;        ///< over the whole assembly [Pa]
  Stress2 inner_stress;  ///< over the inner ellipse of 0.65 of its extent [Pa]
  Coordination coordination;
  std::size_t particles = 0;
  std::size_t breakages = 0;
  Fabric fabric;
  double inertial_number = 0;  ///< with the present strain rate and mean stress
  double overlap_ratio = 0;    ///< mean overlap over mean diameter
  StateAverages state;
  std::size_t lost_particles = 0;
  EnergyTerms energy;           ///< since the start of shear, of a path the start of loading
  std::size_t stage_index = 0;  ///< in the path

  [[nodiscard]] double sin_phi() const { return riprap::sin_phi(stress); }
  [[nodiscard]] double inner_sin_phi() const { return riprap::sin_phi(inner_stress); }
  /// Right-hand sides of eqs 14 and 15, and the full relation with branch vectors, along axis 2.
  [[nodiscard]] double sin_phi_fabric() const { return sin_phi_from_fabric(fabric, axis_2); }
  [[nodiscard]] double sin_phi_fabric_simplified() const {
    return sin_phi_from_fabric_simplified(fabric, axis_2);
  }
  [[nodiscard]] double sin_phi_fabric_full() const {
    return riprap::sin_phi(stress_from_fabric(fabric));
  }
  [[nodiscard]] double energy_error() const {
    return energy.boundary_work == 0 ? 0 : energy.unclosed() / energy.boundary_work;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("axial_strain", self.axial_strain);
    visit("volumetric_strain", self.volumetric_strain);
    visit("porosity", self.porosity);
    visit("stress", self.stress);
    visit("inner_stress", self.inner_stress);
    visit("coordination", self.coordination);
    visit("particles", self.particles);
    visit("breakages", self.breakages);
    visit("fabric", self.fabric);
    visit("inertial_number", self.inertial_number);
    visit("overlap_ratio", self.overlap_ratio);
    visit("state", self.state);
    visit("lost_particles", self.lost_particles);
    visit("energy", self.energy);
    visit("stage_index", self.stage_index);
  }

 private:
  static constexpr double axis_2 = 0.5 * std::numbers::pi;
};

/// A break and where in the test it happened.
struct BiaxialBreak {
  Stage stage = Stage::shear;
  double axial_strain = 0;
  BreakEvent event;
  std::string stage_name{};  ///< in the path

  [[nodiscard]] std::string name() const {
    return stage_name.empty() ? to_text(stage) : stage_name;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("stage", self.stage);
    visit("axial_strain", self.axial_strain);
    visit("event", self.event);
    visit("stage_name", self.stage_name);
  }
};

/// An observer of a test that measures at each record and keeps the energy ledger of its loading.
class Curve {
 public:
  [[nodiscard]] const std::vector<CurvePoint>& points() const { return points_; }
  [[nodiscard]] const std::vector<BiaxialBreak>& breaks() const { return breaks_; }
  [[nodiscard]] std::size_t breakages_before_shear() const { return breakages_before_shear_; }

  /// The point with the largest sin phi; the curve must not be empty.
  [[nodiscard]] const CurvePoint& peak() const {
    return *std::max_element(points_.begin(), points_.end(), [](const auto& p, const auto& q) {
      return p.sin_phi() < q.sin_phi();
    });
  }

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    if (view.stage != Stage::loading || view.loading_stage > 0) return;
    ledger_.open(view.sim);
    breakages_before_shear_ = riprap::breakages(view.sim);
  }
  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    points_.push_back(measure(view));
  }
  template <class Sim>
  void record_break(const BiaxialView<Sim>& view, const BreakEvent& event) {
    breaks_.push_back({view.stage, view.axial_strain(), event, std::string(view.stage_name)});
  }

  template <class Sim>
  void before_forces(const Sim& sim) {
    ledger_.before_forces(sim);
  }
  template <class Sim>
  void after_forces(const Sim& sim) {
    ledger_.after_forces(sim);
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    ledger_.before_splits(sim);
  }
  template <class Sim>
  void after_splits(const Sim& sim) {
    ledger_.after_splits(sim);
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("points", self.points_);
    visit("breaks", self.breaks_);
    visit("ledger", self.ledger_);
    visit("breakages_before_shear", self.breakages_before_shear_);
  }

 private:
  template <class Sim>
  [[nodiscard]] CurvePoint measure(const BiaxialView<Sim>& view) const {
    constexpr double inner_share = 0.65;
    const Particles& particles = view.sim.particles();
    const auto& contacts = view.sim.contacts();
    const auto region = view.sim.boundary().region(particles);
    CurvePoint p;
    p.axial_strain = view.axial_strain();
    p.volumetric_strain = view.volumetric_strain();
    p.porosity = porosity(region, contacts);
    p.stress = average_stress(view.sim.interactions(), view.area, particles.thickness());
    p.inner_stress = average_stress_within(
        view.sim.interactions(), Ellipse{inner_share * Vec2(region.semi_axes()), centre_of(region)},
        particles.thickness());
    p.coordination = fragment_coordination(view.sim);
    p.particles = fragment_count(view.sim);
    p.breakages = riprap::breakages(view.sim) - breakages_before_shear_;
    p.fabric = fabric(contact_samples(contacts));
    p.inertial_number = inertial_number(view.strain_rate(), view.mean_diameter,
                                        particles.mean_density(), p.stress.mean());
    p.state = state_averages(view.sim);
    p.overlap_ratio = p.state.mean_overlap / view.mean_diameter;
    p.lost_particles = region.lost();
    p.energy = ledger_.terms(view.sim);
    p.stage_index = view.stage_index;
    return p;
  }

  std::vector<CurvePoint> points_;
  std::vector<BiaxialBreak> breaks_;
  EnergyLedger ledger_;
  std::size_t breakages_before_shear_ = 0;
};

}  // namespace riprap
