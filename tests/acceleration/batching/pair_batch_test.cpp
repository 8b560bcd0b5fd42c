// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/batching/pair_batch.hpp>

#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include <riprap/contact/narrow_phase/no_overlap.hpp>
#include <riprap/contact/pair/contact.hpp>

using namespace riprap;

namespace {

/// Finds the contacts of three pairs at once, but none of pairs that are marked.
struct ThreeAtOnce {
  struct Cache {
    bool joins = true;
    bool parted = false;
  };
  struct Batch {
    using Of = ThreeAtOnce;
    static constexpr std::size_t capacity = 3;
    std::vector<const Cache*> members;

    [[nodiscard]] std::size_t size() const { return members.size(); }
    void clear() { members.clear(); }
    [[nodiscard]] bool add(Ring, Ring, const Cache& cache, ContactGeometry&) {
      if (cache.joins) members.push_back(&cache);
      return cache.joins;
    }
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return {}; }
  [[nodiscard]] unsigned find(const Batch& batch) const {
    unsigned found = 0;
    for (std::size_t l = 0; l < batch.size(); ++l)
      if (!batch.members[l]->parted) found |= 1U << l;
    return found;
  }
};

struct NoHistory {};
using Pair = Contact<NoHistory, ThreeAtOnce::Cache>;

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

TEST_CASE("pairs are evaluated once a batch is full, those without a contact singly") {
  const Particles particles = two_triangles();
  std::vector<Pair> pairs(4, touching_pair());
  pairs[1].cache.parted = true;
  std::vector<std::size_t> single;
  const auto ask = [&](std::size_t k) { single.push_back(k); };
  PairBatch<ThreeAtOnce> batch;
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(single.empty());
    CHECK(batch.add(10 + k, pairs[k], particles));
    batch.find_if_full({}, ask);
  }
  CHECK(single == std::vector<std::size_t>{11});
  // The next one begins another batch, which is not filled.
  CHECK(batch.add(13, pairs[3], particles));
  batch.find_if_full({}, ask);
  batch.finish(ask);
  CHECK(single == std::vector<std::size_t>{11, 13});
  batch.finish(ask);
  CHECK(single.size() == 2);
}

TEST_CASE(
    "pairs that did not touch, images and pairs that the narrow phase refuses are in no batch") {
  const Particles particles = two_triangles();
  PairBatch<ThreeAtOnce> batch;
  Pair apart{.a = 0, .b = 1};
  Pair image = touching_pair();
  image.crosses_boundary = true;
  Pair refused = touching_pair();
  refused.cache.joins = false;
  CHECK(!batch.add(0, apart, particles));
  CHECK(!batch.add(0, image, particles));
  CHECK(!batch.add(0, refused, particles));
}

TEST_CASE("a narrow phase without batches evaluates pairs singly") {
  const Particles particles = two_triangles();
  Contact<NoHistory, NoOverlap::Cache> pair{.a = 0, .b = 1};
  pair.touching = true;
  PairBatch<NoOverlap> batch;
  CHECK(!batch.add(0, pair, particles));
}

namespace {

/// The same with pairs of two kinds.
struct TwoKinds : ThreeAtOnce {
  struct Batch : ThreeAtOnce::Batch {
    using Of = TwoKinds;
    static constexpr std::size_t kinds = 2;
    [[nodiscard]] static std::size_t kind(const Cache& cache) {
      if (!cache.joins) return 7;  // any number from `kinds` on
      return cache.parted ? 1 : 0;
    }
  };
  [[nodiscard]] unsigned find(const Batch& batch) const {
    for (const Cache* member : batch.members)
      CHECK(member->parted == batch.members.front()->parted);
    return ThreeAtOnce::find(batch);
  }
};
static_assert(BatchedNarrowPhase<TwoKinds>);

}  // namespace

TEST_CASE("pairs of each kind fill a batch of their own") {
  const Particles particles = two_triangles();
  std::vector<Pair> pairs(7, touching_pair());
  for (const std::size_t k : {1U, 3U, 5U}) pairs[k].cache.parted = true;
  pairs[6].cache.joins = false;
  std::vector<std::size_t> single;
  const auto ask = [&](std::size_t k) { single.push_back(k); };
  PairBatch<TwoKinds> batch;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    CHECK(batch.add(k, pairs[k], particles) == (k != 6));
    if (k == 6) continue;
    batch.find_if_full({}, ask);
    // The first kind is full with pair 4, the other one, without contacts, with pair 5.
    CHECK(single.size() == (k < 5 ? 0 : 3));
  }
  CHECK(single == std::vector<std::size_t>{1, 3, 5});
  batch.finish(ask);
  CHECK(single.size() == 3);
}
