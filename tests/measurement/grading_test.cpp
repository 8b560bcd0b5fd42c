// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/grading.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near_relative;

namespace {

// Round-off of a few logarithms.
constexpr double round_off = 1e-14;

// 20 % of 1 mm, 30 % of 2 mm, 50 % of 5 mm; out of order, one size in two portions.
Grading three_sizes() {
  return Grading::of_fractions(
      {{2e-3, 3}, {5e-3, 4}, {1e-3, 2}, {5e-3, 1}, {0.1e-3, 0}, {7e-3, 0}});
}

// 10 % passes 1 mm, 60 % passes 10 mm, all passes 100 mm.
Grading sieved() { return Grading::of_sieves({{1e-3, 0.1}, {10e-3, 0.6}, {100e-3, 1}}); }

}  // namespace

TEST_CASE("grains of known sizes make a curve of steps") {
  const Grading g = three_sizes();
  CHECK(g.passing(0.99e-3) == 0);
  CHECK(g.passing(1e-3) == near_relative(0.2, round_off));  // a grain passes its own size
  CHECK(g.passing(1.99e-3) == near_relative(0.2, round_off));
  CHECK(g.passing(2e-3) == near_relative(0.5, round_off));
  CHECK(g.passing(4.99e-3) == near_relative(0.5, round_off));
  CHECK(g.passing(5e-3) == 1);
  CHECK(g.passing(1) == 1);
  CHECK(g.size_at(0.1) == 1e-3);
  CHECK(g.size_at(0.3) == near_relative(2e-3, round_off));
  CHECK(g.size_at(0.6) == near_relative(5e-3, round_off));
  CHECK(g.largest() == 5e-3);  // grains of no mass are not there
}

TEST_CASE("between sieves the curve is straight over the logarithm of size") {
  const Grading g = sieved();
  CHECK(g.passing(0.5e-3) == 0);
  CHECK(g.passing(1e-3) == near_relative(0.1, round_off));
  CHECK(g.passing(std::sqrt(10) * 1e-3) == near_relative(0.35, round_off));
  CHECK(g.passing(50e-3) == near_relative(0.6 + 0.4 * std::log10(5), round_off));
  CHECK(g.size_at(0.05) == 1e-3);  // what passes the finest sieve has its size
  CHECK(g.size_at(0.1) == 1e-3);
  CHECK(g.size_at(0.35) == near_relative(std::sqrt(10) * 1e-3, round_off));
  CHECK(g.size_at(0.6) == 10e-3);
  CHECK(g.size_at(1) == 100e-3);
  for (const double share : {0.11, 0.3, 0.59, 0.61, 0.999})
    CHECK(g.passing(g.size_at(share)) == near_relative(share, round_off));
}

TEST_CASE("the area above a size is the mean logarithm of what is coarser") {
  const double ten_to_seventy_four_hundredths =
      Grading::of_fractions({{10e-3, 7}}).area_above(0.074e-3);
  CHECK(ten_to_seventy_four_hundredths == near_relative(2.1307683, 1e-8));
  CHECK(three_sizes().area_above(1e-3) ==
        near_relative(0.3 * std::log10(2) + 0.5 * std::log10(5), round_off));
  CHECK(three_sizes().area_above(2e-3) == near_relative(0.5 * std::log10(2.5), round_off));
  CHECK(three_sizes().area_above(5e-3) == 0);
  // Trapezia between the sieves: means of 0 and 1, and of 1 and 2, decades above 1 mm.
  CHECK(sieved().area_above(1e-3) == near_relative(0.5 * 0.5 + 0.4 * 1.5, round_off));
  CHECK(sieved().area_above(0.1e-3) == near_relative(0.1 + 0.5 * 1.5 + 0.4 * 2.5, round_off));
  // Of the upper trapezium a triangle is left: half a decade wide, 20 % high.
  CHECK(sieved().area_above(std::sqrt(1000) * 1e-3) == near_relative(0.5 * 0.5 * 0.2, round_off));
  CHECK(sieved().area_above(1) == 0);
}

TEST_CASE("a curve does not depend on units, nor on how a fraction is divided") {
  const Grading metres = three_sizes();
  const Grading millimetres =
      Grading::of_fractions({{1, 0.4}, {2, 0.1}, {2, 0.5}, {5, 0.3}, {5, 0.7}});
  for (const double size : {0.5, 1.5, 3.0, 6.0})
    CHECK(millimetres.passing(size) == near_relative(metres.passing(1e-3 * size), round_off));
  CHECK(millimetres.area_above(0.3) == near_relative(metres.area_above(0.3e-3), round_off));
}

