// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <riprap/checkpoint/durable_file.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

namespace internal {

/// A file of the system, closed at the end.
struct Descriptor {
  Descriptor(const std::string& path, int flags) : number(::open(path.c_str(), flags, 0666)) {}
  ~Descriptor() {
    if (number >= 0) (void)::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number;
};

/// 0, or the errno of what failed.
[[nodiscard]] RIPRAP_INLINE int write_and_sync(const std::string& path,
                                               std::span<const std::byte> bytes) {
  const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
  if (file.number < 0) return errno;
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.number, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : EIO;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return ::fsync(file.number) == 0 ? 0 : errno;
}

RIPRAP_INLINE void sync_folder_of(const std::string& path) {
  // A file system that cannot do that for a folder has other means.
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const Descriptor held(folder.empty() ? "." : folder, O_RDONLY | O_CLOEXEC);
  if (held.number >= 0) (void)::fsync(held.number);
}

}  // namespace internal

RIPRAP_INLINE void sync_file(const std::string& path) {
  const internal::Descriptor file(path, O_RDONLY | O_CLOEXEC);
  if (file.number < 0 || ::fsync(file.number) != 0) internal::throw_cannot_write(path, errno);
  internal::sync_folder_of(path);
}

RIPRAP_INLINE void write_durable_file(const std::string& path, std::span<const std::byte> bytes) {
  namespace fs = std::filesystem;
  const std::string part = path + ".part";
  int failed = internal::write_and_sync(part, bytes);
  if (failed == 0 && std::rename(part.c_str(), path.c_str()) != 0) failed = errno;
  if (failed != 0) {
    std::error_code ignored;
    fs::remove(part, ignored);
    internal::throw_cannot_write(path, failed);
  }
  internal::sync_folder_of(path);
}

RIPRAP_INLINE std::vector<std::byte> read_whole_file(const std::string& path) {
  const internal::Descriptor file(path, O_RDONLY | O_CLOEXEC);
  std::vector<std::byte> bytes;
  int failed = file.number < 0 ? errno : 0;
  constexpr std::size_t block = std::size_t{1} << 20;
  for (std::size_t size = 0; failed == 0;) {
    bytes.resize(size + block);
    const ssize_t read = ::read(file.number, bytes.data() + size, block);
    if (read < 0 && errno != EINTR) failed = errno;
    if (read > 0) size += static_cast<std::size_t>(read);
    if (read != 0) continue;
    bytes.resize(size);
    return bytes;
  }
  throw InvalidInput("cannot read " + path + ": " + std::generic_category().message(failed));
}

}  // namespace riprap
