// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The tables of a test as files that grow with it.

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <riprap/experiment/curve.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// A table in a file, to which rows are appended.
template <class Row>
class CsvFile {
 public:
  /// Replaces a file that is there by the line of names, or keeps it until `write_anew`; throws
  /// SimulationError if that fails.
  CsvFile(const std::string& path, CsvColumns<Row> columns, OldFile old = OldFile::replace)
      : columns_(std::move(columns)), file_(path, old) {
    if (old == OldFile::replace) file_.append(csv_header(columns_));
  }

  /// Appends what follows the rows that are in the file already. Throws SimulationError if a row
  /// cannot be written; the file then ends with the row before.
  void append_new(const std::vector<Row>& rows) {
    for (; written_ < rows.size(); ++written_) file_.append(csv_line(columns_, rows[written_]));
  }
  /// Replaces what is in the file by these rows.
  void write_anew(const std::vector<Row>& rows) {
    file_.clear();
    file_.append(csv_header(columns_));
    written_ = 0;
    append_new(rows);
  }

 private:
  CsvColumns<Row> columns_;
  AppendedFile file_;
  std::size_t written_ = 0;
};

/// An observer of a test that writes `curve.csv`, `energy.csv` and `breakages.csv` into a
/// folder: a row is in its file as soon as it is recorded, also if the program is killed
/// afterwards. Give it to the test after the Curve whose rows it writes:
///
///     Curve curve;
///     CurveFiles files{curve, "out"};
///     BiaxialTest{}.run(sim, curve, files);
class CurveFiles {
 public:
  /// The folder must exist, and the curve must outlive the observer.
  /// @param old what becomes of files that are there; those of a run that goes on are kept until a
  /// checkpoint has been read
  /// @param with_bonds a column of what was lost in bonds, for a model with a bond law
  /// Throws SimulationError if a file cannot be written.
  CurveFiles(const Curve& curve, const std::filesystem::path& folder,
             OldFile old = OldFile::replace, bool with_bonds = false)
      : curve_(curve), points_((folder / "curve.csv").string(), curve_columns(), old),
        energy_((folder / "energy.csv").string(), energy_columns(with_bonds), old),
        breakages_((folder / "breakages.csv").string(), breakage_columns(), old) {}
  CurveFiles(const Curve&&, const std::filesystem::path&, OldFile = OldFile::replace,
             bool = false) = delete;

  template <class View>
  void record(const View& /*view*/) {
    append_new();
  }
  template <class View, class Event>
  void record_break(const View& /*view*/, const Event& /*event*/) {
    append_new();
  }
  template <class View>
  void end_stage(const View& /*view*/) {
    append_new();
  }

  /// The rows are those of the curve.
  static void for_each_field(auto&, auto&&) {}
  /// The curve has been read from a checkpoint: its rows replace those of the files.
  void restored() {
    points_.write_anew(curve_.points());
    energy_.write_anew(curve_.points());
    breakages_.write_anew(curve_.breaks());
  }

 private:
  void append_new() {
    points_.append_new(curve_.points());
    energy_.append_new(curve_.points());
    breakages_.append_new(curve_.breaks());
  }

  const Curve& curve_;
  CsvFile<CurvePoint> points_;
  CsvFile<CurvePoint> energy_;
  CsvFile<BiaxialBreak> breakages_;
};

}  // namespace riprap