TEST_CASE("particles count with their area and the circle of that area, the boundary not at all") {
  Particles particles(0.016, 2500);
  particles.add(test::rectangle(2e-3, 0.5e-3), Motion::free);  // 1 mm^2
  particles.add(test::rectangle(3e-3, 1e-3), Motion::free);
  particles.add(test::rectangle(0.1, 0.1), Motion::strain_field);
  particles.add(test::rectangle(0.2, 0.1), Motion::prescribed);
  const Grading g = grading(particles);
  const double small = std::sqrt(4e-6 / std::numbers::pi);
  CHECK(g.size_at(0.25) == near_relative(small, round_off));
  CHECK(g.passing(1.01 * small) == near_relative(0.25, round_off));
  CHECK(g.largest() == near_relative(std::sqrt(3) * small, round_off));
}

TEST_CASE("pieces of pieces add up to the intact particle they came from") {
  Particles particles(0.016, 2500);
  particles.add(test::rectangle(4e-3, 1e-3), Motion::free);
  particles.add(test::rectangle(1e-3, 1e-3), Motion::free);
  const double largest = grading(particles).largest();
  // A half, and a quarter from the other half; the last quarter takes the parent's place in turn.
  const Ancestry first = particles.ancestry(0);
  particles.replace(0, test::rectangle(2e-3, 1e-3), Motion::free, first);
  const BodyIndex half = particles.add(test::rectangle(2e-3, 1e-3), Motion::free, &first);
  const Ancestry second = particles.ancestry(half);
  particles.replace(half, test::rectangle(1e-3, 1e-3), Motion::free, second);
  particles.add(test::rectangle(1e-3, 1e-3), Motion::free, &second);

  const Grading before = grading_before_breakage(particles);
  CHECK(before.largest() == near_relative(largest, round_off));
  CHECK(before.passing(0.9 * largest) == near_relative(0.2, round_off));
  const Grading after = grading(particles);
  CHECK(after.largest() == near_relative(largest / std::sqrt(2), round_off));
  CHECK(after.passing(0.6 * largest) == near_relative(0.6, round_off));
}

TEST_CASE("dust counts in the grading and in the particle it came from") {
  Particles particles(0.016, 2500);
  particles.add(test::rectangle(4e-3, 1e-3), Motion::free);
  particles.add(test::rectangle(1e-3, 1e-3), Motion::free);
  const Grading intact = grading(particles);
  const Ancestry first = particles.ancestry(0);
  particles.replace(0, test::rectangle(3.5e-3, 1e-3), Motion::free, first);
  particles.add_dust(first, 0.5e-6);
  const Grading before = grading_before_breakage(particles);
  CHECK(before.largest() == near_relative(intact.largest(), round_off));
  CHECK(before.passing(0.9 * intact.largest()) == near_relative(0.2, round_off));
  // 0.5 of 5 mm^2 is dust, 1 the small particle.
  const Grading after = grading(particles);
  CHECK(after.size_at(0.05) == near_relative(std::sqrt(2e-6 / std::numbers::pi), round_off));
  CHECK(after.passing(0.9 * equivalent_diameter(1e-6)) == near_relative(0.1, round_off));
  CHECK(after.passing(0.9 * after.largest()) == near_relative(0.3, round_off));
}

TEST_CASE("the grading of one material has its particles, pieces and dust alone") {
  Particles both(0.016, std::vector<double>{2500, 2000});
  Particles alone(0.016, 2000);
  both.add(test::rectangle(5e-3, 1e-3), Motion::free);
  for (Particles* p : {&both, &alone}) {
    const MaterialIndex material = p == &both ? 1 : 0;
    const BodyIndex i = p->add(test::rectangle(4e-3, 1e-3), Motion::free, nullptr, material);
    p->add(test::rectangle(1e-3, 1e-3), Motion::free, nullptr, material);
    const Ancestry first = p->ancestry(i);
    p->replace(i, test::rectangle(3.5e-3, 1e-3), Motion::free, first);
    p->add_dust(first, 0.5e-6, material);
  }
  both.add_dust(both.ancestry(0), 0.1e-6);
  const auto same = [](const Grading& p, const Grading& q) {
    return std::ranges::equal(p.points(), q.points(), [](const auto& a, const auto& b) {
      return a.size == b.size && a.passing == b.passing;
    });
  };
  CHECK(same(grading(both, 1), grading(alone)));
  CHECK(same(grading_before_breakage(both, 1), grading_before_breakage(alone)));
  CHECK_FALSE(same(grading(both), grading(alone)));
  CHECK(grading_before_breakage(both, 0).points().size() == 2);
  CHECK_THROWS_AS((void)grading(both, 2), InvalidInput);
}

