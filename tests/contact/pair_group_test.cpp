// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair_group.hpp>

#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include <riprap/contact/contact.hpp>
#include <riprap/contact/narrow_phase/no_overlap.hpp>

using namespace riprap;

namespace {

/// Finds the contacts of three pairs at once, but none of pairs that are marked.
struct ThreeAtOnce {
  struct Memory {
    bool joins = true;
    bool parted = false;
  };
  struct Group {
    using Of = ThreeAtOnce;
    static constexpr std::size_t capacity = 3;
    std::vector<const Memory*> members;

    [[nodiscard]] std::size_t size() const { return members.size(); }
    void clear() { members.clear(); }
    [[nodiscard]] bool add(Ring, Ring, const Memory& memory, ContactGeometry&) {
      if (memory.joins) members.push_back(&memory);
      return memory.joins;
    }
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return {}; }
  [[nodiscard]] unsigned find(const Group& group) const {
    unsigned found = 0;
    for (std::size_t l = 0; l < group.size(); ++l)
      if (!group.members[l]->parted) found |= 1U << l;
    return found;
  }
};

struct NoHistory {};
using Pair = Contact<NoHistory, ThreeAtOnce::Memory>;

Particles two_triangles() {
  Particles particles(1, 1);
  for (const double x : {0.0, 2.0})
    particles.add(ConvexPolygon{{x, 0}, {x + 1, 0}, {x, 1}}, Motion::free);
  return particles;
}

Pair touching_pair() {
  Pair pair{.a = 0, .b = 1};
  pair.touching = true;
  return pair;
}

}  // namespace

TEST_CASE("pairs wait until they are enough, and those without a contact are asked alone") {
  const Particles particles = two_triangles();
  std::vector<Pair> pairs(4, touching_pair());
  pairs[1].memory.parted = true;
  std::vector<std::size_t> alone;
  const auto ask = [&](std::size_t k) { alone.push_back(k); };
  PairGroup<ThreeAtOnce> group;
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(alone.empty());
    CHECK(group.add(10 + k, pairs[k], particles));
    group.find_if_full({}, ask);
  }
  CHECK(alone == std::vector<std::size_t>{11});
  // The next one begins another group, which is not filled.
  CHECK(group.add(13, pairs[3], particles));
  group.find_if_full({}, ask);
  group.finish(ask);
  CHECK(alone == std::vector<std::size_t>{11, 13});
  group.finish(ask);
  CHECK(alone.size() == 2);
}

TEST_CASE("pairs that did not touch, images and those that the narrow phase refuses do not wait") {
  const Particles particles = two_triangles();
  PairGroup<ThreeAtOnce> group;
  Pair apart{.a = 0, .b = 1};
  Pair image = touching_pair();
  image.across = true;
  Pair refused = touching_pair();
  refused.memory.joins = false;
  CHECK(!group.add(0, apart, particles));
  CHECK(!group.add(0, image, particles));
  CHECK(!group.add(0, refused, particles));
}

TEST_CASE("nobody waits for a narrow phase that finds no groups") {
  const Particles particles = two_triangles();
  Contact<NoHistory, NoOverlap::Memory> pair{.a = 0, .b = 1};
  pair.touching = true;
  PairGroup<NoOverlap> group;
  CHECK(!group.add(0, pair, particles));
}
