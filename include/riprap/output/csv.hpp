// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Tables as comma-separated values: one header line, SI units, fractions, numbers that read back
/// exactly.

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// Names and values of the columns of a table of `Row`s.
template <class Row>
using CsvColumns = std::vector<std::pair<std::string_view, std::function<std::string(const Row&)>>>;

/// The line of names.
template <class Row>
[[nodiscard, gnu::cold]] std::string csv_header(const CsvColumns<Row>& columns) {
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c)
    text += (c ? "," : "") + std::string(columns[c].first);
  return text + '\n';
}
/// The line of one row.
template <class Row>
[[nodiscard, gnu::cold]] std::string csv_line(const CsvColumns<Row>& columns, const Row& row) {
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c) text += (c ? "," : "") + columns[c].second(row);
  return text + '\n';
}
/// The table as text.
template <class Row>
[[nodiscard, gnu::cold]] std::string csv_text(const CsvColumns<Row>& columns,
                                              const std::vector<Row>& rows) {
  std::string text = csv_header(columns);
  for (const Row& row : rows) text += csv_line(columns, row);
  return text;
}

namespace internal {

template <class Row, class Value>
[[nodiscard]] std::function<std::string(const Row&)> cell(Value value) {
  return [value](const Row& row) {
    const auto v = std::invoke(value, row);
    if constexpr (std::is_integral_v<decltype(v)>)
      return std::to_string(v);
    else if constexpr (std::is_floating_point_v<decltype(v)>)
      return to_text(v);
    else
      return std::string(v);
  };
}

// Lambdas without captures become pointers, so that those with the same result share their cells:
// that saves compilers half a hundred of them.
template <class Row, class Value>
[[nodiscard]] CsvColumns<Row>::value_type column(std::string_view name, Value value) {
  if constexpr (requires { +value; })
    return {name, cell<Row>(+value)};
  else
    return {name, cell<Row>(value)};
}

}  // namespace internal

/// Columns of the curve, a row per record. Directions in rad from axis 1, stresses in Pa.
[[nodiscard, gnu::cold]] inline CsvColumns<CurvePoint> curve_columns() {
  using P = CurvePoint;
  const auto c = [](std::string_view name, auto value) { return internal::column<P>(name, value); };
  return {
      c("axial_strain", &P::axial_strain),
      c("volumetric_strain", &P::volumetric_strain),
      c("porosity", &P::porosity),
      c("sigma_11", [](const P& p) { return p.stress.s11; }),
      c("sigma_22", [](const P& p) { return p.stress.s22; }),
      c("sigma_12", [](const P& p) { return p.stress.s12; }),
      c("sin_phi", &P::sin_phi),
      c("sin_phi_inner", &P::inner_sin_phi),
      c("contacts_per_particle", [](const P& p) { return p.coordination.contacts_per_particle; }),
      c("coordination_number", [](const P& p) { return p.coordination.coordination_number; }),
      c("particles", &P::particles),
      c("breakages", &P::breakages),
      c("a", [](const P& p) { return p.fabric.normals.coefficient; }),
      c("a_n", [](const P& p) { return p.fabric.normal_forces.coefficient; }),
      c("a_t", [](const P& p) { return p.fabric.tangential_forces.coefficient; }),
      c("b_n", [](const P& p) { return p.fabric.normal_branches.coefficient; }),
      c("b_t", [](const P& p) { return p.fabric.tangential_branches.coefficient; }),
      c("theta_0", [](const P& p) { return p.fabric.normals.direction; }),
      c("theta_f", [](const P& p) { return p.fabric.normal_forces.direction; }),
      c("theta_t", [](const P& p) { return p.fabric.tangential_forces.direction; }),
      c("sin_phi_fabric", &P::sin_phi_fabric),
      c("sin_phi_fabric_simplified", &P::sin_phi_fabric_simplified),
      c("sin_phi_fabric_full", &P::sin_phi_fabric_full),
      c("inertial_number", &P::inertial_number),
      c("unbalanced_force", [](const P& p) { return p.state.unbalanced_force; }),
      c("overlap_ratio", &P::overlap_ratio),
      c("kinetic_ratio", [](const P& p) { return p.state.kinetic_ratio(); }),
      c("energy_error", &P::energy_error),
      c("lost_particles", &P::lost_particles),
  };
}

