// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <vector>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

std::vector<double> factors(const WeibullStrength& trigger, double area, unsigned count) {
  std::vector<double> out;
  for (ParticleId id = 0; id < count; ++id) out.push_back(trigger.strength_factor(id, area));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("strengths follow Weibull's law") {
  const WeibullStrength trigger;
  constexpr unsigned n = 200000;
  const std::vector<double> s = factors(trigger, trigger.reference_area, n);
  // Share below the characteristic strength: 1 - 1/e. Five standard errors of a share.
  const auto below = std::lower_bound(s.begin(), s.end(), 1.0) - s.begin();
  CHECK(std::abs(static_cast<double>(below) / n - 0.632121) < 5 * std::sqrt(0.2325 / n));
  // Mean Gamma(1 + 1/m) = 0.918169 for m = 5; the standard deviation is 0.2105.
  double mean = 0;
  for (const double v : s) mean += v / n;
  CHECK(std::abs(mean - 0.918169) < 5 * 0.2105 / std::sqrt(n));
  // Median (ln 2)^(1/m) = 0.929320; standard error 1 / (2 f sqrt(n)) with the density f there.
  const double density = 5 * std::log(2.0) / 0.929320 * 0.5;
  CHECK(std::abs(s[n / 2] - 0.929320) < 5 / (2 * density * std::sqrt(n)));
}

TEST_CASE("eight times the area makes a particle weaker by 8^(-1/m)") {
  const WeibullStrength trigger;
  for (const ParticleId id : {0u, 7u, 12345u})
    CHECK(trigger.strength_factor(id, 8 * 2e-4) / trigger.strength_factor(id, 2e-4) ==
          near_relative(0.659754, 1e-6));
}

TEST_CASE("at the reference size a share of 1/e is stronger than the characteristic strength") {
  constexpr unsigned n = 100000;
  for (const double dimension : {0.0, 2.0, 3.0}) {
    const WeibullStrength trigger{.modulus = 3, .dimension = dimension};
    const double d = 3;  // times that of the reference
    for (const double size : {1.0, d}) {
      // sigma_0 d_0, and at another size its strength by the size effect.
      const double strength = std::pow(size, -dimension / trigger.modulus);
      const std::vector<double> s = factors(trigger, size * size * trigger.reference_area, n);
      const auto stronger = s.end() - std::upper_bound(s.begin(), s.end(), strength);
      // Five standard errors of a share.
      CHECK(std::abs(static_cast<double>(stronger) / n - 0.367879) < 5 * std::sqrt(0.2325 / n));
    }
  }
}

TEST_CASE("medians of many diameters lie on a line of slope -D / m in logarithms") {
  constexpr unsigned n = 4000;
  for (const double m : {2.0, 5.0})
    for (const double dimension : {2.0, 3.0}) {
      const WeibullStrength trigger{.modulus = m, .dimension = dimension};
      std::vector<double> x;
      std::vector<double> y;
      ParticleId first = 0;  // other particles for each diameter
      for (int k = 0; k < 12; ++k) {
        const double d = 0.002 * std::pow(1.4, k);  // 2 to 80 mm
        std::vector<double> s;
        for (ParticleId id = first; id < first + n; ++id)
          s.push_back(trigger.strength_factor(id, std::numbers::pi / 4 * d * d));
        first += n;
        std::nth_element(s.begin(), s.begin() + n / 2, s.end());
        x.push_back(std::log(d));
        y.push_back(std::log(s[n / 2]));
      }
      double mean_x = 0;
      double mean_y = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        mean_x += x[k] / 12;
        mean_y += y[k] / 12;
      }
      double xx = 0;
      double xy = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        xx += (x[k] - mean_x) * (x[k] - mean_x);
        xy += (x[k] - mean_x) * (y[k] - mean_y);
      }
      // ln s = ln(draw) / m: the median's standard error is 1 / (2 f sqrt(n)), f = m ln 2 / 2; that
      // of the slope follows from it by the spread of ln d. Four of them.
      const double of_median = 1 / (m * std::log(2.0) * std::sqrt(n));
      CHECK(std::abs(xy / xx + dimension / m) < 4 * of_median / std::sqrt(xx));
      CHECK(4 * of_median / std::sqrt(xx) < 0.02);  // tells 2 / m from 3 / m
      // The median itself: (ln 2)^(1/m) (d / d_0)^(-D / m).
      const double d_0 = std::sqrt(4 / std::numbers::pi * trigger.reference_area);
      const double at_mean = std::log(std::log(2.0)) / m - dimension / m * (mean_x - std::log(d_0));
      CHECK(std::abs(mean_y - at_mean) < 4 * of_median / std::sqrt(12.0));
    }
}

TEST_CASE("a particle keeps its strength, another seed gives it another one") {
  CHECK(WeibullStrength{}.strength_factor(5, 1e-4) == WeibullStrength{}.strength_factor(5, 1e-4));
  CHECK(WeibullStrength{.seed = 2}.strength_factor(5, 1e-4) !=
        WeibullStrength{}.strength_factor(5, 1e-4));
}

TEST_CASE("with an infinite modulus all particles have the strength of the criterion") {
  WeibullStrength trigger{.modulus = std::numeric_limits<double>::infinity(), .dimension = 3};
  CHECK_NOTHROW(trigger.validate());
  for (const double area : {1e-8, 2e-4, 10.0})
    for (ParticleId id = 0; id < 100; ++id) CHECK(trigger.strength_factor(id, area) == 1);
  // Its limit: factors are x^(1 / m), and the least x is that of the least draw, exp(-37.5).
  trigger.modulus = 1e9;
  for (ParticleId id = 0; id < 100; ++id)
    CHECK(std::abs(trigger.strength_factor(id, 2e-4) - 1) < 40 / trigger.modulus);
}

TEST_CASE("parameters are checked") {
  CHECK_THROWS_WITH_AS(WeibullStrength{.modulus = 0}.validate(),
                       "WeibullStrength.modulus = 0: must be a number above 0", InvalidInput);
  CHECK_THROWS_AS(WeibullStrength{.modulus = std::nan("")}.validate(), InvalidInput);
  CHECK_THROWS_AS(WeibullStrength{.reference_area = -1}.validate(), InvalidInput);
  CHECK_THROWS_AS(WeibullStrength{.dimension = -1}.validate(), InvalidInput);
  CHECK_NOTHROW(WeibullStrength{}.validate());
}

TEST_CASE("strength does not change how many failed elements are needed") {
  CHECK(WeibullStrength{}.failed_elements_needed(100) == 40);
}
