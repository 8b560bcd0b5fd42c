// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Tables as comma-separated values: one header line, SI units, fractions, numbers that read back
/// exactly.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/experiment/curve.hpp>

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

/// Columns of the curve, a row per record. Directions in rad from axis 1, stresses in Pa.
[[nodiscard, gnu::cold]] CsvColumns<CurvePoint> curve_columns();

/// Columns of the energy ledger of shear, a row per record, in J.
/// @param with_bonds adds what was lost in bonds, for a model with a bond law
[[nodiscard, gnu::cold]] CsvColumns<CurvePoint> energy_columns(bool with_bonds = false);

/// Columns of the breaks of a biaxial test. The line is given by a point [m] and an angle [rad].
[[nodiscard, gnu::cold]] CsvColumns<BiaxialBreak> breakage_columns();

/// The whole tables.
[[nodiscard, gnu::cold]] std::string curve_csv(const Curve& curve);
[[nodiscard, gnu::cold]] std::string energy_csv(const Curve& curve, bool with_bonds = false);
[[nodiscard, gnu::cold]] std::string breakages_csv(const Curve& curve);

/// Writes curve_csv to a file; throws SimulationError if that fails.
void write_csv(const std::string& path, const Curve& curve);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/output/csv.ipp>
#endif
