// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Files that are on the disk as a whole, or not at all, also after a loss of power.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <riprap/core/linkage.hpp>

namespace riprap {

/// Replaces the file at `path` by `bytes`: they are written to `path` + ".part", brought to the
/// disk (fsync), and that file takes the place of `path`; then the folder is brought to the disk.
/// Needs a POSIX system. Throws SimulationError with the path and the system's reason if that
/// fails; what stood at `path` is then as it was.
void write_durable_file(const std::string& path, std::span<const std::byte> bytes);

/// Brings what has been written to the file at `path`, and its entry in the folder, to the disk.
/// Throws SimulationError with the path and the system's reason if that fails.
void sync_file(const std::string& path);

/// All of a file. Throws InvalidInput with the path and the system's reason if that fails.
[[nodiscard]] std::vector<std::byte> read_whole_file(const std::string& path);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/checkpoint/durable_file.ipp>
#endif
