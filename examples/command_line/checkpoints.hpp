// SPDX-License-Identifier: BSL-1.0
#pragma once
// Runs that can be stopped and go on. Needs the library HDF5.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>

#include <riprap/checkpoint/checkpoint_folder.hpp>

#include "stop_signal.hpp"

namespace command_line {

inline std::filesystem::path checkpoint_folder(const std::filesystem::path& folder) {
  return folder / "checkpoints";
}

// What a run goes on with has to outlast a loss of power as its checkpoints do.
inline void write_parameters(const std::string& toml, const std::filesystem::path& folder) {
  riprap::write_durable_file((folder / "parameters.toml").string(), std::as_bytes(std::span(toml)));
}

// The options of a run, line by line of its parameters.toml: a checkpoint goes on with the same
// ones alone, but for one that may be another.
struct GivenOptions {
  std::string toml{};
  std::string free{};

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& /*self*/, auto&& /*visit*/) {}
  static void for_each_parameter(auto& self, auto&& visit) {
    std::istringstream lines(self.toml);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = line.find(" = ");
      const std::string name = line.substr(0, equals);
      if (equals != line.npos && !line.starts_with('#') && name != self.free)
        visit(name.c_str(), line.substr(equals + 3));
    }
  }
};

// Where and when a run is saved.
struct Saving {
  std::filesystem::path folder{};  // of its results
  std::uint64_t every = 0;         // steps between checkpoints; 0: at a signal alone
  GivenOptions given{};
  std::string resumed{};  // what --resume takes

  [[nodiscard]] riprap::CheckpointFolder checkpoints() const {
    return riprap::CheckpointFolder(checkpoint_folder(folder));
  }
};

// Goes on from the newest checkpoint.
template <class Run, class Sim, class... Observers>
void go_on(const Saving& saving, Run& run, Sim& sim, Observers&... observers) {
  const auto warn = [](const char* message) { std::fprintf(stderr, "warning: %s\n", message); };
  GivenOptions given = saving.given;
  const auto file = saving.checkpoints().read_newest(warn, sim, run, given, observers...);
  std::fprintf(stderr, "going on from %s\n", file.string().c_str());
}

// All steps of a run. A checkpoint is written every so many steps, at SIGUSR1, and at SIGINT and
// SIGTERM, which end the run.
template <class Run, class Sim, class... Observers>
void run_with_checkpoints(const Saving& saving, Run& run, Sim& sim, Observers&... observers) {
  while (run.advance()) {
    const bool stops = stop_signal != 0;
    const bool is_due = saving.every > 0 && sim.steps() % saving.every == 0;
    if (stops || is_due || checkpoint_signal != 0) {
      checkpoint_signal = 0;
      saving.checkpoints().write(sim, run, saving.given, observers...);
    }
    if (!stops) continue;
    std::fprintf(stderr, "stopped; --resume %s goes on\n", saving.resumed.c_str());
    run.stop();
  }
}

}  // namespace command_line
