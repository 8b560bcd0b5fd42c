// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Writes text files, whole or line by line, or says which one cannot be written and why.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

namespace internal {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// Throws SimulationError "cannot write PATH: REASON" with the reason of `error`, an errno.
[[noreturn, gnu::cold]] void throw_cannot_write(const std::string& path, int error);

/// A number in the name of a file, with zeros before it up to so many digits, so that names sort as
/// their numbers do.
[[nodiscard, gnu::cold]] std::string padded_number(std::uint64_t number, std::size_t digits);

}  // namespace internal

/// Makes a folder and those above it, unless it exists; throws SimulationError if that fails.
void make_folder(const std::string& folder);

/// Replaces the file at `path` by `text`. The text goes to `path` + ".part" first, which then takes
/// the place of `path`: a write that fails or is cut short leaves the old file as it was. What is
/// not a regular file, a device for example, is written to directly.
/// Throws SimulationError with the path and the system's reason if that fails.
void write_file(const std::string& path, std::string_view text);

/// What becomes of a file that is there already.
enum class OldFile {
  replace,  ///< by an empty one
  keep      ///< it grows
};

/// A file that grows: what was appended is in the file, also if the program is killed afterwards.
class AppendedFile {
 public:
  /// Throws SimulationError if the file cannot be opened.
  explicit AppendedFile(std::string path, OldFile old = OldFile::replace);
  /// Keeps the first `kept` bytes of a file that is there and removes the rest. Throws
  /// SimulationError if the file cannot be opened or is shorter.
  AppendedFile(std::string path, std::uint64_t kept);

  /// Throws SimulationError if the text cannot be written as a whole; the file then ends with what
  /// was appended before.
  void append(std::string_view text);

  /// Removes all that is in the file. Throws SimulationError if that fails.
  void clear();

 private:
  std::string path_;
  internal::OpenFile file_;
  long size_ = 0;  // of what was appended [bytes]
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/output/file.ipp>
#endif
