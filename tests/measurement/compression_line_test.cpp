// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/compression_line.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/measurement/porosity.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near;
using test::near_relative;

namespace {

// Sums of a few products of void ratios and logarithms, all below 20.
constexpr double round_off = 1e-12;

// Two lines that meet at a void ratio of 0.2.
double two_slopes(double stress, double yield, double kappa, double lambda) {
  return 0.2 - (stress < yield ? kappa : lambda) * std::log(stress / yield);
}

std::vector<CompressionState> states_of(const std::vector<double>& stresses, double yield) {
  std::vector<CompressionState> states;
  for (const double p : stresses) states.push_back({p, two_slopes(p, yield, 0.004, 0.05)});
  return states;
}

}  // namespace

TEST_CASE("void ratio is pores over solids") {
  CHECK(void_ratio(0.2) == near(0.25, round_off));
  CHECK(void_ratio(0.5) == near(1, round_off));
}

TEST_CASE("states of a line give back slope, void ratio and range") {
  std::vector<CompressionState> states;
  for (const double p : {8e6, 1e6, 2e6}) states.push_back({p, 0.3 - 0.05 * std::log(p / 1e6)});
  const CompressionLine line = compression_line(states);
  CHECK(line.slope == near(0.05, round_off));
  CHECK(line.void_ratio_at(1e6) == near(0.3, round_off));
  CHECK(line.void_ratio_at(4e6) == near(0.3 - 0.05 * std::log(4), round_off));
  CHECK(line.scatter == near(0, round_off));
  CHECK(line.lowest == 1e6);
  CHECK(line.highest == 8e6);
}

TEST_CASE("the yield stress is where two lines meet, between the states or on one") {
  for (const double yield : {5e6, 4e6}) {
    const CompressionYield found =
        compression_yield(states_of({1e6, 2e6, 3e6, 4e6, 8e6, 16e6, 32e6}, yield));
    // Its logarithm is a difference of intercepts over one of slopes, 0.046.
    CHECK(found.stress == near_relative(yield, round_off / 0.046));
    CHECK(found.before.slope == near(0.004, round_off));
    CHECK(found.after.slope == near(0.05, round_off));
    CHECK(found.before.highest <= yield);
    CHECK(found.after.lowest >= yield);
  }
}

TEST_CASE("lines that meet outside of the states have no yield stress") {
  // The same slope but for a step between: they meet far below.
  std::vector<CompressionState> states;
  for (const double p : {1e6, 2e6, 3e6}) states.push_back({p, 0.30 - 0.010 * std::log(p / 1e6)});
  for (const double p : {8e6, 9e6, 10e6}) states.push_back({p, 0.20 - 0.011 * std::log(p / 1e6)});
  const CompressionYield found = compression_yield(states);
  CHECK(found.before.highest == 3e6);
  CHECK(std::isnan(found.stress));
}

TEST_CASE("a sample of linear springs has an apparent yield stress") {
  // Without any yield: void ratio falls in proportion to the stress.
  std::vector<CompressionState> states;
  for (double p = 1e6; p < 40e6; p *= 1.5) states.push_back({p, 0.2 - 1e-9 * p});
  const CompressionYield found = compression_yield(states);
  CHECK(found.stress > 1e6);
  CHECK(found.stress < 40e6);
}

TEST_CASE("states that have no lines are refused") {
  CHECK(message_of([] {
          (void)compression_line(std::vector<CompressionState>{{0, 0.2}, {1e6, 0.1}});
        }) == "compression_line: stress = 0: must be a finite number above 0");
  CHECK(message_of([] {
          (void)compression_yield(states_of({1e6, 2e6, 3e6, 4e6, 5e6}, 2e6));
        }) == "compression_yield: number of states = 5: must be 6 or more");
  CHECK(message_of([] {
          (void)compression_yield(states_of({1e6, 2e6, 2e6, 4e6, 5e6, 6e6}, 2e6));
        }) == "compression_yield: stress = 2e+06: must be above that of the state before");
}
