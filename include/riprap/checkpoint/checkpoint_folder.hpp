// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A folder of checkpoints, of which the last two are kept. Needs the library HDF5.

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <riprap/checkpoint/checkpoint.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>

namespace riprap {

/// Checkpoints `checkpoint_000000012000.h5` and so on, named by the number of steps.
class CheckpointFolder {
 public:
  explicit CheckpointFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes a checkpoint and then removes those before the last two, and what a kill has left in
  /// the middle of writing. Makes the folder if it is not there. Throws SimulationError if one
  /// cannot be written.
  template <class Sim, class... Parts>
  void write(const Sim& sim, const Parts&... parts) const {
    make_folder(folder_.string());
    const std::string name = "checkpoint_" + internal::padded_number(sim.steps(), 12) + ".h5";
    write_checkpoint((folder_ / name).string(), sim, parts...);
    std::error_code ignored;
    const std::vector<std::filesystem::path> all = files();
    for (std::size_t k = 2; k < all.size(); ++k) std::filesystem::remove(all[k], ignored);
    for (const auto& part : found(".h5.part")) std::filesystem::remove(part, ignored);
  }

  /// Removes all checkpoints, and the folder if nothing else is in it.
  void clear() const {
    std::error_code ignored;
    for (const char* const ending : {".h5", ".h5.part"})
      for (const auto& file : found(ending)) std::filesystem::remove(file, ignored);
    std::filesystem::remove(folder_, ignored);  // fails, as it should, where something is left
  }

  /// Of all checkpoints in the folder, the newest first.
  [[nodiscard]] std::vector<std::filesystem::path> files() const { return found(".h5"); }

  /// Reads the newest checkpoint; of a damaged one `on_damaged(message)` is told, and the one
  /// before is read. Returns its file. Throws InvalidInput, as `read_checkpoint` does, and if there
  /// is none.
  template <class OnDamaged, class Sim, class... Parts>
  std::filesystem::path read_newest(OnDamaged&& on_damaged, Sim& sim, Parts&... parts) const {
    for (const std::filesystem::path& file : files()) {
      try {
        read_checkpoint(file.string(), sim, parts...);
        return file;
      } catch (const DamagedCheckpoint& error) {
        on_damaged(error.what());
      }
    }
    throw InvalidInput(folder_.string() + " has no checkpoint that can be read");
  }

 private:
  [[nodiscard]] std::vector<std::filesystem::path> found(const char* ending) const {
    std::vector<std::filesystem::path> all;
    std::error_code error;  // without a folder there are none
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("checkpoint_") && name.ends_with(ending)) all.push_back(entry.path());
    }
    std::sort(all.rbegin(), all.rend());
    return all;
  }

  std::filesystem::path folder_;
};

}  // namespace riprap
