// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/breakage_indices.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;
using test::near_relative;

namespace {

// Sums of some tens of logarithms of order one.
constexpr double round_off = 1e-14;
// Numbers that are given with seven digits.
constexpr double seven_digits = 5e-8;

const Grading ten = Grading::of_fractions({{10e-3, 1}});
const Grading half_crushed = Grading::of_fractions({{10e-3, 1}, {1e-3, 1}});

// The largest is 10 mm; finer ones count as one ten-thousandth of it.
Grading ultimate_grading(double finest, int points) {
  std::vector<GradingPoint> curve;
  for (int i = 0; i <= points; ++i) {
    const double ratio = std::pow(finest, 1 - static_cast<double>(i) / points);
    curve.push_back({10e-3 * ratio, std::pow(ratio, 0.4)});
  }
  return Grading::of_sieves(curve);
}

Grading scaled(const Grading& grading, double factor) {
  std::vector<GradingPoint> points(grading.points().begin(), grading.points().end());
  for (GradingPoint& p : points) p.size *= factor;
  return Grading::of_sieves(points);
}

}  // namespace

TEST_CASE("Hardin's relative breakage of a sample whose half went from 10 mm to 1 mm") {
  // B_t = 0.5 decades of B_p = log10(10 / 0.074); 0.075 mm is the opening in use today.
  CHECK(hardin_breakage(ten, half_crushed) == near(0.2346571, seven_digits));
  CHECK(hardin_breakage(ten, half_crushed, 0.075e-3) == near(0.2353009, seven_digits));
}

TEST_CASE("Hardin's relative breakage is 1 when all is as fine as the limit, or finer") {
  CHECK(hardin_breakage(ten, Grading::of_fractions({{0.074e-3, 1}})) == near(1, round_off));
  CHECK(hardin_breakage(ten, Grading::of_fractions({{1e-6, 1}, {1e-5, 4}})) == 1);
  // A quarter of the mass reaches the limit, whichever way below.
  const Grading a = Grading::of_fractions({{10e-3, 3}, {0.074e-3, 1}});
  const Grading b = Grading::of_fractions({{10e-3, 3}, {1e-6, 1}});
  CHECK(hardin_breakage(ten, a) == near(0.25, round_off));
  CHECK(hardin_breakage(ten, b) == near(0.25, round_off));
}

TEST_CASE("Marsal's breakage is what the finer intervals have gained") {
  // Retained on four intervals 40, 30, 20, 10 %, then 30, 30, 22, 18 %.
  const std::array sieves{1e-3, 2e-3, 4e-3};
  const Grading before = Grading::of_fractions({{8e-3, 40}, {3e-3, 30}, {1.5e-3, 20}, {1e-3, 10}});
  const Grading after = Grading::of_fractions({{8e-3, 30}, {3e-3, 30}, {1.5e-3, 22}, {1e-3, 18}});
  CHECK(marsal_breakage(before, after, sieves) == near(0.10, round_off));
  // What is gained in some intervals is lost in the others.
  CHECK(marsal_breakage(after, before, sieves) == near(0.10, round_off));
  // The same curves as a laboratory would read them from its sieves.
  const Grading first = Grading::of_sieves({{1e-3, 0.1}, {2e-3, 0.3}, {4e-3, 0.6}, {9e-3, 1}});
  const Grading second = Grading::of_sieves({{1e-3, 0.18}, {2e-3, 0.4}, {4e-3, 0.7}, {9e-3, 1}});
  CHECK(marsal_breakage(first, second, sieves) == near(0.10, round_off));
}

TEST_CASE("Marsal's breakage counts the gain of every interval, the outer ones included") {
  const std::array sieves{2.0, 4.0};
  const Grading before = Grading::of_fractions({{1, 20}, {3, 60}, {5, 20}});
  const Grading spread = Grading::of_fractions({{1, 30}, {3, 35}, {5, 35}});
  CHECK(marsal_breakage(before, spread, sieves) == near(0.25, round_off));
}

TEST_CASE("Lade's breakage of a sample whose D10 went from 2 mm to half a millimetre") {
  const Grading before = Grading::of_fractions({{2e-3, 15}, {6e-3, 85}});
  const Grading after = Grading::of_fractions({{0.1e-3, 5}, {0.5e-3, 15}, {6e-3, 80}});
  CHECK(lade_breakage(before, after) == near(0.75, round_off));
  // A tenth lies a tenth of the way up either curve, over the logarithm of size.
  const Grading two_decades = Grading::of_sieves({{1e-3, 0}, {100e-3, 1}});
  const Grading three_decades = Grading::of_sieves({{0.1e-3, 0}, {100e-3, 1}});
  CHECK(lade_breakage(two_decades, three_decades) == near(1 - std::pow(10, -0.9), round_off));
}

