// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A list of pairs and contacts that a test writes down, and particles for it.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/concepts.hpp>
#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap::test {

struct Touch {
  BodyIndex a;
  BodyIndex b;
  Vec2 arm_a{0, 0};
  Vec2 arm_b{0, 0};
  ContactForce force{};
  bool touching = true;
  Vec2 on_b{0, 0};
  [[nodiscard]] Vec2 force_on_b() const { return on_b; }
};

/// A list of pairs, made by hand.
struct Touches {
  std::vector<Touch> list;
  PairMap pair_map{};
  mutable PairIndex pair_index{};

  [[nodiscard]] std::span<const Touch> pairs() const { return list; }
  [[nodiscard]] const PairMap& map() const { return pair_map; }
  [[nodiscard]] const PairIndex& index() const {
    BodyIndex bodies = 0;
    for (const Touch& touch : list) bodies = std::max(bodies, touch.b + 1);
    pair_index.build(list, std::max<std::size_t>(bodies, 16));
    return pair_index;
  }
  template <class Visit>
  void for_each_touching_of(std::size_t, Visit&& visit) const {
    for (std::size_t k = 0; k < list.size(); ++k)
      if (list[k].touching) visit(list[k], k);
  }
  /// Another list under a new revision; `previous` are the indices of its pairs in this one.
  void replace(std::vector<Touch> by, const std::vector<std::uint32_t>& previous) {
    list = std::move(by);
    pair_map.begin();
    for (const std::uint32_t index : previous) pair_map.add(index);
    pair_map.finish(pair_map.to() + 1);
  }
};
static_assert(ListedContacts<Touches>);

[[nodiscard]] inline Particles four_triangles() {
  Particles particles(0.016, 2500);
  for (int i = 0; i < 4; ++i) {
    const double x = 0.02 * i;
    particles.add(ConvexPolygon{{x, 0.0}, {x + 0.01, 0.0}, {x, 0.01}}, Motion::free);
  }
  return particles;
}

}  // namespace riprap::test
