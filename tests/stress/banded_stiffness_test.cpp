// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/banded_stiffness.hpp>

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/stress/mesher/mid_side_nodes.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

using namespace riprap;

namespace {

constexpr double side = 0.016;

[[nodiscard]] Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

// Of every element a matrix a a^T + 1 with random a, which has entries wherever a stiffness has
// them, and eigenvalues of 1 and more.
void add_random(const Mesh& mesh, std::size_t nodes, Random& random, BandedStiffness& banded,
                Eigen::MatrixXd& dense) {
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    std::vector<double> a(2 * nodes);
    for (double& x : a) x = random.uniform(-1, 1);
    for (std::size_t p = 0; p < a.size(); ++p)
      for (std::size_t q = 0; q < a.size(); ++q) {
        const std::size_t row = banded.row(mesh.node(e, p / 2), p % 2);
        const std::size_t column = banded.row(mesh.node(e, q / 2), q % 2);
        const double entry = a[p] * a[q] + (p == q ? 1 : 0);
        banded.add(row, column, entry);
        dense(index(row), index(column)) += entry;
      }
  }
}

}  // namespace

TEST_CASE("solutions are those of the whole matrix, for three and six nodes of an element") {
  Random random(4);
  for (int trial = 0; trial < 10; ++trial) {
    const ConvexPolygon polygon = random_polygon(PolygonShape{}, side, random);
    const Mesh corners = UniformMesher{60}(polygon.ring());
    for (const std::size_t nodes : {3U, 6U}) {
      const Mesh mesh = nodes == 3 ? corners : with_mid_side_nodes(corners);
      BandedStiffness banded(mesh, nodes);
      REQUIRE(banded.size() == 2 * mesh.nodes.size());
      Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(index(banded.size()), index(banded.size()));
      add_random(mesh, nodes, random, banded, dense);

      constexpr std::size_t loads = 5;  // no multiple of the lanes of a vector register
      std::vector<double> sides(banded.size() * loads);
      for (double& x : sides) x = random.uniform(-1, 1);
      Eigen::MatrixXd expected(index(banded.size()), index(loads));
      for (std::size_t i = 0; i < sides.size(); ++i)
        expected(index(i / loads), index(i % loads)) = sides[i];
      expected = dense.ldlt().solve(expected).eval();

      banded.factorise();
      banded.solve(sides, loads);
      double worst = 0;
      for (std::size_t i = 0; i < sides.size(); ++i)
        worst = std::max(worst, std::abs(sides[i] - expected(index(i / loads), index(i % loads))));
      // The condition number is below 1e2, the round-off of some tens of operations 1e-15 each.
      CHECK(worst < 1e-11 * expected.norm());
    }
  }
}

TEST_CASE("three springs hold the particle and nothing else") {
  const Mesh mesh = UniformMesher{30}(ConvexPolygon{{-2, -1}, {2, -1}, {1, 1}, {-1, 2}}.ring());
  BandedStiffness springs(mesh, 3);
  // Unit stiffness of every node to the ground: its inverse shows what the springs add.
  for (std::size_t i = 0; i < springs.size(); ++i) springs.add(i, i, 1);
  springs.hold(mesh);
  springs.factorise();
  std::vector<double> sides(springs.size(), 1);
  springs.solve(sides, 1);
  std::size_t held = 0;
  for (const double x : sides) held += x < 1 - 1e-12 ? 1 : 0;
  CHECK(sides[0] == 0.5);
  CHECK(sides[1] == 0.5);
  CHECK(held <= 4);
}
