// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/neighbour_list/concepts.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>

using namespace riprap;

namespace {

struct WithoutSkin : RebuildEveryStep {
 private:
  static constexpr bool uses_skin = true;
};
struct WithoutBound {
  static constexpr bool uses_skin = true;
  template <class Domain>
  struct State : RebuildEveryStep::State<Domain> {
    void displacement() const {}
  };
};

}  // namespace

TEST_CASE("a neighbour list says whether it uses a skin, and bounds the approach of bodies") {
  CHECK(NeighbourList<RebuildEveryStep>);
  CHECK_FALSE(NeighbourList<WithoutSkin>);
  CHECK_FALSE(NeighbourList<WithoutBound>);
  CHECK_FALSE(NeighbourList<int>);
}
