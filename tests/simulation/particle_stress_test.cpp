// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <span>
#include <vector>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

struct Touch {
  BodyIndex a;
  BodyIndex b;
  Vec2 arm_a{0, 0};
  Vec2 arm_b{0, 0};
  ContactForce force{};
  bool touching = true;
  Vec2 on_b{0, 0};
  Vec2 force_on_b() const { return on_b; }
};
struct Touches {
  std::vector<Touch> list;
  std::uint64_t number;
  std::uint64_t earlier_number = 1000;
  std::vector<std::uint32_t> earlier{};
  static constexpr std::uint32_t not_present = 1000;
  std::span<const Touch> pairs() const { return list; }
  std::uint64_t revision() const { return number; }
  std::uint64_t previous_revision() const { return earlier_number; }
  std::uint32_t previous_index(std::size_t k) const { return earlier[k]; }
  template <class Visit>
  void for_each_touching_of(std::size_t, Visit&& visit) const {
    for (std::size_t k = 0; k < list.size(); ++k)
      if (list[k].touching) visit(list[k], k);
  }
};

Particles four_triangles() {
  Particles particles(0.016, 2500);
  for (int i = 0; i < 4; ++i) {
    const double x = 0.02 * i;
    particles.add(ConvexPolygon{{x, 0.0}, {x + 0.01, 0.0}, {x, 0.01}}, Motion::free);
  }
  return particles;
}

// Candidates of the incremental bounds, which are then compared, or evaluated if need be, as under
// a load that breaks no particle.
std::vector<BodyIndex> left_by_watch(ParticleStress<StressModel<>>& stress,
                                     const Particles& particles, const Touches& contacts) {
  StressWorkspace work{FailureScreening(MohrRadiusTable::of(HoekBrown{}))};
  std::vector<BodyIndex> left;
  stress.begin_gather(particles, contacts);
  stress.check_incremental_bounds(particles, contacts, 0, 0, particles.size(), [&](BodyIndex i) {
    left.push_back(i);
    stress.gather(contacts, i);
    if (stress.contact_count(i) == 0)
      stress.track_without_contacts(i);
    else if (!stress.bound_excludes_failure(particles, i))
      CHECK_FALSE(stress.screen(
          particles, i, 1, [](std::size_t elements) { return elements; }, work));
  });
  return left;
}

}  // namespace

TEST_CASE("the mean stress of a particle under gathered contacts is that of its forces") {
  Simulation sim{Model{}.boundary(NoBoundary{}), test::square_between_platens(0.2), Rock{}};
  sim.set_breakage(false);
  for (int i = 0; i < 1500; ++i) sim.step();
  // A point in time at which the square also turns and shifts in its own frame is not needed: the
  // platens load it symmetrically, s22 of the mean is the force over width and thickness.
  double force = 0;
  sim.contacts().for_each_touching([&](const auto& c) { force += 0.5 * c.force.normal; });
  REQUIRE(force > 100);
  const ElementStress stress = sim.element_stress(0);
  const Mesh& mesh = sim.mesh(0);
  double mean = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) mean += mesh.area(e) * stress[e].s22;
  mean /= 0.016 * 0.016;
  // The forces act at the boundary; their places differ from it by half the overlap at most, which
  // the projection onto the boundary takes away. What is left is the imbalance of the two forces.
  CHECK(mean == near_relative(force / (0.016 * 0.016), 1e-6));
}

TEST_CASE("every particle has its own contacts and no others, across tasks too") {
  Simulation sim{Model{}, random_assembly({.count = 600, .seed = 3}), Rock{}};
  sim.set_breakage(false);
  sim.boundary().set_rate(10, 10);
  for (int i = 0; i < 4000; ++i) sim.step();
  std::vector<std::vector<BodyIndex>> partners(sim.particles().size());
  sim.contacts().for_each_touching([&](const auto& c) {
    partners[c.a].push_back(c.b);
    partners[c.b].push_back(c.a);
  });
  ParticleStress<StressModel<>> stress(StressModel<>{}, Rock{});
  stress.gather(sim.particles(), sim.contacts());
  std::size_t across = 0;
  for (BodyIndex i = 0; i < partners.size(); ++i) {
    CHECK(stress.contact_count(i) == partners[i].size());
    std::uint64_t sum = 0;
    for (const BodyIndex j : partners[i]) {
      sum += splitmix64(sim.particles().ancestry(j).id);
      across += task_of(i) != task_of(j);
    }
    CHECK(stress.partners(sim.particles(), i) == sum);
  }
  CHECK(across > 20);
}

TEST_CASE("partners are distinguished by their ids, not by their number") {
  const Particles particles = four_triangles();
  ParticleStress<StressModel<>> stress(StressModel<>{}, Rock{});
  stress.gather(particles, Touches{.list = {{0, 1}, {0, 2}}, .number = 1});
  const std::uint64_t first = stress.partners(particles, 0);
  CHECK(stress.contact_count(0) == 2);
  CHECK(stress.contact_count(3) == 0);
  stress.gather(particles, Touches{.list = {{0, 2}, {0, 1}}, .number = 2});
  CHECK(stress.partners(particles, 0) == first);
  stress.gather(particles, Touches{.list = {{0, 1}, {0, 3}}, .number = 3});
  CHECK(stress.partners(particles, 0) != first);
}

TEST_CASE("the watch leaves those whose contacts come, go, change much or are numbered anew") {
  using Left = std::vector<BodyIndex>;
  const Particles particles = four_triangles();
  ParticleStress<StressModel<>> stress(StressModel<>{}, Rock{});
  const auto touch = [](BodyIndex a, BodyIndex b) {
    return Touch{.a = a,
                 .b = b,
                 .arm_a = {1e-3 * b, -3.3e-3},
                 .arm_b = {-3.3e-3, 1e-3 * a},
                 .on_b = {100, 50.0 * b}};
  };
  Touches contacts{.list = {touch(0, 1), touch(0, 2), touch(0, 3)}, .number = 7};
  Touch& first = contacts.list[0];
  Touch& last = contacts.list[2];
  last.touching = false;
  const auto left = [&] { return left_by_watch(stress, particles, contacts); };

  CHECK(left() == Left{0, 1, 2, 3});
  CHECK(left() == Left{});
  last.touching = true;
  CHECK(left() == Left{0, 3});
  CHECK(left() == Left{});
  last.touching = false;
  CHECK(left() == Left{0, 3});
  CHECK(left() == Left{});
  // As many as before, each under a load that was known once.
  last.touching = true;
  first.touching = false;
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  contacts.list[1].on_b *= 1 + 1e-9;
  CHECK(left() == Left{});
  contacts.number = 8;
  CHECK(left() == Left{0, 1, 2, 3});
  CHECK(left() == Left{});
  // Pairs that are known from before keep what is known of them.
  contacts = {.list = {contacts.list[1], contacts.list[2]},
              .number = 9,
              .earlier_number = 8,
              .earlier = {1, 2}};
  CHECK(left() == Left{});
  contacts = {.list = {contacts.list[0], touch(1, 3)},
              .number = 10,
              .earlier_number = 9,
              .earlier = {0, Touches::not_present}};
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  contacts = {.list = {touch(0, 1), touch(0, 2)},
              .number = 11,
              .earlier_number = 10,
              .earlier = {Touches::not_present, 0}};
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  stress.forget(3);
  CHECK(left() == Left{3});
  contacts.list[1].on_b *= 100;
  CHECK(left() == Left{0, 2});
}
