// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/frictionless.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/no_contact_force.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>

using namespace riprap;

namespace {

// A law that loses its friction in another way than by a member of that name.
struct Rough : NoContactForce {
  double roughness = 3;
  double friction = 0.5;
  [[nodiscard]] Rough frictionless() const {
    Rough smooth = *this;
    smooth.roughness = 0;
    return smooth;
  }
};

template <class Law>
void check_force(Law law) {
  law.friction = 0.7;
  const ContactGeometry geometry{.depth = 1e-4, .area = 1e-7, .chord = 1e-2};
  const ContactMotion motion{.tangential_velocity = -1, .time_step = 1e-3, .effective_mass = 0.01};
  typename Law::History history;
  typename Law::History other;
  const ContactForce rough = law(geometry, motion, history);
  const ContactForce smooth = frictionless(law)(geometry, motion, other);
  CHECK(smooth.normal == rough.normal);
  CHECK(smooth.tangential == 0);
  CHECK(smooth.friction_loss == 0);
  CHECK(rough.tangential != 0);
  CHECK(law.friction == 0.7);
}

}  // namespace

TEST_CASE("a law without its friction pushes as before and never pulls sideways") {
  check_force(LinearSpringCoulomb{});
  check_force(SpringDashpot{});
  check_force(OverlapAreaSpring{});
}

TEST_CASE("a law's own way to lose its friction comes first") {
  const Rough smooth = frictionless(Rough{});
  CHECK(smooth.roughness == 0);
  CHECK(smooth.friction == 0.5);
}

TEST_CASE("a law without friction stays as it is") {
  CHECK(frictionless(NoContactForce{}).peak_stiffness() == NoContactForce{}.peak_stiffness());
}
