// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads text files line by line and tables of comma-separated values, with the file and the line
/// in every error.

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>

namespace riprap::internal {

/// Text without the blanks at its two ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// Throws InvalidInput "cannot read PATH: REASON" where the file cannot be opened.
[[nodiscard]] inline std::ifstream open_text(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw InvalidInput("cannot read " + path.string() + ": " +
                       std::generic_category().message(errno != 0 ? errno : EIO));
  return file;
}

/// The lines of a text that are neither blank nor a comment, which begins with #.
class LineReader {
 public:
  /// @param name of the file, for errors
  LineReader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

  /// Moves to the next line; false at the end of the text. Throws InvalidInput where reading fails.
  [[nodiscard]] bool next() {
    while (std::getline(in_, line_)) {
      ++number_;
      // Spreadsheets begin UTF-8 text with a byte order mark.
      if (number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      const std::string_view text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    if (in_.bad()) throw InvalidInput("cannot read " + name_ + ": is it a file of text?");
    return false;
  }
  [[nodiscard]] std::string_view line() const { return trimmed(line_); }
  [[nodiscard]] std::size_t number() const { return number_; }  ///< of the line, from 1
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Throws InvalidInput "NAME, line N: WHAT".
  [[noreturn, gnu::cold]] void fail(const std::string& what) const {
    throw InvalidInput(name_ + ", line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::istream& in_;
  std::string name_;
  std::string line_;
  std::size_t number_ = 0;
};

/// Rows of comma-separated cells under a header line that names the columns. No quotes.
class CsvReader {
 public:
  /// Reads the header. Throws InvalidInput unless it is `header`, but for blanks around the names.
  CsvReader(std::istream& in, std::string name, std::string_view header)
      : lines_(in, std::move(name)), header_(header), columns_(split(header)) {
    if (!lines_.next())
      throw InvalidInput(lines_.name() + ": empty: must begin with the header " + header_);
    if (split(lines_.line()) != columns_)
      lines_.fail("header '" + std::string(lines_.line()) + "': must be " + header_);
  }

  /// Moves to the next row; false at the end. Throws InvalidInput for another number of cells.
  [[nodiscard]] bool next() {
    if (!lines_.next()) return false;
    cells_ = split(lines_.line());
    if (cells_.size() != columns_.size())
      lines_.fail(std::to_string(cells_.size()) + " cells: must be " +
                  std::to_string(columns_.size()) + ", " + header_);
    return true;
  }
  [[nodiscard]] const std::string& text(std::size_t column) const { return cells_[column]; }

  /// Throws InvalidInput for a cell that is no finite number.
  [[nodiscard]] double number(std::size_t column) const {
    std::string_view cell = cells_[column];
    if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
    double value = 0;
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (read.ec != std::errc() || read.ptr != cell.data() + cell.size() || !std::isfinite(value))
      fail(column, "must be a finite number");
    return value;
  }

  /// Throws InvalidInput "NAME, line N: COLUMN = 'CELL': RULE".
  [[noreturn, gnu::cold]] void fail(std::size_t column, const std::string& rule) const {
    lines_.fail(columns_[column] + " = '" + cells_[column] + "': " + rule);
  }
  [[nodiscard]] const LineReader& lines() const { return lines_; }

 private:
  [[nodiscard]] static std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> cells;
    for (;;) {
      const std::size_t comma = line.find(',');
      cells.emplace_back(trimmed(line.substr(0, comma)));
      if (comma == std::string_view::npos) return cells;
      line.remove_prefix(comma + 1);
    }
  }

  LineReader lines_;
  std::string header_;
  std::vector<std::string> columns_;
  std::vector<std::string> cells_;
};

}  // namespace riprap::internal
