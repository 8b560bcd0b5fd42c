// SPDX-License-Identifier: BSL-1.0
#include <riprap/conformance/acceleration.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/contact/detection/evaluate_each_pair.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/stress/operator_store/keep_all_operators.hpp>
#include <support/violated.hpp>

using namespace riprap;
using test::check_violated;

namespace {

// Searches at the start only, however far bodies have moved.
struct SearchAtTheStart {
  static constexpr bool uses_skin = true;
  template <class Domain>
  struct State : RebuildEveryStep::State<Domain> {
    int calls = 0;
    template <class E>
    bool is_stale(const Particles&, const Domain&, const E&) {
      return calls++ == 0;
    }
    void invalidate() { calls = 0; }
  };
};

// Leaves out all particles but the first five.
struct FirstFive {
  template <class BreakagePart, class StressPart>
  struct State : EvaluateAll::State<BreakagePart, StressPart> {
    using Base = EvaluateAll::State<BreakagePart, StressPart>;
    using Base::Base;
    template <class Input, class IsLoaded, class OnPhaseEnd>
    void find_candidates(const Input& input, ContactLoads& loads, IsLoaded&& is_loaded,
                         std::vector<BodyIndex>& candidates, OnPhaseEnd&& end) const {
      Base::find_candidates(input, loads, is_loaded, candidates, end);
      std::erase_if(candidates, [](BodyIndex i) { return i > 4; });
    }
  };
};

}  // namespace

TEST_CASE("no result depends on what only accelerates") {
  CHECK(to_text(acceleration_violations(Model{})) == "");
  const auto plain = Model{}.without_acceleration();
  CHECK(to_text(acceleration_violations(plain.neighbour_list(DefaultNeighbourList{}))) == "");
  CHECK(to_text(acceleration_violations(Model{}.screening(EvaluateAll{}))) == "");
}

TEST_CASE("a list that is rebuilt too late and a screening that leaves out too many are reported") {
  check_violated(acceleration_violations(Model{}.neighbour_list(SearchAtTheStart{})),
                 "contact forces are the same: difference");
  check_violated(acceleration_violations(Model{}.screening(FirstFive{})),
                 "as many particles break");
}
