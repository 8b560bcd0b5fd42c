// SPDX-License-Identifier: BSL-1.0
#pragma once
// A test that can be stopped and go on.

#include <cstdio>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>

#include <riprap/checkpoint/checkpoint_folder.hpp>

#include "../command_line/stop_signal.hpp"
#include "options.hpp"

inline std::filesystem::path checkpoint_folder(const std::filesystem::path& folder) {
  return folder / "checkpoints";
}

// What a run goes on with has to outlast a loss of power as its checkpoints do.
inline void write_parameters(const Options& o) {
  const std::filesystem::path file = std::filesystem::path(o.out) / "parameters.toml";
  riprap::write_durable_file(file.string(), std::as_bytes(std::span(o.toml)));
}

// The options of a run, line by line of its parameters.toml: a checkpoint goes on with the same
// ones alone, but for the strain that it is to reach.
struct GivenOptions {
  const std::string& toml;

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& /*self*/, auto&& /*visit*/) {}
  static void for_each_parameter(auto& self, auto&& visit) {
    std::istringstream lines(self.toml);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = line.find(" = ");
      const std::string name = line.substr(0, equals);
      if (equals != line.npos && !line.starts_with('#') && name != "strain")
        visit(name.c_str(), line.substr(equals + 3));
    }
  }
};

// Goes on from the newest checkpoint of the folder. Throws InvalidInput if it has gone past the
// axial strain of the options.
template <class Run, class Sim, class... Observers>
void resume(const Options& o, Run& run, Sim& sim, Observers&... observers) {
  const auto warn = [](const char* message) { std::fprintf(stderr, "warning: %s\n", message); };
  GivenOptions given{o.toml};
  const auto file = riprap::CheckpointFolder(checkpoint_folder(o.out))
                        .read_newest(warn, sim, run, given, observers...);
  if (run.view().stage == riprap::Stage::shear)
    riprap::require(o.test.axial_strain >= run.view().axial_strain(), "BiaxialTest.axial_strain",
                    o.test.axial_strain,
                    "must not be below that of the checkpoint, " +
                        riprap::to_text(run.view().axial_strain()));
  std::fprintf(stderr, "going on from %s\n", file.string().c_str());
}

// All steps of a test. A checkpoint is written every so many steps, at SIGUSR1, and at SIGINT and
// SIGTERM, which end the test.
template <class Run, class Sim, class... Observers>
void run_with_checkpoints(const Options& o, Run& run, Sim& sim, Observers&... observers) {
  const riprap::CheckpointFolder checkpoints(checkpoint_folder(o.out));
  const GivenOptions given{o.toml};
  while (run.advance()) {
    const bool stops = command_line::stop_signal != 0;
    const bool is_due = o.checkpoint_every > 0 && sim.steps() % o.checkpoint_every == 0;
    if (stops || is_due || command_line::checkpoint_signal != 0) {
      command_line::checkpoint_signal = 0;
      checkpoints.write(sim, run, given, observers...);
    }
    if (!stops) continue;
    std::fprintf(stderr, "stopped; --resume %s goes on\n", o.out.c_str());
    run.stop();
  }
}
