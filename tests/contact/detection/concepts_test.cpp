// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/detection/concepts.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/detection/evaluate_each_pair.hpp>

using namespace riprap;

namespace {

struct WithoutCarry {
  template <class Narrow>
  struct State {
    void forget(std::size_t) {}
    void forget_all() {}
    template <class Input>
    void find(const Input&, ContactTask&) {}
  };
};

}  // namespace

TEST_CASE("a detection follows the list and evaluates the pairs of a task") {
  CHECK(Detection<EvaluateEachPair>);
  CHECK_FALSE(Detection<WithoutCarry>);
  CHECK_FALSE(Detection<int>);
}
