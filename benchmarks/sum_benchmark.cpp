// SPDX-License-Identifier: BSL-1.0
// One term of a sum over the sample: exact, whatever the order of its terms, and plain. Losses of
// contacts go into exact sums in every step, stresses and energies when somebody asks.

#include <numeric>
#include <vector>

#include <riprap/core/exact_sum.hpp>

#include "support.hpp"

namespace bench {
namespace {

// Of both signs and of many magnitudes, as energies of contacts are.
[[nodiscard]] std::vector<double> terms() {
  Random random(1);
  std::vector<double> terms(cycle);
  for (double& x : terms) {
    const double root = random.uniform(-1, 1);
    x = root * root * root * root * root;
  }
  return terms;
}

void exact(benchmark::State& state) {
  const std::vector<double> all = terms();
  for (auto _ : state) {
    ExactSum sum;
    for (const double x : all) sum.add(x);
    benchmark::DoNotOptimize(sum.value());
  }
  count_time(state, "term", cycle);
}
BENCHMARK(exact)->Name("sum/exact");

void plain(benchmark::State& state) {
  const std::vector<double> all = terms();
  for (auto _ : state) benchmark::DoNotOptimize(std::accumulate(all.begin(), all.end(), 0.0));
  count_time(state, "term", cycle);
}
BENCHMARK(plain)->Name("sum/plain");

}  // namespace
}  // namespace bench
