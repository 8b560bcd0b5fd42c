// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
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

TEST_CASE("a particle keeps its strength, another seed gives it another one") {
  CHECK(WeibullStrength{}.strength_factor(5, 1e-4) == WeibullStrength{}.strength_factor(5, 1e-4));
  CHECK(WeibullStrength{.seed = 2}.strength_factor(5, 1e-4) !=
        WeibullStrength{}.strength_factor(5, 1e-4));
}

TEST_CASE("parameters are checked") {
  CHECK_THROWS_WITH_AS(WeibullStrength{.modulus = 0}.validate(),
                       "WeibullStrength.modulus = 0: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_AS(WeibullStrength{.reference_area = -1}.validate(), InvalidInput);
  CHECK_NOTHROW(WeibullStrength{}.validate());
}

TEST_CASE("strength does not change how many failed elements are needed") {
  CHECK(WeibullStrength{}.failed_elements_needed(100) == 40);
}
