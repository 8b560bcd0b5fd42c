// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/tracked_bounds.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <support/listed_contacts.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Particles whose bounds do not hold; their bounds start again, with weights that use up the budget
// when a force changes by 1 N.
std::vector<BodyIndex> candidates(TrackedBounds& bounds, const Particles& particles,
                                  const Touches& contacts) {
  std::vector<BodyIndex> found;
  ContactLoads loads;
  loads.begin(contacts, particles.size());
  bounds.begin(contacts, particles.size());
  bounds.check(particles, contacts, 0, 0, particles.size(), [&](BodyIndex i) {
    found.push_back(i);
    loads.gather(contacts, i);
    std::vector<LoadSensitivity> weights;
    const Rotation& rotation = particles.body(i).rotation;
    for (const ContactLoad& load : loads.of(i))
      weights.emplace_back(LoadSensitivity::single(rotation.inverse_times(load.arm_lab),
                                                   rotation.inverse_times(load.force_lab)),
                           FourFloats{1, 1, 1, 1});
    bounds.track(i, loads.of(i), loads.sides(i), weights);
  });
  return found;
}

}  // namespace

TEST_CASE("a bound no longer holds if contacts begin, end or change much, or pairs are unknown") {
  using Left = std::vector<BodyIndex>;
  const Particles particles = four_triangles();
  TrackedBounds bounds;
  const auto touch = [](BodyIndex a, BodyIndex b) {
    return Touch{.a = a,
                 .b = b,
                 .arm_a = {1e-3 * b, -3.3e-3},
                 .arm_b = {-3.3e-3, 1e-3 * a},
                 .on_b = {100, 50.0 * b}};
  };
  Touches contacts;
  constexpr std::uint32_t fresh = PairMap::not_present;
  contacts.replace({touch(0, 1), touch(0, 2), touch(0, 3)}, {fresh, fresh, fresh});
  Touch& last = contacts.list[2];
  last.touching = false;
  const auto left = [&] { return candidates(bounds, particles, contacts); };

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
  contacts.list[0].touching = false;
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  contacts.list[1].on_b *= 1 + 1e-9;
  CHECK(left() == Left{});
  // Revisions that were not followed one by one.
  contacts.replace(contacts.list, {0, 1, 2});
  contacts.replace(contacts.list, {0, 1, 2});
  CHECK(left() == Left{0, 1, 2, 3});
  CHECK(left() == Left{});
  // Pairs that are known from before keep what is known of them.
  contacts.replace({contacts.list[1], contacts.list[2]}, {1, 2});
  CHECK(left() == Left{});
  contacts.replace({contacts.list[0], touch(1, 3)}, {0, fresh});
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  contacts.replace({touch(0, 1), touch(0, 2)}, {fresh, 0});
  CHECK(left() == Left{0, 1, 3});
  CHECK(left() == Left{});
  bounds.untrack(3);
  CHECK(left() == Left{3});
  contacts.list[1].on_b *= 100;
  CHECK(left() == Left{0, 2});
}
