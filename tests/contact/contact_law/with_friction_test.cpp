// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/with_friction.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/incremental_spring.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/no_contact_force.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

const ContactGeometry geometry{.depth = 1e-4, .area = 1e-7, .chord = 1e-2};
// Fast enough to slip under any friction here.
const ContactMotion motion{.tangential_velocity = -1, .time_step = 1e-3, .effective_mass = 0.01};

// A law that has its friction in another way than by a member of that name.
struct Rough : NoContactForce {
  double roughness = 3;
  [[nodiscard]] Rough with_friction(double mu) const {
    Rough other = *this;
    other.roughness = 2 * mu;
    return other;
  }
};

}  // namespace

TEST_CASE_TEMPLATE("a law with another friction slips at that share of the same normal force", Law,
                   LinearSpringCoulomb, EnergyConservingSpring, IncrementalSpring, SpringDashpot,
                   OverlapAreaSpring) {
  const Law law;
  for (const double mu : {0.0, 0.2, 0.9}) {
    typename Law::History history;
    typename Law::History other;
    const ContactForce force = with_friction(law, mu)(geometry, motion, history);
    CHECK(force.normal == law(geometry, motion, other).normal);
    CHECK(force.tangential == near_relative(mu * force.normal, 1e-14));
  }
  CHECK(law.friction == Law{}.friction);
}

TEST_CASE("a law's own way to another friction comes first; laws without friction have none") {
  CHECK(with_friction(Rough{}, 0.4).roughness == 0.8);
  CHECK_FALSE(FrictionalLaw<NoContactForce>);
  CHECK_THROWS_WITH_AS((void)with_friction(LinearSpringCoulomb{}, -0.1),
                       "with_friction: friction = -0.1: must be a finite number, 0 or above",
                       InvalidInput);
  CHECK_THROWS_AS((void)with_friction(Rough{}, std::nan("")), InvalidInput);
}

TEST_CASE("a law chosen at run time passes its friction on") {
  using Choice = ContactLawChoice<LinearSpringCoulomb, NoContactForce>;
  const Choice rough = with_friction(Choice{LinearSpringCoulomb{}}, 0.3);
  CHECK(std::get<LinearSpringCoulomb>(rough.chosen).friction == 0.3);
  CHECK_NOTHROW((void)with_friction(Choice{NoContactForce{}}, 0));
  CHECK_THROWS_WITH_AS((void)with_friction(Choice{NoContactForce{}}, 0.3),
                       "with_friction: friction = 0.3: must be 0 for a law without friction",
                       InvalidInput);
}
