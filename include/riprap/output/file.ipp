// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include <riprap/output/file.hpp>

namespace riprap {

namespace internal {

RIPRAP_INLINE void throw_cannot_write(const std::string& path, int error) {
  throw SimulationError("cannot write " + path + ": " + std::generic_category().message(error));
}

RIPRAP_INLINE std::string padded_number(std::uint64_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(text.size() < digits ? digits - text.size() : 0, '0') + text;
}

/// 0, or the errno of what failed.
[[nodiscard]] RIPRAP_INLINE int write_and_flush(std::FILE* file, std::string_view text) {
  errno = 0;
  const bool written =
      std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  return written ? 0 : errno != 0 ? errno : EIO;
}

[[nodiscard]] RIPRAP_INLINE int write_and_close(const std::string& path, std::string_view text) {
  OpenFile file(std::fopen(path.c_str(), "wb"));
  if (!file) return errno;
  const int error = write_and_flush(file.get(), text);
  // Some file systems report a full disk only here.
  const bool closed = std::fclose(file.release()) == 0;
  return closed || error != 0 ? error : errno;
}

}  // namespace internal

RIPRAP_INLINE void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw SimulationError("cannot make the folder " + folder + ": " + error.message());
}

RIPRAP_INLINE void write_file(const std::string& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code error;
  // A link stays a link: its target is replaced.
  const fs::path linked = fs::canonical(path, error);
  const fs::path target = error ? fs::path(path) : linked;
  if (fs::exists(target, error) && !fs::is_regular_file(target, error)) {
    if (const int failed = internal::write_and_close(path, text))
      internal::throw_cannot_write(path, failed);
    return;
  }
  const std::string part = target.string() + ".part";
  int failed = internal::write_and_close(part, text);
  if (failed == 0) {
    fs::rename(part, target, error);
    failed = error.value();
  }
  if (failed == 0) return;
  fs::remove(part, error);
  internal::throw_cannot_write(path, failed);
}

RIPRAP_INLINE AppendedFile::AppendedFile(std::string path, OldFile old)
    : path_(std::move(path)),
      file_(std::fopen(path_.c_str(), old == OldFile::replace ? "wb" : "ab")) {
  if (!file_) internal::throw_cannot_write(path_, errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  std::fseek(file_.get(), 0, SEEK_END);
  size_ = std::max(0L, std::ftell(file_.get()));  // -1 of what has no positions
}

RIPRAP_INLINE void AppendedFile::clear() {
  std::error_code error;
  std::filesystem::resize_file(path_, 0, error);
  if (error || std::fseek(file_.get(), 0, SEEK_SET) != 0)
    internal::throw_cannot_write(path_, error ? error.value() : errno);
  size_ = 0;
}

RIPRAP_INLINE AppendedFile::AppendedFile(std::string path, std::uint64_t kept)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), "r+b")),
      size_(static_cast<long>(kept)) {
  if (!file_) internal::throw_cannot_write(path_, errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_, error);
  if (!error && size < kept)
    throw SimulationError(path_ + " has " + std::to_string(size) +
                          " bytes: " + std::to_string(kept) + " had been written");
  if (!error) std::filesystem::resize_file(path_, kept, error);
  if (error) internal::throw_cannot_write(path_, error.value());
  if (std::fseek(file_.get(), size_, SEEK_SET) != 0) internal::throw_cannot_write(path_, errno);
}

RIPRAP_INLINE void AppendedFile::append(std::string_view text) {
  if (const int failed = internal::write_and_flush(file_.get(), text)) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path_, ignored)) {
      std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(size_), ignored);
      std::fseek(file_.get(), size_, SEEK_SET);
    }
    internal::throw_cannot_write(path_, failed);
  }
  size_ += static_cast<long>(text.size());
}

}  // namespace riprap
