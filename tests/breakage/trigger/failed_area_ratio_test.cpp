// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/failed_area_ratio.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>

using namespace riprap;

namespace {

// A strip of right-angled triangles, one for each width.
Mesh strip(const std::vector<double>& widths) {
  Mesh mesh;
  mesh.nodes.push_back({0, 0});
  for (std::size_t k = 0; k < widths.size(); ++k) {
    mesh.nodes.push_back({mesh.nodes[k].x() + widths[k], 0});
    mesh.triangles.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k + 1), 0});
  }
  for (const double width : widths) mesh.nodes.push_back({width, 1});
  for (std::size_t k = 0; k < widths.size(); ++k)
    mesh.triangles[k][2] = static_cast<std::uint32_t>(widths.size() + 1 + k);
  return mesh;
}

std::size_t breaks_of(const auto& model, double* first = nullptr) {
  Simulation sim{model, internal::closing_platens(), Rock{}};
  for (int step = 0; step < 1200; ++step) sim.step();
  if (first && !sim.breaks().empty()) *first = sim.breaks()[0].failures.area_ratio();
  return sim.breaks().size();
}

}  // namespace

TEST_CASE("a particle breaks when the failed share of its area reaches the limit") {
  const FailedAreaRatio trigger;  // 0.4
  CHECK(trigger({.elements = 3, .failed = 1, .failed_area = 4e-5, .area = 1e-4}));
  CHECK(trigger({.elements = 100, .failed = 10, .failed_area = 9e-5, .area = 1e-4}));
  CHECK_FALSE(trigger({.elements = 100, .failed = 90, .failed_area = 3.9e-5, .area = 1e-4}));
  CHECK_FALSE(trigger({.elements = 100, .failed = 0, .failed_area = 0, .area = 1e-4}));
  CHECK_FALSE(trigger({.elements = 100, .failed = 100}));  // areas not asked for
}

TEST_CASE("for equal areas it is the failed-element ratio, and needs as many elements") {
  for (const double critical : {0.1, 0.3, 0.4, 1.0 / 3, 0.7, 1.0, 1.01})
    for (const unsigned elements : {25u, 30u, 100u, 103u}) {
      const std::vector<double> widths(elements, 0.1);
      const Mesh mesh = strip(widths);
      const FailedAreaRatio by_area{critical};
      const FailedElementRatio by_count{critical};
      double area = 0;
      for (std::size_t e = 0; e < elements; ++e) area += mesh.area(e);
      double failed_area = 0;
      for (std::size_t failed = 0; failed <= elements; ++failed) {
        const FailureCount count{
            .elements = elements, .failed = failed, .failed_area = failed_area, .area = area};
        CHECK(by_area(count) == by_count(count));
        if (failed < elements) failed_area += mesh.area(failed);
      }
    }
}

TEST_CASE("the limit must be a positive number") {
  CHECK_THROWS_WITH_AS(FailedAreaRatio{0}.validate(),
                       "FailedAreaRatio.critical = 0: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_AS(FailedAreaRatio{std::nan("")}.validate(), InvalidInput);
}

TEST_CASE("particles break by it at the same step and with the same bytes without screening") {
  const auto model = Model{}.trigger(FailedAreaRatio{0.3});
  double first = 0;
  CHECK(breaks_of(model, &first) > 0);
  CHECK(first >= 0.3 - 1e-9);
  CHECK(first <= 1);
  CHECK(to_text(acceleration_violations(model)) == "");
  const auto six_nodes =
      model.mesher(UniformMesher{.triangles = 25}).element(LinearStrainTriangle{});
  CHECK(breaks_of(six_nodes) > 0);
  CHECK(to_text(acceleration_violations(six_nodes)) == "");
}
