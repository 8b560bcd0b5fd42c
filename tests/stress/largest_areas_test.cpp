// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/largest_areas.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <support/loaded_particle.hpp>

using namespace riprap;

// Against sorting and adding: the bound on the area of n points is above it, by less than 3e-6.
TEST_CASE("fewer points than the largest that reach a share never reach it") {
  Random random(811);
  for (const auto rule : {std::span<const TrianglePoint>(centroid_rule),
                          std::span<const TrianglePoint>(LinearStrainTriangle::sampling_points)}) {
    const Mesh mesh = test::random_mesh(random, 60);
    const SamplingPoints points(mesh, rule);
    std::vector<double> areas;
    for (std::size_t i = 0; i < points.size(); ++i) areas.push_back(points.area(i));
    std::sort(areas.begin(), areas.end(), std::greater<>{});
    double whole = 0;
    for (const double area : areas) whole += area;

    const LargestAreas largest(points);
    CHECK(largest.size() == areas.size());
    double sum = 0;
    for (std::size_t n = 1; n <= areas.size(); ++n) {
      sum += areas[n - 1];
      CHECK(largest.points_for(sum / whole) == n);
      CHECK(largest.points_for(sum / whole + 3e-6) == n + 1);
    }
  }
}

// Of single precision, 6e-8 of each, and raised by 1e-6.
TEST_CASE("a weight is the area of its point over the mean of all, or a little more") {
  Random random(812);
  const Mesh mesh = test::random_mesh(random, 60);
  const SamplingPoints points(mesh, LinearStrainTriangle::sampling_points);
  double whole = 0;
  for (std::size_t i = 0; i < points.size(); ++i) whole += points.area(i);
  const LargestAreas largest(points);
  REQUIRE(largest.weights().size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double exact = points.area(i) * static_cast<double>(points.size()) / whole;
    CHECK(static_cast<double>(largest.weights()[i]) >= exact);
    CHECK(static_cast<double>(largest.weights()[i]) <= (1 + 1.2e-6) * exact);
  }
}

TEST_CASE("without points nothing is reached") { CHECK(LargestAreas{}.points_for(0.4) == 1); }
