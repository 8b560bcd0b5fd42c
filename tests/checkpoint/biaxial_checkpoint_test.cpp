// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <riprap/checkpoint/checkpoint_folder.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/displacement_paths.hpp>
#include <riprap/experiment/incremental_displacement.hpp>
#include <riprap/measurement/step_timer.hpp>
#include <riprap/output/curve_files.hpp>
#include <riprap/output/frames.hpp>
#include <riprap/output/paraview.hpp>
#include <riprap/output/progress.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

constexpr BiaxialTest short_test{
    .confining_pressure = 14e6, .axial_strain = 0.01, .record_every = 0.001};

/// A biaxial test with every observer that riprap has, in a folder of its own.
struct Run {
  explicit Run(std::filesystem::path where, OldFile old = OldFile::replace)
      : folder(std::move(where)), made(std::filesystem::create_directories(folder)),
        sim{Model{}.criterion(HoekBrown{.compressive_strength = 100e6}),
            random_assembly({.count = 40, .seed = 3}), Rock{}},
        files{curve, folder, old}, series{folder / "paraview"}, frames{folder / "frames"},
        progress{null.get()} {
    displacement.begin(sim.particles());
  }

  template <class Call>
  auto with_observers(Call&& call) {
    return call(curve, files, series, frames, progress, paths, displacement, timer);
  }
  /// Steps until `stop`, or to the end. Returns the steps of each stage.
  std::vector<std::uint64_t> run(const CheckpointFolder& checkpoints, bool resumes,
                                 std::uint64_t stop, const BiaxialTest& loading = short_test) {
    std::vector<std::uint64_t> steps;
    with_observers([&](auto&... observers) {
      auto test = loading.start(sim, observers...);
      if (resumes) checkpoints.read_newest([](const char*) {}, sim, test, observers...);
      while (test.advance() && sim.steps() != stop) {
      }
      if (sim.steps() == stop) checkpoints.write(sim, test, observers...);
      for (const StageResult& stage : test.result().stages) steps.push_back(stage.steps);
    });
    return steps;
  }

  std::filesystem::path folder;
  bool made;
  Simulation<Model<>> sim;
  Curve curve{};
  CurveFiles files;
  ParaViewSeries series;
  FrameWriter frames;
  internal::OpenFile null{std::fopen("/dev/null", "w")};
  Progress progress;
  DisplacementPaths paths{};
  IncrementalDisplacement displacement{};
  StepTimer timer{};
};

/// All files below a folder, with their contents.
[[nodiscard]] std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    if (entry.is_regular_file())
      all[std::filesystem::relative(entry.path(), folder).string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
  }
  return all;
}

}  // namespace

TEST_CASE("A biaxial test that stops and goes on leaves the same files, in each stage") {
  const test::TemporaryFile place;
  const std::filesystem::path top = place.path();
  const CheckpointFolder checkpoints{top / "checkpoints"};
  Run whole{top / "whole"};
  const std::vector<std::uint64_t> stages = whole.run(checkpoints, false, 0);
  const auto wanted = contents(top / "whole");
  REQUIRE(wanted.size() > 20);
  REQUIRE(whole.curve.breaks().size() >= 2);

  std::vector<std::uint64_t> stops{1, whole.sim.steps() - 1};
  for (const BiaxialBreak& b : {whole.curve.breaks().front(), whole.curve.breaks().back()})
    for (const std::uint64_t step : {b.event.step - 1, b.event.step}) stops.push_back(step);
  std::uint64_t begun = 0;
  for (const std::uint64_t steps : stages) {
    REQUIRE(steps > 10);
    for (const std::uint64_t step : {steps / 3, steps}) stops.push_back(begun + step);
    begun += steps;
  }
  REQUIRE(begun == whole.sim.steps());
  stops.pop_back();  // the end
  for (const std::uint64_t stop : stops) {
    CAPTURE(stop);
    std::filesystem::remove_all(top / "parts");
    std::filesystem::remove_all(top / "checkpoints");
    {
      Run first{top / "parts"};
      (void)first.run(checkpoints, false, stop);
    }
    Run second{top / "parts", OldFile::keep};
    (void)second.run(checkpoints, true, 0);
    CHECK(second.sim.steps() == whole.sim.steps());
    CHECK(contents(top / "parts") == wanted);
    CHECK(digest(fields_of(second.sim, "sim")) == digest(fields_of(whole.sim, "sim")));
    CHECK(digest(fields_of(second.paths, "paths")) == digest(fields_of(whole.paths, "paths")));
    CHECK(digest(fields_of(second.displacement, "moves")) ==
          digest(fields_of(whole.displacement, "moves")));
    CHECK(digest(fields_of(second.progress, "checks")) ==
          digest(fields_of(whole.progress, "checks")));
  }
  std::filesystem::remove_all(top);
}

TEST_CASE("A test that goes on farther than it was to is one that was to go so far") {
  const test::TemporaryFile place;
  const std::filesystem::path top = place.path();
  const CheckpointFolder checkpoints{top / "checkpoints"};
  BiaxialTest farther = short_test;
  farther.axial_strain = 0.015;
  Run whole{top / "whole"};
  (void)whole.run(checkpoints, false, 0, farther);
  {
    Run first{top / "parts"};
    (void)first.run(checkpoints, false, 4 * whole.sim.steps() / 5);
  }
  Run second{top / "parts", OldFile::keep};
  (void)second.run(checkpoints, true, 0, farther);
  CHECK(contents(top / "parts") == contents(top / "whole"));
  CHECK(digest(fields_of(second.sim, "sim")) == digest(fields_of(whole.sim, "sim")));
  std::filesystem::remove_all(top);
}
