// SPDX-License-Identifier: BSL-1.0
#include "run_folder.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>

namespace run_study {

namespace fs = std::filesystem;

namespace {

fs::path with_ending(fs::path path, const char* ending) { return path += ending; }

std::string text_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

// The first line of `found` that is not that of `wanted`, beside it.
std::string difference(const std::string& found, const std::string& wanted) {
  std::istringstream a(found);
  std::istringstream b(wanted);
  std::string line_a;
  std::string line_b;
  while (true) {
    const bool has_a = static_cast<bool>(std::getline(a, line_a));
    const bool has_b = static_cast<bool>(std::getline(b, line_b));
    if (!has_a) line_a.clear();
    if (!has_b) line_b.clear();
    if ((!has_a && !has_b) || line_a != line_b)
      return "'" + line_a + "' in place of '" + line_b + "'";
  }
}

}  // namespace

std::string to_text(RunState state) {
  switch (state) {
  case RunState::missing:
    return "missing";
  case RunState::unfinished:
    return "unfinished";
  case RunState::failed:
    return "failed";
  case RunState::finished:
    return "finished";
  }
  return {};
}

RunFolder::RunFolder(const fs::path& study, const Run& run)
    : toml_(run.toml), finished_(study / run.folder), part_(with_ending(finished_, ".part")),
      failed_(with_ending(finished_, ".failed")) {}

RunState RunFolder::state() const {
  if (fs::exists(finished_)) return RunState::finished;
  if (fs::exists(failed_)) return RunState::failed;
  return fs::exists(part_) ? RunState::unfinished : RunState::missing;
}

void RunFolder::check_parameters() const {
  for (const fs::path& folder : {finished_, failed_, part_}) {
    const std::string found = text_of(folder / "parameters.toml");
    // A run that is being made writes its file anew.
    if (found.empty() || found == toml_) continue;
    throw riprap::InvalidInput(folder.string() + " was made with other parameters than those of " +
                               "the table, " + difference(found, toml_) +
                               ": move it away, or choose another --out");
  }
}

void RunFolder::prepare() const {
  riprap::make_folder(part_);
  riprap::write_file(part_ / "parameters.toml", toml_);
}

bool RunFolder::has_checkpoint() const {
  std::error_code error;
  const fs::path folder = part_ / "checkpoints";
  return fs::is_directory(folder, error) && !fs::is_empty(folder, error);
}

void RunFolder::finish() const { fs::rename(part_, finished_); }

void RunFolder::fail(const std::string& reason) const {
  riprap::write_file(part_ / "error.txt", reason + "\n");
  fs::remove_all(failed_);
  fs::rename(part_, failed_);
}

void RunFolder::forget_failure() const { fs::remove_all(failed_); }

}  // namespace run_study
