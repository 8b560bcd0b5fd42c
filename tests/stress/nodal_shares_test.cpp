// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/nodal_shares.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <riprap/core/random.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

TEST_CASE("a linear side shares a force between its two nodes") {
  const NodalShares shares = nodal_shares({4, 5, 0.3}, false, 10);
  CHECK(shares.count == 2);
  CHECK(shares.nodes[0] == 4);
  CHECK(shares.nodes[1] == 5);
  CHECK(shares.weights[0] == 0.3);
  CHECK(shares.weights[1] == 0.7);
}

TEST_CASE("at a quarter of a quadratic side the shares are 3/8, 3/4 and -1/8") {
  // (1-t)(1-2t), 4t(1-t), t(2t-1) at t = 1/4; from the far corner likewise.
  const NodalShares first = nodal_shares({8, 9, 0.5}, true, 10);
  CHECK(first.nodes == std::array<std::uint32_t, 3>{8, 9, 0});
  CHECK(first.weights == std::array{0.375, 0.75, -0.125});
  const NodalShares second = nodal_shares({9, 0, 0.5}, true, 10);
  CHECK(second.nodes == std::array<std::uint32_t, 3>{9, 0, 8});
  CHECK(second.weights == std::array{0.75, 0.375, -0.125});
}

TEST_CASE("quadratic shares are 1 at their nodes and keep force, moment and second moment") {
  for (const std::uint32_t node : {0u, 1u, 2u, 3u}) {
    const std::uint32_t next = (node + 1) % 4;
    CHECK(nodal_shares({node, next, 1}, true, 4).weights[0] == 1);
    CHECK(nodal_shares({node, next, 0}, true, 4).weights[1] == 1);
  }
  Random random(31);
  for (int k = 0; k < 100; ++k) {
    const std::uint32_t node = random.uniform_integer(0, 1);
    const double weight = random.uniform(0, 1);
    const NodalShares shares = nodal_shares({node, node + 1, weight}, true, 100);
    // Node i of the side lies at i; t^n is reproduced for n = 0, 1, 2.
    const double at = node + 1 - weight;
    for (const int power : {0, 1, 2}) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += shares.weights[i] * std::pow(double(shares.nodes[i]), power);
      CHECK(sum == near(std::pow(at, power), 1e-14));
    }
    double absolute = 0;
    for (const double w : shares.weights) absolute += std::abs(w);
    CHECK(absolute <= 1.25 + 1e-15);  // what the screening relies on
  }
}

TEST_CASE("a quadratic side is named by a node and the one after it") {
  // Backwards, across a corner, and past the last node.
  for (const BoundaryPoint& at :
       {BoundaryPoint{5, 4, 0.5}, BoundaryPoint{4, 6, 0.5}, BoundaryPoint{9, 10, 0.5}}) {
    CHECK(test::message_of([&] { (void)nodal_shares(at, true, 10); }) ==
          "BoundaryPoint.next = " + std::to_string(at.next) +
              ": must be the node after BoundaryPoint.node");
    CHECK_NOTHROW((void)nodal_shares(at, false, 10));
  }
}
