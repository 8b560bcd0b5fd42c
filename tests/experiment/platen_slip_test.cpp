// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/platen_slip.hpp>

#include <doctest/doctest.h>

#include <limits>

#include <riprap/core/random.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

// Normal forces about 1 N, a symmetric positive definite lateral stiffness, and normal forces that
// slip changes by some `coupling` [N/m].
PlatenNodes random_nodes(Eigen::Index count, double coupling, Random& random) {
  PlatenNodes nodes{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::MatrixXd(count, count),
                    Eigen::MatrixXd(count, count)};
  Eigen::MatrixXd root(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    nodes.pressed[i] = random.uniform(0.5, 1.5);
    nodes.held[i] = random.uniform(-1, 1);
    for (Eigen::Index j = 0; j < count; ++j) {
      root(i, j) = random.uniform(-1, 1);
      nodes.pressed_per_slip(i, j) = coupling * random.uniform(-1, 1);
    }
  }
  nodes.held_per_slip = root * root.transpose() + 0.5 * Eigen::MatrixXd::Identity(count, count);
  return nodes;
}

}  // namespace

TEST_CASE("one node slips until friction holds it") {
  const PlatenNodes node{Eigen::VectorXd::Constant(1, 10), Eigen::VectorXd::Constant(1, 5),
                         Eigen::MatrixXd::Constant(1, 1, 0), Eigen::MatrixXd::Constant(1, 1, 2)};
  CHECK(coulomb_slip(node, 0.6)[0] == 0);
  CHECK(coulomb_slip(node, 0.5)[0] == 0);
  CHECK(coulomb_slip(node, 0.3)[0] == near(-1, 1e-12));  // 5 + 2 v = 0.3 x 10
}

TEST_CASE("a node that slips presses less: its limit is that of the force in the end") {
  const PlatenNodes node{Eigen::VectorXd::Constant(1, 10), Eigen::VectorXd::Constant(1, -5),
                         Eigen::MatrixXd::Constant(1, 1, -1), Eigen::MatrixXd::Constant(1, 1, 2)};
  // -5 + 2 v = -0.3 (10 - v)
  CHECK(coulomb_slip(node, 0.3)[0] == near(2 / 1.7, 1e-10));
}

TEST_CASE("many nodes obey Coulomb's law, sticking or slipping") {
  Random random(401);
  int sticking = 0;
  int slipping = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const PlatenNodes nodes = random_nodes(6, sample % 2 == 0 ? 0 : 0.2, random);
    const double friction = 0.4;
    const Eigen::VectorXd v = coulomb_slip(nodes, friction);
    const Eigen::VectorXd lateral = nodes.held + nodes.held_per_slip * v;
    const Eigen::VectorXd limits =
        friction * (nodes.pressed + nodes.pressed_per_slip * v).cwiseMax(0);
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      // What the iterations leave, in forces of about 1 N.
      CHECK(std::abs(lateral[i]) <= limits[i] + 1e-9);
      if (v[i] != 0) CHECK(lateral[i] == near(v[i] > 0 ? -limits[i] : limits[i], 1e-9));
      (v[i] != 0 ? slipping : sticking) += 1;
    }
  }
  CHECK(sticking > 50);
  CHECK(slipping > 50);
}

TEST_CASE("bad friction is named, and limits that run away are an error") {
  Random random(402);
  const PlatenNodes nodes = random_nodes(2, 0, random);
  for (const double bad : {0.0, -0.1, std::numeric_limits<double>::infinity()})
    CHECK(test::contains(test::message_of([&] { (void)coulomb_slip(nodes, bad); }),
                         "coulomb_slip: friction"));
  // 5 + 2 v = +-2 (1 - 4 v): every limit asks for another slip.
  const PlatenNodes wedge{Eigen::VectorXd::Constant(1, 1), Eigen::VectorXd::Constant(1, 5),
                          Eigen::MatrixXd::Constant(1, 1, -4), Eigen::MatrixXd::Constant(1, 1, 2)};
  CHECK_THROWS_AS((void)coulomb_slip(wedge, 2), SimulationError);
}
