// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/evidence.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <support/near.hpp>

using report::Claimed;
using report::Evidence;
using report::Mode;
using report::Outcome;
using report::Results;
using report::Run;
using riprap::test::near;

namespace {

constexpr double round_off = 1e-13;

/// A run that has one number.
Run run_of(Mode mode, double pressure, int seed, double number) {
  Run run;
  run.mode = mode;
  run.pressure = pressure;
  run.seed = seed;
  run.numbers["x"] = number;
  return run;
}

double x(const Run& run) { return run.number("x"); }

/// The number is the first of a pair for the pressure plus what the sample adds.
Results at_all_pressures(const std::vector<double>& means, const std::vector<double>& samples) {
  Results results;
  for (std::size_t p = 0; p < report::pressures.size(); ++p)
    for (std::size_t i = 0; i < samples.size(); ++i)
      results.runs.push_back(
          run_of(Mode::nb, report::pressures[p], static_cast<int>(i) + 1, means[p] + samples[i]));
  return results;
}

const report::Finding& last(const Evidence& e) { return e.findings.back(); }

}  // namespace

TEST_CASE("differences are taken sample by sample, so that scatter of the samples drops out") {
  Results results;
  for (const auto& [seed, level] : {std::pair{1, 10.0}, {2, 20.0}, {3, 30.0}}) {
    results.runs.push_back(run_of(Mode::nb, 2e6, seed, level));
    results.runs.push_back(run_of(Mode::wb, 2e6, seed, level + 0.1 * seed));
  }
  // A sample that only one of them has tells nothing.
  results.runs.push_back(run_of(Mode::wb, 2e6, 4, 500));
  const Evidence e = differences(results, Mode::wb, Mode::nb, {2e6}, x, Claimed::above);
  REQUIRE(e.findings.size() == 1);
  CHECK(last(e).value.mean == near(0.2, round_off));
  CHECK(last(e).value.standard_error == near(0.1 / std::sqrt(3.0), round_off));
  CHECK(last(e).outcome == Outcome::agrees);
  CHECK(differences(results, Mode::wb, Mode::nb, {2e6}, x, Claimed::below).findings[0].outcome ==
        Outcome::against);
}

TEST_CASE("samples that differ more than their mean leave it open") {
  Results results;
  for (const auto& [seed, value] : {std::pair{1, 1.0}, {2, -0.5}, {3, 2.0}})
    results.runs.push_back(run_of(Mode::nb, 2e6, seed, value));
  for (const Claimed claimed : {Claimed::above, Claimed::below})
    CHECK(last(levels(results, {Mode::nb}, {2e6}, x, claimed)).outcome == Outcome::within_scatter);
  // A tolerance asks for the mean, 0.833, alone.
  CHECK(last(mean_levels(results, {Mode::nb}, {2e6}, x, Claimed::above, 0.8)).outcome ==
        Outcome::agrees);
  CHECK(last(mean_levels(results, {Mode::nb}, {2e6}, x, Claimed::above, 0.9)).outcome ==
        Outcome::against);
  CHECK(last(mean_levels(results, {Mode::nb}, {2e6}, x, Claimed::below, 0.9)).outcome ==
        Outcome::agrees);
}

TEST_CASE("a level is compared with what chance gives, and shown as it is") {
  Results results;
  for (const int seed : {1, 2})
    results.runs.push_back(run_of(Mode::nb, 2e6, seed, 0.6 + 1e-3 * seed));
  const Evidence e = levels(results, {Mode::nb}, {2e6}, x, Claimed::above, 0.5);
  CHECK(last(e).value.mean == near(0.6015, round_off));
  CHECK(last(e).outcome == Outcome::agrees);
  CHECK(last(levels(results, {Mode::nb}, {2e6}, x, Claimed::above, 0.7)).outcome ==
        Outcome::against);
}

TEST_CASE("numbers that a run does not have are missing") {
  Results results;
  results.runs = {run_of(Mode::nb, 2e6, 1, 1), run_of(Mode::nb, 2e6, 2, std::nan(""))};
  const Evidence e = levels(results, {Mode::nb, Mode::wb}, {2e6}, x, Claimed::above);
  CHECK(e.findings.empty());
  CHECK(e.missing == std::vector<std::string>{"NB at 2 MPa (one sample, no scatter)",
                                              "WB at 2 MPa (no sample)"});
}

TEST_CASE("a trend goes from the lowest to the highest pressure, without a step against it") {
  const std::vector<double> samples{0, 0.01, -0.02};
  const auto trend = [&](const std::vector<double>& means, Claimed claimed) {
    const Evidence e =
        trend_with_pressure(at_all_pressures(means, samples), {Mode::nb}, x, claimed);
    CHECK(e.missing.empty());
    CHECK(e.findings.size() == 7);
    for (std::size_t i = 0; i < 6; ++i) CHECK_FALSE(e.findings[i].counts);
    CHECK(last(e).value.mean == near(means[5] - means[0], round_off));
    return last(e).outcome;
  };
  CHECK(trend({1, 2, 3, 4, 5, 6}, Claimed::above) == Outcome::agrees);
  CHECK(trend({1, 2, 3, 4, 5, 6}, Claimed::below) == Outcome::against);
  CHECK(trend({6, 5, 4, 3, 2, 1}, Claimed::below) == Outcome::agrees);
  CHECK(trend({1, 2, 3, 2.5, 5, 6}, Claimed::above) == Outcome::within_scatter);
  CHECK(trend({1, 9, 8, 7, 6, 1}, Claimed::above) == Outcome::within_scatter);
}

TEST_CASE("a trend needs every pressure") {
  Results results = at_all_pressures({1, 2, 3, 4, 5, 6}, {0, 0.1});
  std::erase_if(results.runs, [](const Run& r) { return r.pressure == 1e6; });
  const Evidence e = trend_with_pressure(results, {Mode::nb}, x, Claimed::above);
  CHECK(e.missing == std::vector<std::string>{"NB at 1 MPa (no sample)"});
  for (const report::Finding& f : e.findings) CHECK_FALSE(f.counts);
}

TEST_CASE("findings can be relabelled, and be read as that nothing speaks against them") {
  Evidence e;
  for (const Outcome o : {Outcome::agrees, Outcome::within_scatter, Outcome::against})
    e.findings.push_back({"NB", "2 MPa", {}, o});
  const Evidence changed = e.labelled("a").unless_against();
  CHECK(changed.findings[0].series == "NB, a");
  CHECK(changed.findings[0].outcome == Outcome::agrees);
  CHECK(changed.findings[1].outcome == Outcome::agrees);
  CHECK(changed.findings[2].outcome == Outcome::against);
}
