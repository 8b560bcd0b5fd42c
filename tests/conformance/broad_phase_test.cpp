// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>
#include <span>
#include <support/violated.hpp>
#include <vector>

#include <riprap/conformance/broad_phase.hpp>
#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/broad_phase/no_pairs.hpp>
#include <riprap/contact/broad_phase/r_tree.hpp>
#include <riprap/contact/broad_phase/uniform_grid.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct SortedSweep {
  double relative_skin = 0.1;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    std::vector<BodyIndex> order(boxes.size());
    std::iota(order.begin(), order.end(), BodyIndex{0});
    std::ranges::stable_sort(order, {}, [&](BodyIndex i) { return boxes[i].low.x(); });
    for (auto p = order.begin(); p != order.end(); ++p)
      for (auto q = p + 1; q != order.end() && boxes[*q].low.x() <= boxes[*p].high.x(); ++q)
        if (boxes[*p].overlaps(boxes[*q])) visit(std::min(*p, *q), std::max(*p, *q));
  }
  void validate() const {}
};

/// All pairs; `change` gets each of them with the visitor and the number of the visit.
template <class Change>
struct Altered : AllPairs {
  Change change;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    int n = 0;
    AllPairs::visit_pairs(boxes, [&](BodyIndex i, BodyIndex j) { change(visit, i, j, n++); });
  }
};

template <class Change>
Violations violations_of(Change change) {
  return broad_phase_violations(Altered<Change>{{}, change});
}

struct EveryPair {
  double relative_skin = 0.1;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    for (BodyIndex i = 0; i < boxes.size(); ++i)
      for (BodyIndex j = i + 1; j < boxes.size(); ++j) visit(i, j);
  }
  void validate() const {}
};

/// Misses boxes that have an edge in common and no area.
struct OpenBoxes {
  double relative_skin = 0.1;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    AllPairs{}.visit_pairs(boxes, [&](BodyIndex i, BodyIndex j) {
      const Vec2 low = boxes[i].low.cwiseMax(boxes[j].low);
      const Vec2 high = boxes[i].high.cwiseMin(boxes[j].high);
      if (low.x() < high.x() && low.y() < high.y()) visit(i, j);
    });
  }
  void validate() const {}
};

/// Reverses the order of the pairs at every second search.
struct ToAndFro {
  double relative_skin = 0.1;
  mutable bool backwards = false;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    auto pairs = internal::visited_pairs(AllPairs{}, boxes);
    if (backwards) std::reverse(pairs.begin(), pairs.end());
    backwards = !backwards;
    for (const auto& [i, j] : pairs) visit(i, j);
  }
  void validate() const {}
};

/// Visits pairs of an earlier search again.
struct NeverForgets : AllPairs {
  struct Workspace {
    std::vector<internal::BodyPair> pairs;
  };
  using AllPairs::visit_pairs;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Workspace& workspace, Visit&& visit) const {
    if (workspace.pairs.empty()) workspace.pairs = internal::visited_pairs(AllPairs{}, boxes);
    for (const auto& [i, j] : workspace.pairs) visit(i, j);
  }
};

}  // namespace

TEST_CASE("the broad phases of riprap obey the axioms") {
  CHECK(to_text(broad_phase_violations(AllPairs{})) == "");
  CHECK(to_text(broad_phase_violations(UniformGrid{})) == "");
  CHECK(to_text(broad_phase_violations(RTree{})) == "");
}

// NoPairs is for bodies without contacts: it leaves out the pairs by intention.
TEST_CASE("NoPairs misses every pair, and breaks no other axiom") {
  const Violations violations = broad_phase_violations(NoPairs{});
  check_violated(violations, "no pair of boxes that meet is missed: pairs missed");
  CHECK(violations.size() == 1);
}

TEST_CASE("a user's broad phase obeys the axioms") {
  CHECK(to_text(broad_phase_violations(SortedSweep{})) == "");
}

TEST_CASE("a broad phase that misses pairs is reported") {
  const std::string_view missed = "no pair of boxes that meet is missed: pairs missed";
  check_violated(violations_of([](auto&& visit, auto i, auto j, int n) {
                   if (n != 100) visit(i, j);
                 }),
                 missed);
  check_violated(broad_phase_violations(OpenBoxes{}), missed);
}

TEST_CASE("a broad phase that visits too many pairs, or some twice, is reported") {
  check_violated(broad_phase_violations(EveryPair{}),
                 "boxes that keep apart are no pair: pairs too many");
  check_violated(violations_of([](auto&& visit, auto i, auto j, int n) {
                   visit(i, j);
                   if (n == 100) visit(i, j);
                 }),
                 "every pair is visited once: visits");
}

TEST_CASE("a broad phase without order is reported") {
  check_violated(violations_of([](auto&& visit, auto i, auto j, int n) {
                   n == 100 ? visit(j, i) : visit(i, j);
                 }),
                 "the lower index comes first: pairs turned round");
  check_violated(broad_phase_violations(ToAndFro{}),
                 "the order of visits depends on the boxes only");
}

TEST_CASE("a broad phase whose pairs depend on earlier calls is reported") {
  const Violations violations = broad_phase_violations(NeverForgets{});
  check_violated(violations, "what it keeps from search to search changes no pair");
  CHECK(violations.size() == 1);
}

TEST_CASE("a broad phase with a negative skin is reported") {
  check_violated(broad_phase_violations(AllPairs{.relative_skin = -0.1}),
                 "the skin is not negative");
}
