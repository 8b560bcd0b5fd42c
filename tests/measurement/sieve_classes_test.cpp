// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/sieve_classes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/riprap.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// The grading of particles of these diameters: their areas are proportional to the squares.
Grading sample(const std::vector<double>& diameters) {
  std::vector<SizeFraction> fractions;
  for (const double d : diameters) fractions.push_back({d, d * d});
  return Grading::of_fractions(fractions);
}

/// What is finer than a size [-]: a particle of the size of a sieve may be on either side of it.
double finer(const Grading& grading, double size) { return grading.passing(size * (1 - 1e-9)); }
double not_coarser(const Grading& grading, double size) {
  return grading.passing(size * (1 + 1e-9));
}

const Grading& rockfill() {
  static const Grading curve = Grading::of_sieves(
      {{0.002, 0}, {0.005, 0.07}, {0.01, 0.18}, {0.02, 0.42}, {0.04, 0.8}, {0.06, 1}});
  return curve;
}

}  // namespace

TEST_CASE("at every sieve the curve of the sample is the curve that was given") {
  for (const std::size_t count : {400U, 2000U, 20000U}) {
    const auto diameters = sieve_class_diameters(rockfill(), count);
    CHECK(diameters.size() == count);
    CHECK(std::is_sorted(diameters.begin(), diameters.end()));
    const Grading made = sample(diameters);
    double area = 0;
    for (const double d : diameters) area += d * d;
    for (const GradingPoint& sieve : rockfill().points())
      CHECK(not_coarser(made, sieve.size) == near(sieve.passing, 1e-10));
    // Within the classes: to one particle of the class.
    for (const double size : {0.003, 0.007, 0.015, 0.03, 0.05})
      CHECK(std::abs(made.passing(size) - rockfill().passing(size)) < 4 * size * size / area);
  }
}

TEST_CASE("by number, sizes depart at the sieves; by class they do not") {
  const std::size_t count = 400;
  const auto worst = [](const std::vector<double>& diameters) {
    double most = 0;
    for (const GradingPoint& sieve : rockfill().points())
      most = std::max(most, std::abs(not_coarser(sample(diameters), sieve.size) - sieve.passing));
    return most;
  };
  CHECK(worst(graded_diameters(rockfill(), count)) > 0.005);
  CHECK(worst(sieve_class_diameters(rockfill(), count)) < 1e-10);
}

TEST_CASE("a step has particles of one size, or a little less") {
  // Half of the area at 10 mm, half at 20 mm: 4 to 1.
  const Grading two = Grading::of_sieves({{0.01, 0.5}, {0.02, 0.5}, {0.02, 1}});
  const auto diameters = sieve_class_diameters(two, 50);
  REQUIRE(diameters.size() == 50);
  for (std::size_t k = 0; k < 50; ++k)
    CHECK(diameters[k] == near_relative(k < 40 ? 0.01 : 0.02, 1e-12));
  // Of 52 there would be 41.6 to 10.4: none of them is coarser than its sieve.
  const auto more = sieve_class_diameters(two, 52);
  CHECK(finer(sample(more), 0.03) == 1);
  CHECK(not_coarser(sample(more), 0.01) == near(0.5, 1e-10));
  CHECK(more.front() > 0.0095);
}

TEST_CASE("a count too small for a class is refused") {
  const std::string error = message_of([] { (void)sieve_class_diameters(rockfill(), 20); });
  CHECK(contains(error, "count = 20: must be larger"));
  CHECK(contains(error, "the class from"));
}

TEST_CASE("a random assembly has the curve, measured again") {
  const std::size_t count = 600;
  const RandomAssembly options{.count = count,
                               .diameters = sieve_class_diameters(rockfill(), count)};
  const Simulation sim{Model{}.boundary(PeriodicCell{}), random_periodic_assembly(options), Rock{}};
  const Grading made = grading(sim.particles());
  for (const GradingPoint& sieve : rockfill().points())
    CHECK(not_coarser(made, sieve.size) == near(sieve.passing, 1e-9));
}
