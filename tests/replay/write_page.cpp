// SPDX-License-Identifier: BSL-1.0
// Writes the page of a short run with breaks: riprap_replay_page FILE. Fails where it is too large.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include <replay/page.hpp>
#include <replay/recorded_run.hpp>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/output/file.hpp>
#include <riprap/output/frames.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

using namespace riprap;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    const std::string page = argv[1];
    const std::filesystem::path folder = page + "_frames";
    Simulation sim{Model{}, random_assembly({.count = 60, .seed = 2}), Rock{}};
    FrameWriter frames{folder};
    BiaxialTest{.confining_pressure = 14e6, .axial_strain = 0.06}.run(sim, frames);
    if (sim.breaks().size() < 5) return 1;
    const auto run = replay::read_run(FrameWriter::file_in(folder).string(), 1);
    // A title that must not end the data of the page.
    const std::string text = replay::page_of(run, "60 particles </script> & more");
    write_file(page, text);
    FrameWriter::remove(folder);
    // The run of docs/replay.md, 500 particles in 248 frames, is to stay below 20 MB.
    const double most = 20e6 / (500.0 * 248) * 60 * static_cast<double>(run.frames.size());
    std::printf("%zu frames of 60 particles: %zu bytes, at most %.0f\n", run.frames.size(),
                text.size(), most);
    if (static_cast<double>(text.size()) > most) {
      std::fprintf(stderr, "the page is too large\n");
      return 1;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