/// Columns of the energy ledger of shear, a row per record, in J.
[[nodiscard, gnu::cold]] inline CsvColumns<CurvePoint> energy_columns() {
  using P = CurvePoint;
  const auto term = [](std::string_view name, double EnergyTerms::*value) {
    return internal::column<P>(name, [value](const P& p) { return p.energy.*value; });
  };
  return {
      internal::column<P>("axial_strain", &P::axial_strain),
      term("boundary_work", &EnergyTerms::boundary_work),
      term("body_force_work", &EnergyTerms::body_force_work),
      term("kinetic", &EnergyTerms::kinetic),
      term("stored", &EnergyTerms::stored),
      term("slip", &EnergyTerms::slip),
      term("dashpot", &EnergyTerms::dashpot),
      term("damping", &EnergyTerms::damping),
      term("breakage", &EnergyTerms::breakage),
      term("law_residual", &EnergyTerms::law_residual),
      internal::column<P>("unclosed", [](const P& p) { return p.energy.unclosed(); }),
  };
}

/// Columns of the breaks of a biaxial test. The line is given by a point [m] and an angle [rad].
[[nodiscard, gnu::cold]] inline CsvColumns<BiaxialBreak> breakage_columns() {
  using B = BiaxialBreak;
  const auto c = [](std::string_view name, auto value) { return internal::column<B>(name, value); };
  return {
      c("step", [](const B& b) { return b.event.step; }),
      c("stage", [](const B& b) { return to_text(b.stage); }),
      c("axial_strain", &B::axial_strain),
      c("particle", [](const B& b) { return b.event.particle.id; }),
      c("parent",
        [](const B& b) {
          return b.event.particle.generation == 0 ? std::string()
                                                  : std::to_string(b.event.particle.parent);
        }),
      c("root", [](const B& b) { return b.event.particle.root; }),
      c("generation", [](const B& b) { return b.event.particle.generation; }),
      c("rat", [](const B& b) { return b.event.failures.ratio(); }),
      c("lowest_safety_factor", [](const B& b) { return b.event.failures.lowest_safety_factor; }),
      c("mode", [](const B& b) { return to_text(b.event.mode); }),
      c("line_x", [](const B& b) { return b.event.line.point.x(); }),
      c("line_y", [](const B& b) { return b.event.line.point.y(); }),
      c("line_angle",
        [](const B& b) {
          return std::atan2(b.event.line.direction.y(), b.event.line.direction.x());
        }),
      c("piece_1", [](const B& b) { return b.event.pieces[0]; }),
      c("piece_2", [](const B& b) { return b.event.pieces[1]; }),
      c("area_1", [](const B& b) { return b.event.areas[0]; }),
      c("area_2", [](const B& b) { return b.event.areas[1]; }),
  };
}

/// The whole tables.
[[nodiscard, gnu::cold]] inline std::string curve_csv(const Curve& curve) {
  return csv_text(curve_columns(), curve.points());
}
[[nodiscard, gnu::cold]] inline std::string energy_csv(const Curve& curve) {
  return csv_text(energy_columns(), curve.points());
}
[[nodiscard, gnu::cold]] inline std::string breakages_csv(const Curve& curve) {
  return csv_text(breakage_columns(), curve.breaks());
}

/// Writes curve_csv to a file; throws SimulationError if that fails.
inline void write_csv(const std::string& path, const Curve& curve) {
  write_file(path, curve_csv(curve));
}

}  // namespace riprap
