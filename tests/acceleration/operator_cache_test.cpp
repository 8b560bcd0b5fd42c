// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/operator_cache.hpp>

#include <doctest/doctest.h>

#include <riprap/simulation/simulation.hpp>

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

}  // namespace

TEST_CASE("an operator is built once and forgotten with its particle") {
  const Particles particles = row_of_triangles(1);
  OperatorCache<StressModel<>> store(StressModel<>{}, Rock{});
  CHECK(store.bytes() == 0);
  const auto* exact = &store.exact(particles, 0);
  CHECK(store.bytes() == exact->bytes());
  const auto* compact = &store.single_precision(particles, 0);
  CHECK(store.bytes() == exact->bytes() + compact->bytes());
  CHECK(compact->bytes() < 0.7 * static_cast<double>(exact->bytes()));
  CHECK(&store.exact(particles, 0) == exact);
  CHECK(&store.single_precision(particles, 0) == compact);
  store.forget(0);
  CHECK(store.bytes() == 0);
}

TEST_CASE("what a compact operator was made from stays as long as a quarter of the budget does") {
  const Particles particles = row_of_triangles(3);
  OperatorCache<StressModel<>> store(StressModel<>{}, Rock{});
  store.begin_epoch(3);
  const std::size_t compact = store.single_precision(particles, 0).bytes();
  const std::size_t both = store.bytes();
  CHECK(both > 2 * compact);
  CHECK(store.bytes() == compact + store.exact(particles, 0).bytes());
  CHECK(store.bytes() == both);  // it was there
  // Room for one more, but not for one more after that.
  store.set_budget(4 * 2 * both);
  const std::size_t second = store.single_precision(particles, 1).bytes();
  CHECK(store.bytes() > both + 2 * second);
  const std::size_t before = store.bytes();
  const std::size_t third = store.single_precision(particles, 2).bytes();
  CHECK(store.bytes() == before + third);
}

TEST_CASE("operators that were not asked for longest make room, exact ones before compact ones") {
  const Particles particles = row_of_triangles(9);
  OperatorCache<StressModel<>> store(StressModel<>{}, Rock{});
  store.set_budget(1);  // no room for what compact ones are made from
  store.begin_epoch(9);
  for (BodyIndex i = 0; i < 8; ++i) (void)store.single_precision(particles, i);
  store.set_budget(OperatorCache<StressModel<>>::default_budget);
  const std::size_t all_compact = store.bytes();
  (void)store.exact(particles, 0);
  store.begin_epoch(9);
  for (BodyIndex i = 0; i < 4; ++i) (void)store.single_precision(particles, i);
  // An exact operator is larger than an eighth of the whole: it has to go, and one more.
  store.set_budget(store.bytes());
  const std::size_t fresh = store.single_precision(particles, 8).bytes();
  store.evict();
  CHECK(store.bytes() <= store.budget() - store.budget() / 8);
  CHECK(store.bytes() < all_compact + fresh);
  // Those asked for in this turn are still there, the first of the others is not.
  const std::size_t before = store.bytes();
  for (const BodyIndex i : {0u, 1u, 2u, 3u, 8u}) (void)store.single_precision(particles, i);
  CHECK(store.bytes() == before);
  store.set_budget(2 * store.budget());
  (void)store.single_precision(particles, 4);
  CHECK(store.bytes() > before);
}

TEST_CASE("an operator that was dropped comes back with the same bytes") {
  const Particles particles = row_of_triangles(2);
  OperatorCache<StressModel<>> store(StressModel<>{}, Rock{});
  const Eigen::MatrixXd before = store.exact(particles, 0).columns();
  store.set_budget(1);
  (void)store.exact(particles, 1);
  CHECK(store.bytes() < 1.5 * static_cast<double>(store.exact(particles, 1).bytes()));
  CHECK(store.exact(particles, 0).columns() == before);
}
