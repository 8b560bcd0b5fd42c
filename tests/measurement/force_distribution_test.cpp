// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/force_distribution.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <support/fake_contacts.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// The quantiles of an exponential distribution of mean 1 at the middles of n equal shares, times a
/// mean [N].
std::vector<double> exponential_forces(std::size_t n, double mean) {
  std::vector<double> out;
  for (std::size_t k = 0; k < n; ++k)
    out.push_back(-mean * std::log1p(-(static_cast<double>(k) + 0.5) / static_cast<double>(n)));
  return out;
}

}  // namespace

TEST_CASE("of an exponential distribution the density is exp(-x) and the slope of the tail one") {
  constexpr std::size_t n = 100000;
  const auto forces = exponential_forces(n, 350);
  const ForceDistribution d = force_distribution(forces, {.last = 4, .count = 16});
  // The mean of the midpoint rule for -log(1 - u), singular at 1: short by ln 2 / (2 n).
  CHECK(d.mean == near_relative(350, 1.0 / n));
  REQUIRE(d.density.size() == 16);
  for (std::size_t k = 0; k < 16; ++k) {
    const double expected =
        (std::exp(-d.bounds[k]) - std::exp(-d.bounds[k + 1])) / (d.bounds[k + 1] - d.bounds[k]);
    // Quantiles are 1/n apart in probability: a bin of width 1/4 gains or loses two at most.
    CHECK(d.density[k] == near(expected, 2.0 / n / 0.25));
  }
  const ExponentialTail tail = exponential_tail(forces);
  CHECK(static_cast<double>(tail.forces) == near(n * std::exp(-1.0), 2));
  // The excess above 1 has the mean 1; the sum over quantiles is short by ln 2 / 2.
  CHECK(tail.rate == near(1, 2.0 / static_cast<double>(tail.forces)));
  CHECK(tail.standard_error ==
        near_relative(tail.rate / std::sqrt(static_cast<double>(tail.forces)), 1e-15));
}

TEST_CASE("a steeper tail that begins above twice the mean is found from there on") {
  // Density c exp(-3 x) above 2, where a third of the forces are, and equal small ones below.
  std::vector<double> forces;
  constexpr std::size_t n = 30000;
  for (const double f : exponential_forces(n, 1)) forces.push_back(2 + f / 3);
  // The mean is 1 with 2 n forces of size s: n (2 + 1/3) + 2 n s = 3 n.
  forces.insert(forces.end(), 2 * n, 1.0 / 3);
  const ExponentialTail tail = exponential_tail(forces, 2);
  // The sample's mean is short of 1 by 1 / n, which moves forces of size 2 by as much: by 6 / n of
  // the mean excess of 1/3.
  CHECK(tail.forces == near(n, 2));
  CHECK(tail.rate == near_relative(3, 10.0 / n));
}

TEST_CASE("logarithmic bins of forces that are even over the logarithm have one density times x") {
  std::vector<double> forces;
  constexpr std::size_t n = 20000;
  for (std::size_t k = 0; k < n; ++k)
    forces.push_back(std::pow(100, (static_cast<double>(k) + 0.5) / n));
  // <f> = integral of f / (f ln 100) = 99 / ln 100; the midpoint rule is right to (ln 100 / n)^2.
  const double mean = 99 / std::log(100.0);
  const ForceBins bins{.first = 1 / mean, .last = 100 / mean, .count = 10, .logarithmic = true};
  const ForceDistribution d = force_distribution(forces, bins);
  CHECK(d.mean == near_relative(mean, 1e-6));
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(d.bounds[k + 1] / d.bounds[k] == near_relative(std::pow(100, 0.1), 1e-12));
    // A tenth of the forces each, but for one or two.
    CHECK(d.density[k] * (d.bounds[k + 1] - d.bounds[k]) == near(0.1, 2.0 / n));
  }
}

TEST_CASE("the density integrates to the share of forces in the bins") {
  const std::vector<double> forces{1, 1, 2, 4, 12};  // mean 4
  const ForceDistribution d = force_distribution(forces, {.first = 0.25, .last = 2, .count = 7});
  // 0.25 twice on the first bound, 0.5 on the second, 1 on the fourth; 3 lies outside.
  CHECK(d.counts == std::vector<std::size_t>{2, 1, 0, 1, 0, 0, 0});
  CHECK(d.forces == 5);
  double sum = 0;
  for (const double p : d.density) sum += 0.25 * p;
  CHECK(sum == near(0.8, 1e-15));
  CHECK(exponential_tail(forces).forces == 1);
  CHECK(exponential_tail(forces).rate == 0.5);  // one force, at 3
  CHECK(exponential_tail(forces, 3).forces == 0);
  CHECK(exponential_tail(forces, 3).rate == 0);
}

TEST_CASE("normal and tangential forces are those of loaded contacts, without signs") {
  FakeContacts contacts;
  for (const auto& [normal, tangential] : {std::pair{10.0, -4.0}, {0.0, 0.0}, {3.0, 0.0}})
    contacts.list.push_back(fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, normal, tangential));
  CHECK(normal_forces(contacts) == std::vector<double>{10, 3});
  CHECK(tangential_forces(contacts) == std::vector<double>{4, 0});
}

TEST_CASE("what is no distribution is refused by name") {
  using Forces = std::vector<double>;
  const auto text = [](const Forces& forces, const ForceBins& bins = {}) {
    return message_of([&] { (void)force_distribution(forces, bins); });
  };
  CHECK(contains(text({1, -2}), "force of a contact = -2"));
  CHECK(contains(text({std::numeric_limits<double>::quiet_NaN()}), "force of a contact = nan"));
  CHECK(contains(text({}), "mean of the forces = 0"));
  CHECK(contains(text({0, 0}), "mean of the forces = 0"));
  CHECK(contains(text({1}, {.count = 0}), "ForceBins.count = 0"));
  CHECK(contains(text({1}, {.first = 2, .last = 2}), "ForceBins.last = 2"));
  CHECK(contains(text({1}, {.logarithmic = true}), "ForceBins.first of logarithmic bins = 0"));
  CHECK(contains(message_of([] { (void)exponential_tail(Forces{1}, -1); }),
                 "exponential_tail: from = -1"));
}
