// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/evidence.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <support/near.hpp>

using report::Claimed;
using report::Mode;
using report::Outcome;
using report::Part;
using report::Results;
using report::Run;
using report::Shown;
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

/// The number is that of the pressure plus what the sample adds.
Results at_all_pressures(const std::vector<double>& means, const std::vector<double>& samples) {
  Results results;
  for (std::size_t p = 0; p < report::pressures.size(); ++p)
    for (std::size_t i = 0; i < samples.size(); ++i)
      results.runs.push_back(
          run_of(Mode::nb, report::pressures[p], static_cast<int>(i) + 1, means[p] + samples[i]));
  return results;
}

}  // namespace

TEST_CASE("differences are taken sample by sample, so that scatter of the samples drops out") {
  Results results;
  for (const auto& [seed, level] : {std::pair{1, 10.0}, {2, 20.0}, {3, 30.0}}) {
    results.runs.push_back(run_of(Mode::nb, 2e6, seed, level));
    results.runs.push_back(run_of(Mode::wb, 2e6, seed, level + 0.1 * seed));
  }
  // A sample that only one of them has tells nothing.
  results.runs.push_back(run_of(Mode::wb, 2e6, 4, 500));
  const Part part = difference_part(results, {}, {2e6}, x);
  REQUIRE(part.findings.size() == 1);
  CHECK(part.findings[0].series == "WB less NB");
  CHECK(part.pooled.mean == near(0.2, round_off));
  CHECK(part.pooled.standard_error == near(0.1 / std::sqrt(3.0), round_off));
  CHECK(part.shown == Shown::effect);
  CHECK_FALSE(part.contradicted);
  CHECK(difference_part(results, {.claimed = Claimed::below}, {2e6}, x).shown == Shown::opposite);
}

TEST_CASE("a level is compared with its threshold, and shown as it is") {
  Results results;
  for (const int seed : {1, 2})
    results.runs.push_back(run_of(Mode::nb, 2e6, seed, 0.6 + 1e-3 * seed));
  const auto part = [&](double threshold, double margin) {
    return level_part(results, {.threshold = threshold, .margin = margin}, {Mode::nb}, {2e6}, x);
  };
  CHECK(part(0.5, 0).pooled.mean == near(0.6015, round_off));
  CHECK(part(0.5, 0).shown == Shown::effect);
  CHECK(part(0.7, 0).shown == Shown::opposite);
  CHECK(part(0.7, 0).contradicted);
  CHECK(part(0.5, 0.2).shown == Shown::small_effect);
  CHECK(part(0.6015, 0).shown == Shown::neither);
}

TEST_CASE("places that scatter too much alone can be clear together") {
  // In each of four places the samples differ by more than their mean, in the mean of all by less.
  Results results;
  const double numbers[4][3] = {{3, -1, 1}, {-1, 3, 1}, {1, 2, 0}, {1, 0, 2}};
  const std::vector<double> at{0.5e6, 1e6, 2e6, 4e6};
  for (std::size_t p = 0; p < 4; ++p)
    for (int seed = 1; seed <= 3; ++seed)
      results.runs.push_back(run_of(Mode::nb, at[p], seed, numbers[p][seed - 1]));
  const Part part = level_part(results, {}, {Mode::nb}, at, x);
  for (const report::Finding& f : part.findings) CHECK(f.outcome == Outcome::within_scatter);
  CHECK(part.pooled.mean == near(1, round_off));
  CHECK(part.pooled.standard_error == near(0, round_off));
  CHECK(part.shown == Shown::effect);
}

TEST_CASE("a place that is clearly the other way contradicts, at a level for all places together") {
  // t(2; 0.95) = 2.920, t(2; 0.975) = 4.303 for two places.
  const auto with = [](double mean) {
    Results results;
    for (int seed = 1; seed <= 3; ++seed) {
      results.runs.push_back(run_of(Mode::nb, 1e6, seed, 100));
      results.runs.push_back(run_of(Mode::nb, 2e6, seed, mean + std::sqrt(3.0) * (seed - 2)));
    }
    const Part part = level_part(results, {}, {Mode::nb}, {1e6, 2e6}, x);
    CHECK(part.shown == Shown::effect);
    return part.contradicted;
  };
  CHECK_FALSE(with(-4.30));
  CHECK(with(-4.31));
}

TEST_CASE("numbers that a run does not have are missing") {
  Results results;
  results.runs = {run_of(Mode::nb, 2e6, 1, 1), run_of(Mode::nb, 2e6, 2, std::nan(""))};
  const Part part = level_part(results, {}, {Mode::nb, Mode::wb}, {2e6}, x);
  CHECK(part.missing == std::vector<std::string>{"NB at 2 MPa (one sample, no scatter)",
                                                 "WB at 2 MPa (no sample)"});
}

TEST_CASE("samples that no pressure shares cannot be pooled") {
  Results results;
  for (const int seed : {1, 2, 3, 4})
    results.runs.push_back(run_of(Mode::nb, seed < 3 ? 1e6 : 2e6, seed, seed));
  const Part part = level_part(results, {}, {Mode::nb}, {1e6, 2e6}, x);
  CHECK(part.missing == std::vector<std::string>{"two samples that all series and pressures have"});
}

TEST_CASE("a slope is that of least squares over the decimal logarithm of pressure") {
  std::vector<double> means;
  for (const double p : report::pressures) means.push_back(7 - 3 * std::log10(p / 1e6));
  const Results results = at_all_pressures(means, {0, 0.01, -0.02});
  const Part part = slope_part(results, {.claimed = Claimed::below}, {Mode::nb}, x);
  CHECK(part.findings.size() == 6);
  for (const report::Finding& f : part.findings) CHECK_FALSE(f.counts);
  CHECK(part.pooled.mean == near(-3, round_off));
  CHECK(part.shown == Shown::effect);
  CHECK_FALSE(part.contradicted);
}

TEST_CASE("a slope is contradicted by a step that is clearly the other way") {
  const std::vector<double> samples{0, 0.01, -0.02};
  const auto slope = [&](const std::vector<double>& means) {
    return slope_part(at_all_pressures(means, samples), {}, {Mode::nb}, x);
  };
  CHECK_FALSE(slope({1, 2, 3, 4, 5, 6}).contradicted);
  const Part bent = slope({1, 2, 3, 2.5, 5, 6});
  CHECK(bent.shown == Shown::effect);
  CHECK(bent.contradicted);
}

TEST_CASE("a slope needs every pressure") {
  Results results = at_all_pressures({1, 2, 3, 4, 5, 6}, {0, 0.1});
  std::erase_if(results.runs, [](const Run& r) { return r.pressure == 1e6; });
  const Part part = slope_part(results, {}, {Mode::nb}, x);
  CHECK(part.missing == std::vector<std::string>{"NB at 1 MPa (no sample)"});
}

TEST_CASE("a contrast weighs the pressures") {
  const Results results = at_all_pressures({1, 2, 3, 4, 5, 6}, {0, 0.01, -0.02});
  // Of the first, fourth and last number, in which the samples drop out: 1 - 2 * 4 + 6.
  const Part part =
      contrast_part(results, {}, {Mode::nb}, {0.5e6, 4e6, 14e6}, {1, -2, 1}, "bend", x);
  CHECK(part.pooled.mean == near(-1, round_off));
  CHECK(part.shown == Shown::opposite);
  CHECK(part.quantity == "bend");
}
