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
using riprap::Vec2;
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
  CHECK(read.breaks.front().crack_length == written.breaks.front().crack_length);
  CHECK(read.shear.back().axial_strain == 0.18);
  CHECK(radius_of_bands(read.shear.back()) == radius_of_bands(written.shear.back()));
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
                 "mode \"maybe\" of a run must be nb or wb"));
}

TEST_CASE("places of a stretch are read as they were when it began") {
  Json json = run_json(example());
  json["shear_around"][0]["stretch_at_begin"] = {1.5, 0.5};
  const report::ShearedParticle read = report::read_run(json, "").shear[0].particles[0];
  const report::ShearedParticle written = example().shear[0].particles[0];
  CHECK(read.unstrained == written.unstrained);
  CHECK(read.place == Vec2(1.5 * written.unstrained.x(), 0.5 * written.unstrained.y()));
}

TEST_CASE("runs of rows are apart from those of the series") {
  const auto folder = std::filesystem::temp_directory_path() / "riprap_rows_test";
  std::filesystem::remove_all(folder);
  const auto add = [&](const std::string& place, const Run& run) {
    std::filesystem::create_directories(folder / place);
    riprap::write_file((folder / place / "run.json").string(), run_json(run).dump());
  };
  Run row = example();
  add("runs/a", row);
  row.variation = "weak_rock";
  add("rows/a", row);
  const auto read = report::read_results(folder);
  CHECK(read.runs.size() == 1);
  REQUIRE(read.rows.size() == 1);
  CHECK(read.rows[0].name() == "WB 0.5 MPa, sample 2, weak_rock");
  CHECK(read.of(Mode::wb, 0.5e6) == std::vector<const Run*>{&read.runs[0]});
  CHECK(read.of_row("weak_rock", Mode::wb, 0.5e6) == std::vector<const Run*>{&read.rows[0]});
  CHECK(read.of_row("weak_rock", Mode::nb, 0.5e6).empty());
  CHECK(read.of_row("slow_shear", Mode::wb, 0.5e6).empty());
  std::filesystem::remove_all(folder);
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
  CHECK(read.rows.empty());

  riprap::write_file((folder / "runs" / read.runs[0].name() / "run.json").string(),
                     "{\"mode\": 1}");
  CHECK(
      contains(message_of([&] { static_cast<void>(report::read_results(folder)); }), "run.json: "));
  std::filesystem::remove_all(folder);
}
