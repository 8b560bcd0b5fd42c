// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/breakage_pass.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/splitter/no_split.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/simulation/simulation.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <support/breakage_passes.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Counts its calls, and refuses.
struct CountingSplitter {
  int* asked;
  std::optional<CutRings> operator()(Ring, const Line&, double) const {
    ++*asked;
    return std::nullopt;
  }
};

}  // namespace

TEST_CASE("every free particle that is overloaded has a crack") {
  const auto model = Model{};
  const Simulation sim{model, crushed, Rock{}};
  Pass pass(model);
  const auto& cracks = pass.find(sim);
  REQUIRE(cracks.size() == 2);
  CHECK(cracks[0].first == 0);
  CHECK(cracks[1].first == 3);
}

TEST_CASE("a refused cut is not tried again while the partners are the same") {
  int asked = 0;
  const auto model = Model{}.splitter(CountingSplitter{&asked});
  Simulation sim{model, crushed, Rock{}};
  Pass pass(model);
  const auto find = [&](const auto& simulation) { return pass.find(simulation).size(); };
  CHECK(find(sim) == 0);
  CHECK(asked == 2);
  CHECK(find(sim) == 0);
  CHECK(asked == 2);
  // A block that touches the left square is one more partner.
  Assembly joined = crushed;
  joined.particles.push_back({square.moved({}, {-0.03099, 0.002})});
  const Simulation other{model, joined, Rock{}};
  find(other);
  CHECK(asked >= 3);
  const int so_far = asked;
  find(sim);
  CHECK(asked == so_far + 1);
}

TEST_CASE("a contact that begins or ends is considered, whatever the bounds before") {
  const auto model = Model{};
  const Simulation loaded{model, crushed, Rock{}};
  // The same pairs; the platen above the particle on the right, or both of them, do not touch.
  Assembly above = crushed;
  above.particles[1].polygon = platen.moved({}, {0, 0.0161});
  const Simulation resting{model, above, Rock{}};
  Assembly none = above;
  none.particles[2].polygon = platen.moved({}, {0, -0.0161});
  const Simulation free{model, none, Rock{}};
  REQUIRE(loaded.contacts().revision() == resting.contacts().revision());
  REQUIRE(loaded.contacts().revision() == free.contacts().revision());

  Pass pass(model);
  const auto find = [&](const auto& sim) { return pass.find(sim).size(); };
  const auto expected = [&](const auto& sim) { return Pass(model).find(sim).size(); };
  REQUIRE(expected(loaded) == 2);
  for (const auto* sim : {&free, &free, &loaded, &free, &resting, &resting, &loaded, &resting,
                          &free, &resting, &loaded})
    CHECK(find(*sim) == expected(*sim));
}

namespace {

// Cuts into a ring that repeats its first vertex, a clockwise ring, and pieces that
// are larger than the whole.
struct ClosedRings {
  std::optional<CutRings> operator()(Ring ring, const Line& line, double) const {
    std::optional<CutRings> pieces = cut(ring, line);
    if (pieces) pieces->left.push_back(pieces->left.front());
    return pieces;
  }
};
struct ClockwiseRings {
  std::optional<CutRings> operator()(Ring ring, const Line& line, double) const {
    std::optional<CutRings> pieces = cut(ring, line);
    if (pieces) std::reverse(pieces->right.begin(), pieces->right.end());
    return pieces;
  }
};
struct TwoWholes {
  std::optional<CutRings> operator()(Ring ring, const Line&, double) const {
    return CutRings{{ring.begin(), ring.end()}, {ring.begin(), ring.end()}};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("a piece that breaks a rule of polygons is a refusal, and the state stays whole",
                   Split, ClosedRings, ClockwiseRings) {
  Simulation sim{Model{}.boundary(NoBoundary{}).splitter(Split{}), crushed, Rock{}};
  for (int i = 0; i < 5; ++i) CHECK_NOTHROW(sim.step());
  CHECK(sim.breaks().empty());
  CHECK(sim.particles().size() == 4);
}

TEST_CASE("pieces of more area than the particle are an error that names it") {
  Simulation sim{Model{}.boundary(NoBoundary{}).splitter(TwoWholes{}), crushed, Rock{}};
  CHECK_THROWS_WITH_AS(
      sim.step(), "particle 0: splitter: area of both pieces over the particle's = 2: must be 1",
      SimulationError);
  CHECK(sim.breaks().empty());
  CHECK(sim.particles().size() == 4);
}

TEST_CASE("loads that are not finite are an error that names the particle, not an intact one") {
  struct NoForce : LinearSpringCoulomb {
    bool broken = false;
    ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                            History& history) const {
      ContactForce force = LinearSpringCoulomb::operator()(geometry, motion, history);
      if (broken) force.normal = std::nan("");
      return force;
    }
  };
  const auto check = [](const auto& model) {
    Simulation sim{model, crushed, Rock{}};
    sim.step();
    sim.contact_law().broken = true;
    CHECK_THROWS_WITH_AS(sim.step(), doctest::Contains("particle 0: "), SimulationError);
  };
  const HoekBrown strong{.compressive_strength = 1e13};
  const auto model = Model{}.boundary(NoBoundary{}).contact_law(NoForce{}).criterion(strong);
  check(model);
  check(model.support(TwoPinnedContacts{}));
  check(model.integrator(VelocityVerlet{}));
  check(model.trigger(BrazilianStrength{1e15}).line_fit(LoadedDiameter{}));
}
