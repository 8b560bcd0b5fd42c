// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/operator_store/concepts.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/operator_store/keep_all_operators.hpp>

using namespace riprap;

namespace {

struct WithoutFind {
  struct State : KeepAllOperators::State {
    explicit State(const WithoutFind&) {}
    void find(BodyIndex) const {}
  };
};

}  // namespace

TEST_CASE("a store gives operators and says which ones it has") {
  CHECK(OperatorStore<KeepAllOperators>);
  CHECK_FALSE(OperatorStore<WithoutFind>);
  CHECK_FALSE(OperatorStore<int>);
}
