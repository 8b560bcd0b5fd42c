// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <optional>
#include <support/violated.hpp>

#include <riprap/conformance/simulation.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <riprap/dynamics/damping/viscous_damping.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

using namespace riprap;
using test::check_violated;

namespace {

// The default law and criterion in millimetres, grams and milliseconds: megapascals.
constexpr EnergyConservingSpring springs{.normal_stiffness = 2e4, .tangential_stiffness = 2e4};
constexpr HoekBrown rock_strength{.compressive_strength = 300};

auto model() { return Model{}; }
auto model_in_other_units() { return Model{}.contact_law(springs).criterion(rock_strength); }

/// Cuts at a given distance to the left of the line.
struct CutsBeside {
  double width = 1e-4;  // [m]
  std::optional<CutRings> operator()(Ring ring, Line line, double mean_area) const {
    line.point += width * perpendicular(line.direction);
    return StraightCut{}(ring, line, mean_area);
  }
  void validate() const {}
};

struct Twist {
  double spin = 1;  // [rad/s]
  void operator()(const Body& parent, Body& piece) const {
    RigidField{}(parent, piece);
    piece.angular_velocity += spin;
  }
};

}  // namespace

TEST_CASE("the default simulation breaks a particle, and is the same in other units") {
  Simulation sim{model(), internal::pressed_particle({1, 1, 1}), Rock{}};
  for (int i = 0; i < 30; ++i) sim.step();
  CHECK(!sim.breaks().empty());
  CHECK(to_text(simulation_unit_violations(model(), model_in_other_units())) == "");
}

TEST_CASE("other models of riprap give the same simulation in other units") {
  const auto other = [](const auto& m) {
    return m.integrator(VelocityVerlet{}).support(TwoPinnedContacts{});
  };
  const SpringDashpot dashpot;
  const SpringDashpot same{.normal_stiffness = 2e4, .tangential_stiffness = 2e4};
  CHECK(
      to_text(simulation_unit_violations(
          other(model()).contact_law(dashpot).damping(ViscousDamping{}),
          other(model_in_other_units()).contact_law(same).damping(ViscousDamping{.rate = 0.1}))) ==
      "");
}

TEST_CASE("a user's model gives the same simulation in other units") {
  CHECK(to_text(simulation_unit_violations(
            model().splitter(CutsBeside{}).inheritance(Twist{}),
            model_in_other_units().splitter(CutsBeside{.width = 0.1}).inheritance(Twist{1e-3}))) ==
        "");
}

TEST_CASE("a model with a number of its own is reported") {
  check_violated(simulation_unit_violations(
                     model(), model_in_other_units().contact_law(EnergyConservingSpring{})),
                 "time is the same in other units");
  check_violated(simulation_unit_violations(model(), model_in_other_units().criterion(HoekBrown{})),
                 "as many particles break in other units");
  check_violated(simulation_unit_violations(model().splitter(CutsBeside{}),
                                            model_in_other_units().splitter(CutsBeside{})),
                 "bodies go the same way in other units: distance");
  check_violated(simulation_unit_violations(model().damping(ViscousDamping{}),
                                            model_in_other_units().damping(ViscousDamping{})),
                 "bodies are as fast in other units: difference");
  check_violated(simulation_unit_violations(model().inheritance(Twist{}),
                                            model_in_other_units().inheritance(Twist{})),
                 "bodies spin as fast in other units");
}
