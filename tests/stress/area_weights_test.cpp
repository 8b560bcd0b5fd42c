// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/area_weights.hpp>

#include <doctest/doctest.h>

#include <span>
#include <vector>

#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <support/loaded_particle.hpp>

using namespace riprap;

// Of single precision, 6e-8 of each, and raised by 1e-6.
TEST_CASE("a weight is the area of its point over the mean of all, or a little more") {
  Random random(812);
  for (const auto rule : {std::span<const TrianglePoint>(centroid_rule),
                          std::span<const TrianglePoint>(LinearStrainTriangle::sampling_points)}) {
    const Mesh mesh = test::random_mesh(random, 60);
    const SamplingPoints points(mesh, rule);
    double whole = 0;
    for (std::size_t i = 0; i < points.size(); ++i) whole += points.area(i);
    const std::vector<float> weights = area_weights(points);
    REQUIRE(weights.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double exact = points.area(i) * static_cast<double>(points.size()) / whole;
      CHECK(static_cast<double>(weights[i]) >= exact);
      CHECK(static_cast<double>(weights[i]) <= (1 + 1.2e-6) * exact);
    }
  }
}
