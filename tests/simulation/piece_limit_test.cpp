// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/piece_limit.hpp>

#include <doctest/doctest.h>

#include <string>

#include <riprap/breakage/trigger/any_element.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>

using namespace riprap;

TEST_CASE("a particle may break until its root has as many pieces as the splitter allows") {
  const StraightCut splitter{.maximum_pieces = 3};
  PieceLimit limit;
  const Ancestry root{.id = 4, .root = 4};
  const Ancestry piece{.id = 9, .parent = 4, .root = 4, .generation = 1};
  CHECK_NOTHROW(limit.add_break(splitter, root));
  CHECK_NOTHROW(limit.add_break(splitter, Ancestry{.id = 5, .root = 5}));
  CHECK_NOTHROW(limit.add_break(splitter, piece));
  CHECK_THROWS_WITH_AS(
      limit.add_break(splitter, piece),
      doctest::Contains("particle 9 of generation 1 is to break, and its root, particle 4, has 3 "
                        "pieces already, the splitter's maximum_pieces."),
      SimulationError);
  const auto unlimited = [](Ring ring, const Line& line, double) { return cut(ring, line); };
  for (int i = 0; i < 1000; ++i) CHECK_NOTHROW(limit.add_break(unlimited, root));
}

TEST_CASE("a cluster may have as many pieces for each of its cells") {
  const StraightCut splitter{.maximum_pieces = 3};
  Particles particles(1, 1);
  for (BodyIndex i = 0; i < 3; ++i)
    particles.set_root(particles.add(ConvexPolygon{{0, 0}, {1, 0}, {0, 1}}, Motion::free), i / 2);
  PieceLimit limit;
  limit.count_cells(particles);
  const auto break_often = [&](ParticleId root) {
    const Ancestry cell{.id = root, .root = root};
    int breaks = 0;
    try {
      for (; breaks < 100; ++breaks) limit.add_break(splitter, cell);
    } catch (const SimulationError&) {
    }
    return breaks;
  };
  CHECK(break_often(0) == 2 * 3 - 2);  // two cells become six pieces
  CHECK(break_often(1) == 3 - 1);
}

TEST_CASE("breaking without end is an error, and the state is that before the last break") {
  constexpr StraightCut endless{.minimum_area = 0, .maximum_aspect = 1e9, .maximum_pieces = 5};
  Simulation sim{Model{}.boundary(NoBoundary{}).splitter(endless).trigger(AnyElement{}),
                 test::square_between_platens(0.5), Rock{}};
  std::string said;
  try {
    for (int i = 0; i < 20'000; ++i) sim.step();
  } catch (const SimulationError& error) {
    said = error.what();
  }
  CHECK(said.find("has 5 pieces already") != std::string::npos);
  CHECK(sim.breaks().size() <= 4);
  CHECK(sim.particles().size() == 3 + sim.breaks().size());
}
