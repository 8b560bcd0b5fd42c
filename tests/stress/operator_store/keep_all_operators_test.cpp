// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/operator_store/keep_all_operators.hpp>

#include <doctest/doctest.h>

#include <riprap/simulation/model_parts.hpp>
#include <riprap/stress/particle_stress.hpp>

using namespace riprap;

TEST_CASE("an operator is built once and kept until its particle breaks") {
  Particles particles(0.016, 2500);
  particles.add(ConvexPolygon{{0, 0}, {0.01, 0}, {0, 0.01}}, Motion::free);
  particles.add(ConvexPolygon{{0.02, 0}, {0.03, 0}, {0.02, 0.01}}, Motion::free);
  int built = 0;
  const auto build = [&] {
    ++built;
    return build_operator(StressModel<>{}, Rock{}, particles, 1);
  };
  KeepAllOperators::State store;
  CHECK(store.find(1) == nullptr);
  CHECK(store.bytes() == 0);
  const InfluenceOperator& op = store.exact(1, build);
  CHECK(&store.exact(1, build) == &op);
  CHECK(store.find(1) == &op);
  CHECK(store.find(0) == nullptr);
  CHECK(built == 1);
  CHECK(store.bytes() == op.bytes());
  store.forget(1);
  store.forget(7);
  CHECK(store.find(1) == nullptr);
}
