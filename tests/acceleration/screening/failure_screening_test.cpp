// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/failure_screening.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/franklin.hpp>
#include <riprap/breakage/criterion/griffith.hpp>
#include <riprap/breakage/criterion/hobbs.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/modified_griffith.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/murrell.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/breakage/criterion/rock_mass.hpp>
#include <riprap/breakage/criterion/three_principal_stresses.hpp>
#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/core/random.hpp>
#include <support/near.hpp>

using namespace riprap;

namespace {

// Shears however small the tension, which never breaks it.
struct ShearOnly {
  double major_stress_at_failure(double minor) const { return 2 * minor + 50e6; }
  double tensile_strength() const { return std::numeric_limits<double>::infinity(); }
};

// A curve with a jump and a corner.
struct Jagged {
  double major_stress_at_failure(double minor) const {
    return minor + (minor < 3e6 ? 20e6 : 45e6) + (minor > 10e6 ? 4 * (minor - 10e6) : 0);
  }
  double tensile_strength() const { return 5e6; }
};

double radius_at_least(const MohrRadiusTable& radii, double centre) {
  const auto single = static_cast<float>(centre);
  std::vector<float> found;
  radii.lower_bound(std::span(&single, 1), found);
  return static_cast<double>(found[0]);
}

template <class C>
bool fails(const C& criterion, double centre, double radius) {
  return evaluate(criterion, Stress2{centre + radius, centre - radius, 0}).failed();
}

// The radius in the table against the criterion: just below it nothing has failed, and a little
// above it, by a step of the table, all have.
template <class C>
void check_radii(const C& criterion, double lowest, double highest, double steps = 1.01) {
  MohrRadiusTable radii = MohrRadiusTable::of(criterion);
  Random random(71);
  for (int i = 0; i < 20000; ++i) {
    const double centre = random.uniform(lowest, highest);
    const double radius = radius_at_least(radii, centre);
    if (radius > 0) CHECK_FALSE(fails(criterion, centre, radius));
    const double above = std::max(0.0, radius) + steps * static_cast<double>(radii.step());
    CHECK(fails(criterion, centre, above));
  }
}

ElementStressF32 compact(const std::vector<Stress2>& elements, double error = 0) {
  ElementStressF32 stress;
  stress.elements = elements.size();
  stress.stride = (stress.elements + 7) / 8 * 8;
  stress.values.assign(3 * stress.stride, 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    stress.values[e] = static_cast<float>(elements[e].s11);
    stress.values[stress.stride + e] = static_cast<float>(elements[e].s22);
    stress.values[2 * stress.stride + e] = static_cast<float>(elements[e].s12);
  }
  stress.error = error;
  return stress;
}

Stress2 random_stress(Random& random, double centre, double radius) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {centre + radius * std::cos(angle), centre - radius * std::cos(angle),
          radius * std::sin(angle)};
}

}  // namespace

TEST_CASE("no circle smaller than the tabled radius has failed, and hardly a larger one has not") {
  check_radii(HoekBrown{}, -20e6, 600e6);
  check_radii(HoekBrown{.compressive_strength = 1e6, .m_b = 10, .s = 0.3, .a_b = 0.6}, -1e5, 1.5e6);
  check_radii(MohrCoulomb{}, -20e6, 600e6);
  check_radii(Rankine{}, -20e6, 600e6);
  check_radii(RockMass{.gsi = 30}.hoek_brown(), -1e6, 20e6);
  check_radii(Griffith{}, -20e6, 300e6);
  check_radii(ModifiedGriffith{.friction = 0.5}, -20e6, 300e6);
  check_radii(Murrell{}, -20e6, 300e6);
  check_radii(Hobbs{}, -20e6, 600e6);
  check_radii(Franklin{}, -20e6, 600e6);
  check_radii(Jagged{}, -10e6, 100e6);
  check_radii(ShearOnly{}, -20e6, 60e6);
  check_radii(CriterionChoice<HoekBrown, Rankine>{Rankine{}}, -20e6, 600e6);
}

// Where the radius at failure rises and falls with the centre no faster than it, the bounds between
// two entries lose up to two steps more.
TEST_CASE("the same for the stress out of the plane, which makes radii fall") {
  for (const double ratio : {0.0, 0.17, 0.3, 0.49}) {
    check_radii(ThreePrincipalStresses{HoekBrown{}, ratio}, -20e6, 1100e6, 3.01);
    check_radii(ThreePrincipalStresses{MohrCoulomb{}, ratio}, -20e6, 1100e6, 3.01);
    check_radii(ThreePrincipalStresses{Griffith{}, ratio}, -20e6, 350e6, 3.01);
    check_radii(ThreePrincipalStresses{Rankine{}, ratio}, -20e6, 700e6, 3.01);
    check_radii(ThreePrincipalStresses{Hobbs{}, ratio}, -20e6, 1100e6, 3.01);
  }
}

