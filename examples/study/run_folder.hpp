// SPDX-License-Identifier: BSL-1.0
#pragma once
// The folder of a run. While the run is made it is called NAME.part, and NAME once it is finished:
// what has the name is complete. One that failed is NAME.failed, with error.txt.

#include <filesystem>
#include <string>

#include "runs.hpp"

namespace run_study {

enum class RunState { missing, unfinished, failed, finished };
std::string to_text(RunState state);

class RunFolder {
 public:
  RunFolder(const std::filesystem::path& study, const Run& run);

  [[nodiscard]] RunState state() const;
  // Throws riprap::InvalidInput if what is there was made with other parameters than those of the
  // run: a study does not mix them.
  void check_parameters() const;

  [[nodiscard]] const std::filesystem::path& finished() const { return finished_; }
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  [[nodiscard]] const std::filesystem::path& failed() const { return failed_; }

  // The folder of a run to begin, with its parameters.toml in it; or of one to go on with. The
  // caller has the lock.
  void prepare() const;
  // Does it have a checkpoint to go on from?
  [[nodiscard]] bool has_checkpoint() const;
  void finish() const;
  // With the reason in error.txt.
  void fail(const std::string& reason) const;
  // Removes what a failed run has left.
  void forget_failure() const;

 private:
  std::string toml_;
  std::filesystem::path finished_;
  std::filesystem::path part_;
  std::filesystem::path failed_;
};

}  // namespace run_study
