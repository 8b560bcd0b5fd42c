// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the broad phase.

#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <riprap/conformance/violations.hpp>
#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/core/random.hpp>

namespace riprap {
namespace internal {

using BodyPair = std::pair<BodyIndex, BodyIndex>;

template <BroadPhase Broad>
[[nodiscard]] std::vector<BodyPair> visited_pairs(const Broad& broad, std::span<const Box> boxes) {
  std::vector<BodyPair> pairs;
  broad.visit_pairs(boxes, [&pairs](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
  return pairs;
}

/// That memory from searches for other boxes, if it keeps any, changes nothing.
template <BroadPhase Broad>
class WorkspaceCheck {
 public:
  void operator()(const Broad& broad, std::span<const Box> boxes,
                  const std::vector<BodyPair>& expected, AxiomCheck& check) {
    if constexpr (requires { typename Broad::Workspace; }) {
      std::vector<BodyPair> pairs;
      broad.visit_pairs(boxes, workspace_,
                        [&pairs](BodyIndex i, BodyIndex j) { pairs.emplace_back(i, j); });
      check.holds("what it keeps from search to search changes no pair", pairs == expected);
    }
  }

 private:
  typename requirements::WorkspaceOf<Broad>::type workspace_{};
};

template <BroadPhase Broad>
void check_pairs(const Broad& broad, std::span<const Box> boxes, WorkspaceCheck<Broad>& workspace,
                 AxiomCheck& check) {
  check.at("number of boxes", static_cast<double>(boxes.size()));
  const std::vector<BodyPair> pairs = visited_pairs(broad, boxes);
  const std::set<BodyPair> found(pairs.begin(), pairs.end());
  std::set<BodyPair> expected;
  for (BodyIndex i = 0; i < boxes.size(); ++i)
    for (BodyIndex j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].overlaps(boxes[j])) expected.emplace(i, j);

  double missed = 0;
  for (const BodyPair& pair : expected)
    missed += !found.contains(pair) && !found.contains({pair.second, pair.first});
  double idle = 0;
  double turned = 0;
  for (const BodyPair& pair : found) {
    turned += pair.first >= pair.second;
    idle += !expected.contains(pair) && !expected.contains({pair.second, pair.first});
  }
  check.equal("no pair of boxes that meet is missed: pairs missed", missed, 0, 0);
  check.equal("boxes that keep apart are no pair: pairs too many", idle, 0, 0);
  check.equal("the lower index comes first: pairs turned round", turned, 0, 0);
  check.equal("every pair is visited once: visits", static_cast<double>(pairs.size()),
              static_cast<double>(found.size()), 0);
  check.holds("the order of visits depends on the boxes only",
              visited_pairs(broad, boxes) == pairs);
  workspace(broad, boxes, pairs, check);
}

/// Boxes of `smallest` to `largest` [m] in a square of `extent` [m] somewhere in the plane.
[[nodiscard]] inline std::vector<Box> random_boxes(Random& random, std::size_t count, double extent,
                                                   double smallest, double largest) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 low{random.uniform(0, extent) - 3, random.uniform(0, extent) + 5};
    boxes.push_back(
        {low, low + Vec2{random.uniform(smallest, largest), random.uniform(smallest, largest)}});
  }
  return boxes;
}

}  // namespace internal

/// Which axioms a broad phase breaks: for boxes many and few, dense and sparse, of one size and of
/// very different ones, in a row, edge to edge, one on the other.
template <BroadPhase Broad>
[[nodiscard]] Violations broad_phase_violations(const Broad& broad) {
  AxiomCheck check;
  internal::WorkspaceCheck<Broad> workspace;
  check.at_least("the skin is not negative", broad.relative_skin, 0);
  Random random(1);
  for (const unsigned count : {0u, 1u, 2u, 300u})
    for (const double extent : {0.05, 0.3, 5.0})
      internal::check_pairs(broad, internal::random_boxes(random, count, extent, 0.01, 0.02),
                            workspace, check);
  internal::check_pairs(broad, internal::random_boxes(random, 200, 1, 1e-4, 0.5), workspace, check);

  std::vector<Box> sample = internal::random_boxes(random, 100, 0.3, 0.01, 0.02);
  sample.insert(sample.begin() + 50, Box{{-9, -9}, {9, 9}});
  internal::check_pairs(broad, sample, workspace, check);

  std::vector<Box> tiles;
  for (int i = 0; i < 36; ++i) {
    const Vec2 low{i % 6, i / 6};
    tiles.push_back({low, low + Vec2{1, 1}});
  }
  internal::check_pairs(broad, tiles, workspace, check);
  std::vector<Box> row;
  for (int i = 0; i < 40; ++i) row.push_back({{0.7 * i, 2}, {0.7 * i + 1, 3}});
  internal::check_pairs(broad, row, workspace, check);
  internal::check_pairs(broad, std::vector<Box>(10, Box{{1, 1}, {2, 2}}), workspace, check);
  return std::move(check).violations();
}

}  // namespace riprap
