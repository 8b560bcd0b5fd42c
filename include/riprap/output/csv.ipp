// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>

#include <riprap/core/errors.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

namespace internal {

[[nodiscard]] inline std::string cell(double value) { return to_text(value); }
template <std::integral Number>
[[nodiscard]] std::string cell(Number value) {
  return std::to_string(value);
}
[[nodiscard]] inline std::string cell(std::string value) { return value; }
// Empty where there is no particle.
[[nodiscard]] inline std::string id_cell(ParticleId id) {
  return id == no_particle ? std::string() : std::to_string(id);
}

// Lambdas without captures, as pointers: a std::function of each would take compilers long.
template <class Row>
struct NamedCell {
  std::string_view name;
  std::string (*text)(const Row&);
};
template <class Row, std::size_t count>
[[nodiscard]] CsvColumns<Row> named_columns(const NamedCell<Row> (&cells)[count]) {
  CsvColumns<Row> columns;
  for (const NamedCell<Row>& c : cells) columns.emplace_back(c.name, c.text);
  return columns;
}

}  // namespace internal

RIPRAP_INLINE CsvColumns<CurvePoint> curve_columns() {
  using internal::cell;
  using P = CurvePoint;
  static constexpr internal::NamedCell<CurvePoint> cells[]{
      {"axial_strain", [](const P& p) { return cell(p.axial_strain); }},
      {"volumetric_strain", [](const P& p) { return cell(p.volumetric_strain); }},
      {"porosity", [](const P& p) { return cell(p.porosity); }},
      {"sigma_11", [](const P& p) { return cell(p.stress.s11); }},
      {"sigma_22", [](const P& p) { return cell(p.stress.s22); }},
      {"sigma_12", [](const P& p) { return cell(p.stress.s12); }},
      {"sin_phi", [](const P& p) { return cell(p.sin_phi()); }},
      {"sin_phi_inner", [](const P& p) { return cell(p.inner_sin_phi()); }},
      {"contacts_per_particle",
       [](const P& p) { return cell(p.coordination.contacts_per_particle); }},
      {"coordination_number", [](const P& p) { return cell(p.coordination.coordination_number); }},
      {"particles", [](const P& p) { return cell(p.particles); }},
      {"breakages", [](const P& p) { return cell(p.breakages); }},
      {"a", [](const P& p) { return cell(p.fabric.normals.coefficient); }},
      {"a_n", [](const P& p) { return cell(p.fabric.normal_forces.coefficient); }},
      {"a_t", [](const P& p) { return cell(p.fabric.tangential_forces.coefficient); }},
      {"b_n", [](const P& p) { return cell(p.fabric.normal_branches.coefficient); }},
      {"b_t", [](const P& p) { return cell(p.fabric.tangential_branches.coefficient); }},
      {"theta_0", [](const P& p) { return cell(p.fabric.normals.direction); }},
      {"theta_f", [](const P& p) { return cell(p.fabric.normal_forces.direction); }},
      {"theta_t", [](const P& p) { return cell(p.fabric.tangential_forces.direction); }},
      {"sin_phi_fabric", [](const P& p) { return cell(p.sin_phi_fabric()); }},
      {"sin_phi_fabric_simplified", [](const P& p) { return cell(p.sin_phi_fabric_simplified()); }},
      {"sin_phi_fabric_full", [](const P& p) { return cell(p.sin_phi_fabric_full()); }},
      {"inertial_number", [](const P& p) { return cell(p.inertial_number); }},
      {"unbalanced_force", [](const P& p) { return cell(p.state.unbalanced_force); }},
      {"overlap_ratio", [](const P& p) { return cell(p.overlap_ratio); }},
      {"kinetic_ratio", [](const P& p) { return cell(p.state.kinetic_ratio()); }},
      {"energy_error", [](const P& p) { return cell(p.energy_error()); }},
      {"lost_particles", [](const P& p) { return cell(p.lost_particles); }},
      {"stage_index", [](const P& p) { return cell(p.stage_index); }},
  };
  return internal::named_columns(cells);
}

RIPRAP_INLINE CsvColumns<CurvePoint> energy_columns(bool with_bonds) {
  using internal::cell;
  using P = CurvePoint;
  static constexpr internal::NamedCell<CurvePoint> cells[]{
      {"axial_strain", [](const P& p) { return cell(p.axial_strain); }},
      {"boundary_work", [](const P& p) { return cell(p.energy.boundary_work); }},
      {"body_force_work", [](const P& p) { return cell(p.energy.body_force_work); }},
      {"kinetic", [](const P& p) { return cell(p.energy.kinetic); }},
      {"stored", [](const P& p) { return cell(p.energy.stored); }},
      {"slip", [](const P& p) { return cell(p.energy.slip); }},
      {"dashpot", [](const P& p) { return cell(p.energy.dashpot); }},
      {"damping", [](const P& p) { return cell(p.energy.damping); }},
      {"breakage", [](const P& p) { return cell(p.energy.breakage); }},
      {"law_residual", [](const P& p) { return cell(p.energy.law_residual); }},
      {"unclosed", [](const P& p) { return cell(p.energy.unclosed()); }},
  };
  CsvColumns<CurvePoint> columns = internal::named_columns(cells);
  if (with_bonds) columns.emplace_back("bonds", [](const P& p) { return cell(p.energy.bonds); });
  return columns;
}

RIPRAP_INLINE CsvColumns<BiaxialBreak> breakage_columns() {
  using internal::cell;
  using internal::id_cell;
  using B = BiaxialBreak;
  static constexpr internal::NamedCell<BiaxialBreak> cells[]{
      {"step", [](const B& b) { return cell(b.event.step); }},
      {"stage", [](const B& b) { return cell(b.name()); }},
      {"axial_strain", [](const B& b) { return cell(b.axial_strain); }},
      {"particle", [](const B& b) { return cell(b.event.particle.id); }},
      {"parent", [](const B& b) { return id_cell(b.event.particle.parent); }},
      {"root", [](const B& b) { return cell(b.event.particle.root); }},
      {"generation", [](const B& b) { return cell(b.event.particle.generation); }},
      {"rat", [](const B& b) { return cell(b.event.failures.ratio()); }},
      {"lowest_safety_factor",
       [](const B& b) { return cell(b.event.failures.lowest_safety_factor); }},
      {"mode", [](const B& b) { return cell(to_text(b.event.mode)); }},
      {"line_x", [](const B& b) { return cell(b.event.line.point.x()); }},
      {"line_y", [](const B& b) { return cell(b.event.line.point.y()); }},
      {"line_angle",
       [](const B& b) {
         return cell(std::atan2(b.event.line.direction.y(), b.event.line.direction.x()));
       }},
      {"piece_1", [](const B& b) { return id_cell(b.event.pieces[0]); }},
      {"piece_2", [](const B& b) { return id_cell(b.event.pieces[1]); }},
      {"area_1", [](const B& b) { return cell(b.event.areas[0]); }},
      {"area_2", [](const B& b) { return cell(b.event.areas[1]); }},
  };
  return internal::named_columns(cells);
}

RIPRAP_INLINE std::string curve_csv(const Curve& curve) {
  return csv_text(curve_columns(), curve.points());
}

RIPRAP_INLINE std::string energy_csv(const Curve& curve, bool with_bonds) {
  return csv_text(energy_columns(with_bonds), curve.points());
}

RIPRAP_INLINE std::string breakages_csv(const Curve& curve) {
  return csv_text(breakage_columns(), curve.breaks());
}

RIPRAP_INLINE void write_csv(const std::string& path, const Curve& curve) {
  write_file(path, curve_csv(curve));
}

}  // namespace riprap
