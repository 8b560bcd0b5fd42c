// SPDX-License-Identifier: BSL-1.0
#pragma once
// Norms of stresses with a factor for every element.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/stress/element/element_stress.hpp>

namespace riprap::test {

/// For every element 1, or numbers up to 1 and some zeros; zeros follow up to whole vectors.
inline std::vector<float> random_factors(Random& random, std::size_t elements) {
  std::vector<float> factors((elements + 7) / 8 * 8, 0.0f);
  const bool equal = random.uniform_integer(0, 1) == 0;
  for (std::size_t e = 0; e < elements; ++e)
    factors[e] = equal ? 1.0f : std::max(0.0f, static_cast<float>(random.uniform(-0.3, 1)));
  return factors;
}

inline double weighted_norm(const ElementStress& stress, std::span<const float> factors) {
  double sum = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const Stress2 s = stress[e];
    const auto factor = static_cast<double>(factors[e]);
    sum += factor * factor * (s.s11 * s.s11 + s.s22 * s.s22 + 2 * s.s12 * s.s12);
  }
  return std::sqrt(sum);
}

}  // namespace riprap::test