namespace {

// Almost flat, then steep: under pressure from all sides in plane strain rock that has failed
// becomes intact again.
struct Steepening {
  double major_stress_at_failure(double minor) const {
    return minor + 20e6 + (minor > 40e6 ? 5 * (minor - 40e6) : 0);
  }
  double tensile_strength() const { return 5e6; }
};

// No change of stress by less than the tabled distance makes an intact element fail.
template <class C>
void check_distances(const C& criterion, double lowest, double highest) {
  MohrRadiusTable radii = MohrRadiusTable::of(criterion);
  Random random(74);
  int worked = 0;
  for (int i = 0; i < 20000; ++i) {
    const double centre = random.uniform(lowest, highest);
    const double bound = radius_at_least(radii, centre);
    const double radius = random.uniform(0, 1) * bound;
    const double distance = bound - radius;
    if (!(distance > 0)) continue;
    const double shift = random.uniform(-1, 1) * distance;
    CHECK_FALSE(fails(criterion, centre + shift, radius + distance - std::abs(shift)));
    ++worked;
  }
  CHECK(worked > 1000);
}

}  // namespace

TEST_CASE("no change of stress by less than the distance makes an intact element fail") {
  check_distances(HoekBrown{}, -20e6, 600e6);
  for (const double ratio : {0.0, 0.17, 0.3, 0.49})
    check_distances(ThreePrincipalStresses{HoekBrown{}, ratio}, -20e6, 1200e6);
  REQUIRE(fails(ThreePrincipalStresses{Steepening{}, 0.25}, 80e6, 0));
  REQUIRE(!fails(ThreePrincipalStresses{Steepening{}, 0.25}, 75e6 * 2, 0));
  check_distances(ThreePrincipalStresses{Steepening{}, 0.25}, -10e6, 200e6);
  check_distances(ThreePrincipalStresses{Jagged{}, 0.3}, -10e6, 100e6);
}

TEST_CASE("beyond the table the radius is still on the safe side") {
  const auto check = [](const auto& criterion) {
    MohrRadiusTable radii = MohrRadiusTable::of(criterion);
    for (const double centre : {-1e12, -1e9, 2e9, 1e11, 1e13}) {
      const double radius = radius_at_least(radii, centre);
      if (radius > 0) CHECK_FALSE(fails(criterion, centre, radius));
    }
  };
  check(HoekBrown{});
  for (const double ratio : {0.0, 0.17, 0.49}) check(ThreePrincipalStresses{HoekBrown{}, ratio});
}

TEST_CASE("what never fails is infinitely far from failure") {
  MohrRadiusTable radii = MohrRadiusTable::of(NeverFails{});
  for (const double centre : {-1e9, 0.0, 1e9})
    CHECK((centre < 0 || std::isinf(radius_at_least(radii, centre))));
}

TEST_CASE("every element that has failed is among those that may have") {
  const HoekBrown criterion;
  FailureScreening screening{MohrRadiusTable::of(criterion)};
  Random random(72);
  std::size_t failed = 0;
  std::size_t possible = 0;
  for (int sample = 0; sample < 300; ++sample) {
    std::vector<Stress2> elements;
    ElementStress exact;
    exact.reset(100);
    for (std::size_t e = 0; e < 100; ++e) {
      elements.push_back(
          random_stress(random, random.uniform(-10e6, 200e6), random.uniform(0, 250e6)));
      exact.set(e, elements.back());
    }
    const std::size_t count = count_failures(criterion, exact).failed;
    const std::size_t bound = screening(compact(elements), 1000).possible;
    CHECK(bound >= count);
    failed += count;
    possible += bound;
  }
  // A quarter of the table's step against 250 MPa of radii, in both directions.
  CHECK(static_cast<double>(possible) <= 1.005 * static_cast<double>(failed));
}

TEST_CASE("an error of the stresses counts as so much distance") {
  FailureScreening screening{MohrRadiusTable::of(HoekBrown{})};
  // 1 MPa below uniaxial failure.
  const std::vector<Stress2> near_failure(10, Stress2{298e6, 0, 0});
  CHECK(screening(compact(near_failure), 5).possible == 0);
  CHECK(screening(compact(near_failure, 1e6), 5).possible == 10);
}

