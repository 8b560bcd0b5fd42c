// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/random_stones.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <riprap/core/units.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/read_outlines.hpp>
#include <riprap/geometry/separation.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>
#include <support/tessellation.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::vector<Stone> library() {
  const Outline l_shape({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Outline notched({{0, 0}, {3, 0}, {3, 1}, {1.5, 0.4}, {0, 1}});
  return stones_of({l_shape, notched});
}

Stone stone_at(const StoneAssembly& sample, const std::vector<std::size_t>& cluster) {
  Stone stone;
  for (const std::size_t i : cluster) stone.cells.push_back(sample.assembly.particles[i].polygon);
  return stone;
}

/// No two cells of different stones lie in each other.
bool stones_are_apart(const StoneAssembly& sample) {
  const auto& particles = sample.assembly.particles;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = i + 1; j < particles.size(); ++j) {
      if (sample.stone[i] == sample.stone[j]) continue;
      SeparatingEdge memory;
      if (!separated(particles[i].polygon.ring(), particles[j].polygon.ring(), memory))
        return false;
    }
  return true;
}

}  // namespace

TEST_CASE("a stone is the parts of its outline, and keeps common vertices when it is moved") {
  const Stone stone = library()[0];
  CHECK(stone.cells.size() == 2);
  CHECK(stone.area() == near(3, 1e-15));
  CHECK((stone.centroid() - Vec2{5.0 / 6, 5.0 / 6}).norm() < 1e-15);
  for (const Pose& pose : poses(1)) {
    const Stone moved = stone.moved(0.01, pose.rotation, pose.shift);
    CHECK(moved.area() == near_relative(3e-4, 1e-9));
    CHECK(
        (moved.centroid() - (pose.shift + 0.01 * (pose.rotation * Vec2{5.0 / 6, 5.0 / 6}))).norm() <
        1e-12);
    CHECK(CellComplex(moved.cells).euler() == 1);
    CHECK(CellComplex(moved.cells).vertices() == 6);
  }
}

TEST_CASE("stones are placed between platens, each whole, of its diameter, apart from others") {
  const RandomAssembly options{.count = 60, .mean_diameter = 0.02, .seed = 3};
  const StoneAssembly sample = random_platen_stones(options, library());
  REQUIRE(sample.stone.size() == sample.assembly.particles.size());
  CHECK(sample.count() == 60);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(sample.stone[i] == no_stone);
    CHECK(sample.assembly.particles[i].motion == Motion::platen);
  }
  CHECK(stones_are_apart(sample));
  double area = 0;
  for (const auto& cluster : sample.clusters()) {
    REQUIRE((cluster.size() == 2 || cluster.size() == 3));
    const Stone stone = stone_at(sample, cluster);
    const CellComplex complex(stone.cells);
    CHECK(complex.euler() == 1);
    CHECK(complex.edges() == complex.boundary().size() + cluster.size() - 1);  // in a chain
    const double d = equivalent_diameter(stone.area());
    CHECK(d >= 0.7 * 0.02 * (1 - 1e-12));
    CHECK(d <= 1.3 * 0.02 * (1 + 1e-12));
    area += stone.area();
  }
  // The faces of the platens bound a square of this solid fraction.
  const double width = 2 * sample.assembly.particles[0].polygon[0].x();
  CHECK(area / (width * width) == near_relative(options.solid_fraction, 1e-12));
}

TEST_CASE("stones in a periodic cell are clear of the images of others") {
  const StoneAssembly sample = random_periodic_stones({.count = 40, .seed = 2}, library());
  CHECK(stones_are_apart(sample));
  for (const Vec2& side : {Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}, Vec2{1, -1}}) {
    const Vec2 offset = componentwise_product(side, sample.assembly.period);
    StoneAssembly both = sample;
    for (std::size_t i = 0; i < sample.stone.size(); ++i) {
      both.assembly.particles.push_back(
          {.polygon = sample.assembly.particles[i].polygon.moved({}, offset)});
      both.stone.push_back(sample.stone[i] + 40);
    }
    CHECK(stones_are_apart(both));
  }
}

TEST_CASE("the cells of each stone can be bonded, and to no other stone") {
  for (StoneAssembly sample : {random_platen_stones({.count = 40, .seed = 3}, library()),
                               random_periodic_stones({.count = 40, .seed = 2}, library())}) {
    std::size_t joints = 0;
    for (const auto& cluster : sample.clusters()) {
      joints += cluster.size() - 1;  // in a chain
      CHECK(bond_common_edges(sample.assembly, cluster) == cluster.size() - 1);
    }
    CHECK(sample.assembly.bonds.size() == joints);
    for (const PlacedBond& bond : sample.assembly.bonds)
      CHECK(sample.stone[bond.a] == sample.stone[bond.b]);
    sample.assembly.validate();
  }
}

TEST_CASE("diameters that are given are used once each, and the library is drawn from evenly") {
  RandomAssembly options{.count = 200, .solid_fraction = 0.3};
  for (int k = 0; k < 200; ++k) options.diameters.push_back(0.01 + 0.0001 * k);
  const StoneAssembly sample = random_platen_stones(options, library());
  std::vector<double> diameters;
  int notched = 0;
  for (const auto& cluster : sample.clusters()) {
    const Stone stone = stone_at(sample, cluster);
    diameters.push_back(equivalent_diameter(stone.area()));
    notched += CellComplex(stone.cells).vertices() == 5;
  }
  std::sort(diameters.begin(), diameters.end());
  for (std::size_t k = 0; k < 200; ++k)
    CHECK(diameters[k] == near_relative(options.diameters[k], 1e-12));
  CHECK(notched == near(100, 4 * std::sqrt(50)));  // four standard deviations
}

TEST_CASE("same seed, same bytes; rules") {
  const StoneAssembly a = random_platen_stones({.count = 40, .seed = 9}, library());
  const StoneAssembly b = random_platen_stones({.count = 40, .seed = 9}, library());
  for (std::size_t i = 0; i < a.stone.size(); ++i)
    CHECK(a.assembly.particles[i].polygon[0] == b.assembly.particles[i].polygon[0]);
  CHECK(contains(message_of([] { (void)random_platen_stones({}, {}); }), "library is empty"));
  CHECK(contains(message_of([] { (void)random_platen_stones({}, {Stone{}}); }),
                 "stone 0 of the library has no cells"));
  CHECK(contains(message_of([] { (void)random_platen_stones({.count = 3}, library()); }),
                 "RandomAssembly.count = 3"));
}

TEST_CASE("the ten stones of the documentation") {
  const auto outlines = read_outlines(
      std::filesystem::path(__FILE__).parent_path() / "../../docs/examples/stones.wkt", 1_mm);
  REQUIRE(outlines.size() == 10);
  const std::vector<Stone> stones = stones_of(outlines);
  std::size_t cells = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    CHECK(stones[k].area() == near_relative(polygon_area(outlines[k].ring()), 1e-13));
    CHECK(equivalent_diameter(stones[k].area()) > 15_mm);
    CHECK(equivalent_diameter(stones[k].area()) < 60_mm);
    cells += stones[k].cells.size();
  }
  CHECK(cells >= 16);  // six have a concave corner
  CHECK(cells <= 34);  // 2 r + 1 of r concave corners, twelve in all
}
