// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/element/linear_strain_triangle.hpp>

#include <doctest/doctest.h>

#include <riprap/conformance/acceleration.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

using namespace riprap;

// Simulations with six-node triangles: 25 of them have as many sampling points as 100 of constant
// strain.

namespace {

const auto model = Model{}.mesher(UniformMesher{.triangles = 25}).element(LinearStrainTriangle{});

template <class ModelType>
std::string biaxial(const ModelType& of, std::size_t& breaks) {
  const Assembly assembly = random_assembly({.count = 40, .seed = 1});
  Simulation sim{of, assembly, Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = 16e6, .axial_strain = 0.01}.run(sim, curve);
  breaks = sim.breaks().size();
  return curve_csv(curve) + energy_csv(curve) + breakages_csv(curve);
}

}  // namespace

TEST_CASE("a biaxial test with six-node triangles breaks particles, again with the same bytes") {
  std::size_t breaks = 0;
  const std::string tables = biaxial(model, breaks);
  CHECK(breaks > 0);
  CHECK(biaxial(model, breaks) == tables);
  CHECK(biaxial(model.without_acceleration(), breaks) == tables);
}

TEST_CASE("with six-node triangles, too, no result depends on what only accelerates") {
  CHECK(to_text(acceleration_violations(model)) == "");
}

TEST_CASE("a simulation tells where its stresses are sampled") {
  Simulation sim{model.boundary(NoBoundary{}), internal::closing_platens(), Rock{}};
  const Mesh mesh = sim.mesh(0);
  const auto points = sim.sampling_points(0);
  REQUIRE(points.size() == 4 * mesh.size());
  CHECK(sim.element_stress(0).size() == points.size());
  double area = 0;
  for (const SamplingPoint& point : points) area += point.area;
  CHECK(std::abs(area - sim.particles().shape(0).area) <= 1e-12 * area);
}
