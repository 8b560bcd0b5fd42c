// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/operator_cache.hpp>

#include <doctest/doctest.h>

#include <riprap/simulation/model_parts.hpp>
#include <riprap/stress/particle_stress.hpp>

using namespace riprap;

namespace {

Particles row_of_triangles(int count) {
  Particles particles(0.016, 2500);
  for (int i = 0; i < count; ++i) {
    const double x = 0.02 * i;
    particles.add(ConvexPolygon{{x, 0.0}, {x + 0.01, 0.0}, {x, 0.01 + 0.001 * i}}, Motion::free);
  }
  return particles;
}

auto builder(const Particles& particles, BodyIndex i) {
  return [&particles, i] { return build_operator(StressModel<>{}, Rock{}, particles, i); };
}

}  // namespace

TEST_CASE("an operator is built once and discarded with its particle") {
  const Particles particles = row_of_triangles(1);
  OperatorCache::State store;
  CHECK(store.bytes() == 0);
  const auto* exact = &store.exact(0, builder(particles, 0));
  CHECK(store.bytes() == exact->bytes());
  const auto* compact = &store.single_precision(0, builder(particles, 0));
  CHECK(store.bytes() == exact->bytes() + compact->bytes());
  CHECK(compact->bytes() < 0.7 * static_cast<double>(exact->bytes()));
  CHECK(&store.exact(0, builder(particles, 0)) == exact);
  CHECK(&store.single_precision(0, builder(particles, 0)) == compact);
  CHECK(store.find(0) == exact);
  store.forget(0);
  CHECK(store.find(0) == nullptr);
  CHECK(store.bytes() == 0);
}

TEST_CASE("what a compact operator was made from stays as long as a quarter of the budget does") {
  const Particles particles = row_of_triangles(3);
  OperatorCache::State store;
  store.begin_epoch(3);
  const std::size_t compact = store.single_precision(0, builder(particles, 0)).bytes();
  const std::size_t both = store.bytes();
  CHECK(both > 2 * compact);
  CHECK(store.bytes() == compact + store.exact(0, builder(particles, 0)).bytes());
  CHECK(store.bytes() == both);  // it was there
  // Room for one more, but not for one more after that.
  store.set_budget(4 * 2 * both);
  const std::size_t second = store.single_precision(1, builder(particles, 1)).bytes();
  CHECK(store.bytes() > both + 2 * second);
  const std::size_t before = store.bytes();
  const std::size_t third = store.single_precision(2, builder(particles, 2)).bytes();
  CHECK(store.bytes() == before + third);
}

TEST_CASE(
    "the least recently used operators are evicted, exact ones before those in single precision") {
  const Particles particles = row_of_triangles(9);
  OperatorCache::State store;
  store.set_budget(1);  // no room for what compact ones are made from
  store.begin_epoch(9);
  for (BodyIndex i = 0; i < 8; ++i) (void)store.single_precision(i, builder(particles, i));
  store.set_budget(OperatorCache::default_budget);
  const std::size_t all_compact = store.bytes();
  (void)store.exact(0, builder(particles, 0));
  store.begin_epoch(9);
  for (BodyIndex i = 0; i < 4; ++i) (void)store.single_precision(i, builder(particles, i));
  // An exact operator is larger than an eighth of the whole: it has to go, and one more.
  store.set_budget(store.bytes());
  const std::size_t fresh = store.single_precision(8, builder(particles, 8)).bytes();
  store.evict();
  CHECK(store.bytes() <= store.budget() - store.budget() / 8);
  CHECK(store.bytes() < all_compact + fresh);
  // Those used in this epoch are in memory, the first of the others is not.
  const std::size_t before = store.bytes();
  for (const BodyIndex i : {0u, 1u, 2u, 3u, 8u})
    (void)store.single_precision(i, builder(particles, i));
  CHECK(store.bytes() == before);
  store.set_budget(2 * store.budget());
  (void)store.single_precision(4, builder(particles, 4));
  CHECK(store.bytes() > before);
}

TEST_CASE("an operator that was dropped comes back with the same bytes") {
  const Particles particles = row_of_triangles(2);
  OperatorCache::State store;
  const Eigen::MatrixXd before = store.exact(0, builder(particles, 0)).columns();
  store.set_budget(1);
  (void)store.exact(1, builder(particles, 1));
  CHECK(store.bytes() < 1.5 * static_cast<double>(store.exact(1, builder(particles, 1)).bytes()));
  CHECK(store.exact(0, builder(particles, 0)).columns() == before);
}