TEST_CASE("under a change just below the margin fewer elements fail than are needed") {
  const HoekBrown criterion;
  FailureScreening screening{MohrRadiusTable::of(criterion)};
  Random random(73);
  int worked = 0;
  for (int sample = 0; sample < 200; ++sample) {
    std::vector<Stress2> elements;
    std::vector<double> distances;
    for (int e = 0; e < 50; ++e) {
      const double centre = random.uniform(0, 100e6);
      const double radius = random.uniform(0, 150e6);
      elements.push_back(random_stress(random, centre, radius));
      double limit = radius;
      while (!fails(criterion, centre, limit)) limit += 1e4;
      distances.push_back(limit - radius);
    }
    const std::size_t needed = random.uniform_integer(20, 40);
    const ScreeningResult result = screening(compact(elements), needed);
    if (result.possible >= needed) continue;
    // The cheapest way to failure of so many: each moves by its distance in spectral norm, with a
    // change of twice that in the difference of the principal stresses, sqrt(2) in Frobenius norm;
    // the least Frobenius norm of a change of spectral norm x is x.
    std::vector<double> costs;
    for (std::size_t e = 0; e < distances.size(); ++e)
      costs.push_back(distances[e] * static_cast<double>(screening.factors()[e]));
    std::sort(costs.begin(), costs.end());
    double square = 0;
    for (std::size_t e = 0; e < needed; ++e) square += costs[e] * costs[e];
    CHECK(result.stress_margin <= std::sqrt(square));
    // The table loses a quarter of its step.
    CHECK(result.stress_margin >= 0.8 * std::sqrt(square) - 1e6 * std::sqrt(needed));
    ++worked;
  }
  CHECK(worked > 50);
}

TEST_CASE("a trigger that needs more elements than there are never fires") {
  FailureScreening screening{MohrRadiusTable::of(HoekBrown{})};
  CHECK(std::isinf(screening(compact({{1e6, 0, 0}, {2e6, 0, 0}}), 3).stress_margin));
}

TEST_CASE("in units without numbers in single precision every element may have failed") {
  for (const double unit : {1e-60, 1e60}) {
    FailureScreening screening{MohrRadiusTable::of(Rankine{.tension = 12e6 * unit})};
    CHECK(screening(compact({{1e6, 0, 0}, {2e6, 0, 0}}), 2).possible == 2);
  }
  FailureScreening screening{MohrRadiusTable::of(HoekBrown{})};
  CHECK(screening(compact({{1e6, 0, 0}}, std::numeric_limits<double>::infinity()), 1).possible ==
        1);
}

TEST_CASE("weights say as much as numbers where all are equal, and no set of elements beats them") {
  Random random(11);
  const MohrRadiusTable radii = MohrRadiusTable::of(HoekBrown{});
  FailureScreening screening(radii);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Stress2> elements;
    std::vector<double> distances;
    for (int e = 0; e < 20; ++e) {
      const double centre = random.uniform(-2e6, 15e6);
      const double radius = random.uniform(0, 12e6);
      elements.push_back(random_stress(random, centre, radius));
      distances.push_back(std::max(0.0, radius_at_least(radii, centre) - radius));
    }
    const ElementStressF32 stress = compact(elements);
    const double by_number = screening(stress, 8).stress_margin;
    // Round-off is allowed for by 2e-5 of the weights, of 8 that reach the number.
    const double by_weight = screening(stress, std::vector<float>(20, 1.0f), 8).stress_margin;
    CHECK(by_weight <= (1 + 1e-6) * by_number);
    CHECK(by_weight >= 0.99 * by_number);

    std::vector<float> weights(20);
    for (float& w : weights) w = static_cast<float>(random.uniform(0.5, 1.5));
    const double margin = screening(stress, weights, 8).stress_margin;
    for (int set = 0; set < 50; ++set) {
      double weight = 0;
      double square = 0;
      while (weight < 8) {
        const std::size_t e = random.uniform_integer(0, 19);
        if (weights[e] < 0) continue;  // in the set
        weight += static_cast<double>(weights[e]);
        const double cost = static_cast<double>(screening.factors()[e]) * distances[e];
        square += cost * cost;
        weights[e] = -weights[e];
      }
      for (float& w : weights) w = std::abs(w);
      // Distances are found in single precision from stresses of some MPa.
      CHECK(margin <= (1 + 1e-5) * std::sqrt(square) + 10);
    }
  }
}

TEST_CASE("weights of many elements add up to what they are") {
  // Elements of 1.0002 and 0.9998, of which 8,000 of the larger have failed. Added up one by one in
  // single precision, every one beyond 4,096 counts as 1: the sum is 0.8 too small.
  constexpr std::size_t elements = 20000;
  constexpr std::size_t failed = 8000;
  FailureScreening screening(MohrRadiusTable::of(Rankine{.tension = 12e6}));
  ElementStressF32 stress;
  stress.elements = stress.stride = elements;
  stress.values.assign(3 * elements, 0);
  std::vector<float> weights(elements, 0.9998f);
  for (std::size_t i = 0; i < elements / 2; ++i) weights[i] = 1.0002f;
  for (std::size_t i = 0; i < failed; ++i) stress.values[i] = -20e6f;
  CHECK(screening(stress, weights, 1.0002 * failed).possible == failed);
  // 2e-5 of all weights are allowed for.
  CHECK(screening(stress, weights, 1.0002 * failed + 0.5).possible == 0);
}
