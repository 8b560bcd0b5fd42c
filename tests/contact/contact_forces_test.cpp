// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_forces.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <span>
#include <vector>

#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near;
using test::near_relative;
using test::rectangle;

namespace {

struct NoCache {};
template <class Image>
using Pair = Contact<LinearSpringCoulomb::History, NoCache, Image>;

}  // namespace

TEST_CASE("the effective mass of two free bodies is their product over their sum") {
  Particles particles(1, 1000);
  particles.add(rectangle({0, 0}, 2, 1), Motion::free);        // 2000 kg
  particles.add(rectangle({0, 1}, 1, 1), Motion::free);        // 1000 kg
  particles.add(rectangle({0, 2}, 1, 1), Motion::prescribed);  // as if infinite
  CHECK(effective_mass(particles.body(0), particles.body(1)) == near_relative(2000.0 / 3, 1e-12));
  CHECK(effective_mass(particles.body(0), particles.body(2)) == near_relative(2000, 1e-12));
  CHECK(effective_mass(particles.body(2), particles.body(1)) == near_relative(1000, 1e-12));
}

TEST_CASE("a task adds forces to its own bodies only; of any body they are summed pair by pair") {
  Particles particles(1, 1000);
  particles.add(rectangle({0, 0}, 1, 1), Motion::free);
  particles.add(rectangle({0.99, 0.2}, 1, 1), Motion::free);
  std::vector<Pair<UnboundedDomain::Image>> pairs{{.a = 0, .b = 1}};
  pairs[0].touching = true;
  pairs[0].geometry = {
      .normal = {1, 0}, .point = {0.495, 0.1}, .depth = 0.01, .area = 0.008, .chord = 0.8};
  const LinearSpringCoulomb law{.normal_stiffness = 1e6};
  ContactLosses losses;
  ContactTask task{.first_body = 0, .last_body = 1, .last_pair = 1, .touching = {0}};
  find_forces(task, std::span(pairs), particles, law, UnboundedDomain{}, 0, task.last_body, losses);
  CHECK(task.largest_overlap == 0.008);
  CHECK(particles.body(0).contact.force.x() == near_relative(-1e4, 1e-12));
  CHECK(particles.body(0).contact.moment == near_relative(1e3, 1e-12));  // 0.1 m above the centroid
  CHECK(particles.body(1).contact.force.norm() == 0);
  PairIndex index;
  index.build(pairs, 2);
  const auto sum = [&](BodyIndex i) {
    return sum_forces(index.of(i), std::span<const Pair<UnboundedDomain::Image>>(pairs));
  };
  CHECK(sum(1).force.x() == near_relative(1e4, 1e-12));
  CHECK(sum(1).moment == near_relative(1e3, 1e-9));  // 0.1 m below the centroid
  CHECK(sum(0).force == particles.body(0).contact.force);
  CHECK(sum(0).moment == particles.body(0).contact.moment);
  // Tasks that run in order add to bodies of later ones, too.
  for (Body& body : particles.bodies()) body.contact = {};
  find_forces(task, std::span(pairs), particles, law, UnboundedDomain{}, 0, 2, losses);
  for (BodyIndex i = 0; i < 2; ++i) {
    CHECK(particles.body(i).contact.force == sum(i).force);
    CHECK(particles.body(i).contact.moment == sum(i).moment);
  }
  pairs[0].touching = false;
  CHECK(sum(1).force.norm() == 0);
}

TEST_CASE("arms and velocities of an image are those of the body, moved by the period") {
  Particles particles(1, 1000);
  particles.add(rectangle({0, 0}, 1, 1), Motion::free);
  particles.add(rectangle({9.01, 0}, 1, 1), Motion::free);
  particles.body(1).velocity = {2, 0};
  const PeriodicDomain domain{.period = {10, 10}, .rate = {0.1, 0}};
  Pair<PeriodicDomain::Image> pair{
      .a = 0, .b = 1, .image = {-1, 0}, .touching = true, .crosses_boundary = true};
  pair.geometry.point = {-0.495, 0};
  find_arms(pair, particles.body(0), particles.body(1), domain);
  CHECK(pair.arm_a.x() == near(-0.495, 1e-12));
  CHECK(pair.arm_b.x() == near(0.495, 1e-12));
  // The image recedes at the rate of the cell times its offset of -10 m.
  CHECK(relative_velocity(pair, particles, domain).x() == near(2 + 1, 1e-12));
}
