// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Writes a whole text file or says why not.

#include <fstream>
#include <string>
#include <string_view>

#include <riprap/core/errors.hpp>

namespace riprap {

/// Replaces the file at `path` by `text`; throws SimulationError if that fails.
inline void write_file(const std::string& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw SimulationError("cannot write " + path);
}

}  // namespace riprap