TEST_CASE("Einav's relative breakage of a sample whose half went from 10 mm to 1 mm") {
  // B_p = (1 - r^0.4) / (0.4 ln 10) decades with r = 1e-4.
  CHECK(einav_breakage(ten, half_crushed) == near(0.4723827, seven_digits));
  CHECK(0.5 / einav_breakage(ten, half_crushed) == near_relative(1.0584637, seven_digits));
}

TEST_CASE("Einav's relative breakage is 1 for the ultimate grading") {
  // Chords of the curve in place of arcs: (0.4 ln(10^4) / n)^2 / 12 of the area, 7e-8.
  CHECK(einav_breakage(ten, ultimate_grading(1e-4, 4000)) == near(1, 2e-7));
  // Grains finer than d_m count as d_m, as in the ultimate grading itself.
  CHECK(einav_breakage(ten, ultimate_grading(1e-6, 6000)) == near(1, 2e-7));
  // Another first grading has another potential and the same end.
  const Grading mixed = Grading::of_fractions({{10e-3, 1}, {5e-3, 1}, {2e-3, 1}});
  CHECK(einav_breakage(mixed, ultimate_grading(1e-4, 4000)) == near(1, 2e-7));
}

TEST_CASE("a finer ultimate grading leaves more to break") {
  const UltimateGrading finer{.exponent = 0.4, .smallest_ratio = 1e-5};
  const double potential = (1 - std::pow(1e-5, 0.4)) / (0.4 * std::log(10));
  CHECK(einav_breakage(ten, half_crushed, finer) == near(0.5 / potential, round_off));
  const UltimateGrading steeper{.exponent = 0.8, .smallest_ratio = 1e-4};
  const double less = (1 - std::pow(1e-4, 0.8)) / (0.8 * std::log(10));
  CHECK(einav_breakage(ten, half_crushed, steeper) == near(0.5 / less, round_off));
}

TEST_CASE("where nothing broke every index is zero, and other units of length change none") {
  const std::array sieves{0.5e-3, 2e-3};
  const Grading before = Grading::of_fractions({{4e-3, 3}, {2e-3, 1}, {1e-3, 1}});
  const Grading after = Grading::of_fractions({{4e-3, 2}, {2e-3, 1}, {1e-3, 1}, {0.3e-3, 1}});
  CHECK(hardin_breakage(before, before) == 0);
  CHECK(marsal_breakage(before, before, sieves) == 0);
  CHECK(lade_breakage(before, before) == 0);
  CHECK(einav_breakage(before, before) == 0);

  const std::array millimetres{0.5, 2.0};
  const Grading b = scaled(before, 1000);
  const Grading a = scaled(after, 1000);
  CHECK(hardin_breakage(b, a, 0.074) == near_relative(hardin_breakage(before, after), round_off));
  CHECK(marsal_breakage(b, a, millimetres) ==
        near_relative(marsal_breakage(before, after, sieves), round_off));
  CHECK(lade_breakage(b, a) == near_relative(lade_breakage(before, after), round_off));
  CHECK(einav_breakage(b, a) == near_relative(einav_breakage(before, after), round_off));
}

TEST_CASE("indices of what cannot break further, and of no sieves, are refused") {
  using test::message_of;
  const std::array descending{2.0, 1.0};
  CHECK(message_of([&] { (void)hardin_breakage(ten, half_crushed, 10e-3); }) ==
        "hardin_breakage: area of the first grading above the limit = 0: must be a finite number "
        "above 0");
  CHECK(message_of([&] { (void)hardin_breakage(ten, half_crushed, 0); }) ==
        "lower limit of size = 0: must be a finite number above 0");
  CHECK(message_of([&] { (void)marsal_breakage(ten, ten, {}); }) ==
        "marsal_breakage: number of sieves = 0: must be 1 or more");
  CHECK(message_of([&] { (void)marsal_breakage(ten, ten, descending); }) ==
        "marsal_breakage: sieve = 1: must be larger than the one before");
  CHECK(message_of([&] { (void)einav_breakage(ten, ten, {.exponent = 0}); }) ==
        "UltimateGrading.exponent = 0: must be a finite number above 0");
  CHECK(message_of([&] { (void)einav_breakage(ten, ten, {.smallest_ratio = 1}); }) ==
        "UltimateGrading.smallest_ratio = 1: must lie in (0, 1)");
  // Nearly all of the first sample is finer already than the ultimate grading.
  const Grading fine = Grading::of_fractions({{10e-3, 1}, {1e-6, 1000}});
  CHECK(test::contains(message_of([&] { (void)einav_breakage(fine, fine); }),
                       "area between the first grading and the ultimate one"));
}
