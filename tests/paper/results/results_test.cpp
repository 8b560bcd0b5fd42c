// SPDX-License-Identifier: BSL-1.0
#include <paper/results/results.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include <riprap/output/file.hpp>
#include <support/message_of.hpp>

#include <paper/made_up_study.hpp>

using report::Json;
using report::Mode;
using report::Run;
using riprap::test::contains;
using riprap::test::made_up_study;
using riprap::test::message_of;
using riprap::test::run_json;

namespace {

Run example() { return riprap::test::MadeUpRun({}, Mode::wb, 0, 2).run(); }

}  // namespace

TEST_CASE("a run is read back as it was written") {
  const Run written = example();
  const Run read = report::read_run(run_json(written), "somewhere");
  CHECK(read.name() == "WB 0.5 MPa, sample 2");
  CHECK(read.folder == "somewhere");
  CHECK(read.particles == 500);
  CHECK(read.column("a_n") == written.column("a_n"));
  CHECK(read.breaks.size() == written.breaks.size());
  CHECK(read.breaks_in_shear() == written.breaks_in_shear());
  CHECK(read.breaks.front().band_share == written.breaks.front().band_share);
  CHECK_FALSE(read.breaks.back().band_share.has_value());
  CHECK(read.ring_displacement == written.ring_displacement);
  CHECK(read.force_side == written.force_side);
  CHECK(read.bands.back().radius_share == written.bands.back().radius_share);
  CHECK(read.warnings == std::vector<std::string>{"made up"});
  CHECK(read.number("kappa") == 1e-3);
}

TEST_CASE("what a run could not tell is null there and not a number here") {
  Json json = run_json(example());
  json["curve"]["a"][3] = nullptr;
  const Run read = report::read_run(json, "");
  CHECK(std::isnan(read.column("a")[3]));
  CHECK(std::isnan(read.number("energy_error")));
  CHECK(std::isnan(read.number("not there")));
}

TEST_CASE("malformed runs are refused, and say why") {
  Json json = run_json(example());
  json["curve"]["a"].push_back(0);
  CHECK(contains(message_of([&] { static_cast<void>(report::read_run(json, "")); }),
                 "column \"a\" of WB 0.5 MPa, sample 2 must be as long"));
  json = run_json(example());
  json["mode"] = "maybe";
  CHECK(contains(message_of([&] { static_cast<void>(report::read_run(json, "")); }),
                 "mode \"maybe\" of a run must be nb, wb or pinned"));
}

TEST_CASE("a folder's finished runs are found, in order, and those under way are not") {
  const auto folder = std::filesystem::temp_directory_path() / "riprap_results_test";
  std::filesystem::remove_all(folder);
  CHECK(contains(message_of([&] { static_cast<void>(report::read_results(folder)); }),
                 "no finished run in"));
  const auto results = made_up_study({.samples = 1});
  for (const Run& run : results.runs) {
    const auto place = folder / "runs" / run.name();
    std::filesystem::create_directories(place);
    if (run.pressure != 4e6)
      riprap::write_file((place / "run.json").string(), run_json(run).dump());
  }
  const auto read = report::read_results(folder);
  REQUIRE(read.runs.size() == 10);
  CHECK(read.runs.front().name() == "NB 0.5 MPa, sample 1");
  CHECK(read.runs.back().name() == "WB 14 MPa, sample 1");
  CHECK(read.of(Mode::nb, 4e6).empty());
  CHECK(read.first(Mode::nb, 4e6) == nullptr);
  CHECK(read.first(Mode::wb, 2e6)->pressure == 2e6);
  CHECK_FALSE(read.has(Mode::pinned));

  riprap::write_file((folder / "runs" / read.runs[0].name() / "run.json").string(),
                     "{\"mode\": 1}");
  CHECK(
      contains(message_of([&] { static_cast<void>(report::read_results(folder)); }), "run.json: "));
  std::filesystem::remove_all(folder);
}