TEST_CASE("rocks of two densities count by mass, before and after breakage") {
  // 4 mm^2 of 1500 kg/m^3 and 2 mm^2 of 3000 kg/m^3, two fifths of that broken off as dust: in
  // shares of the mass 1/2, 1/5 and 3/10.
  Particles particles(0.016, std::vector<double>{1500, 3000});
  particles.add(test::rectangle(4e-3, 1e-3), Motion::free);
  particles.add(test::rectangle(2e-3, 1e-3), Motion::free, nullptr, 1);
  const Ancestry second = particles.ancestry(1);
  particles.replace(1, test::rectangle(1.2e-3, 1e-3), Motion::free, second);
  particles.add_dust(second, 0.8e-6, 1);
  const auto just_above = [](double area) { return 1.001 * equivalent_diameter(area); };
  const Grading before = grading_before_breakage(particles);
  CHECK(before.passing(just_above(2e-6)) == near_relative(1.0 / 2, round_off));
  const Grading after = grading(particles);
  CHECK(after.passing(just_above(0.8e-6)) == near_relative(0.4 / 2, round_off));
  CHECK(after.passing(just_above(1.2e-6)) == near_relative(1.0 / 2, round_off));
}

TEST_CASE("a cluster of cells of two materials: dust counts with its own cell's") {
  Particles particles(0.016, std::vector<double>{2500, 2000});
  for (const MaterialIndex material : {MaterialIndex{0}, MaterialIndex{1}}) {
    const BodyIndex i = particles.add(test::rectangle(2e-3, 1e-3), Motion::free, nullptr, material);
    particles.set_root(i, 0);
  }
  const Ancestry first = particles.ancestry(0);
  particles.replace(0, test::rectangle(1.5e-3, 1e-3), Motion::free, first);
  particles.add_dust(first, 0.5e-6, 0);
  for (const MaterialIndex material : {MaterialIndex{0}, MaterialIndex{1}})
    CHECK(grading_before_breakage(particles, material).largest() ==
          near_relative(equivalent_diameter(2e-6), round_off));
  CHECK(grading(particles, 0).passing(0.9 * equivalent_diameter(1.5e-6)) ==
        near_relative(0.25, round_off));
}

TEST_CASE("gradings that cannot be are refused") {
  using test::message_of;
  const auto fractions = [](std::vector<SizeFraction> f) {
    return message_of([&] { (void)Grading::of_fractions(f); });
  };
  const auto sieves = [](std::vector<GradingPoint> p) {
    return message_of([&] { (void)Grading::of_sieves(p); });
  };
  CHECK(fractions({}) == "Grading: mass of all fractions = 0: must be a finite number above 0");
  CHECK(fractions({{0, 1}}) == "SizeFraction.size = 0: must be a finite number above 0");
  CHECK(fractions({{1, -2}}) == "SizeFraction.mass = -2: must be a finite number, 0 or above");
  CHECK(sieves({}) == "GradingPoint.passing of the last point = 0: must be 1");
  CHECK(sieves({{1, 0.5}, {2, 0.9}}) == "GradingPoint.passing of the last point = 0.9: must be 1");
  CHECK(sieves({{2, 0.5}, {1, 1}}) == "GradingPoint.size = 1: must not descend");
  CHECK(sieves({{1, 0.5}, {2, 0.4}}) ==
        "GradingPoint.passing = 0.4: must lie in [0, 1] and not descend");
  CHECK(sieves({{1, std::nan("")}}) ==
        "GradingPoint.passing = nan: must lie in [0, 1] and not descend");
  const Grading g = three_sizes();
  CHECK(message_of([&] { (void)g.size_at(0); }) == "share that passes = 0: must lie in (0, 1]");
  CHECK(message_of([&] { (void)g.area_above(-1); }) ==
        "lower limit of size = -1: must be a finite number above 0");
}
