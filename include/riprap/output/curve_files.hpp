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
  /// Replaces a file that is there by the line of names; throws SimulationError if that fails.
  CsvFile(const std::string& path, CsvColumns<Row> columns)
      : columns_(std::move(columns)), file_(path) {
    file_.append(csv_header(columns_));
  }

  /// Appends what follows the rows that are in the file already. Throws SimulationError if a row
  /// cannot be written; the file then ends with the row before.
  void append_new(const std::vector<Row>& rows) {
    for (; written_ < rows.size(); ++written_) file_.append(csv_line(columns_, rows[written_]));
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
  /// Throws SimulationError if a file cannot be written.
  CurveFiles(const Curve& curve, const std::filesystem::path& folder)
      : curve_(curve), points_((folder / "curve.csv").string(), curve_columns()),
        energy_((folder / "energy.csv").string(), energy_columns()),
        breakages_((folder / "breakages.csv").string(), breakage_columns()) {}
  CurveFiles(const Curve&&, const std::filesystem::path&) = delete;

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
