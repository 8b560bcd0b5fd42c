// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Partition of the pairs into the tasks of a step.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/execution/serial.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {

/// A pair that was appended since the last search, and the pair of that before which it comes.
struct AppendedPair {
  std::uint32_t pair = 0;
  std::uint32_t before = 0;
};

/// Pairs whose first body is one of the task's own: it adds forces to its own bodies only. Bodies
/// that also have pairs in earlier tasks are summed once all tasks have ended.
struct ContactTask {
  std::size_t first_body = 0;
  std::size_t last_body = 0;
  std::size_t first_pair = 0;
  std::size_t last_pair = 0;
  std::vector<AppendedPair> appended{};       ///< beside `first_pair` to `last_pair`, in order
  std::vector<std::uint32_t> shared_pairs{};  ///< of earlier tasks with a body of this, in order
  std::vector<BodyIndex> shared_bodies{};     ///< its bodies in `shared_pairs`, in order
  // Found by the detection.
  std::vector<std::uint32_t> touching{};  ///< those that touch, in order
  std::vector<std::uint32_t> crossing{};  ///< those across the boundary of a periodic cell
  // Found with the forces.
  double largest_overlap = 0;  ///< [m^2]

  [[nodiscard]] std::size_t pairs() const { return last_pair - first_pair + appended.size(); }
  /// Calls `visit(k)` for the index of each of its pairs, in order.
  template <class Visit>
  void for_each_pair(Visit&& visit) const {
    std::size_t k = first_pair;
    for (const AppendedPair& next : appended) {
      for (; k < next.before; ++k) visit(k);
      visit(next.pair);
    }
    for (; k < last_pair; ++k) visit(k);
  }
};

/// Distributes pairs that are sorted by their bodies `a` < `b` over tasks of `task_size` bodies.
template <class ContactType>
void partition_pairs(std::span<const ContactType> pairs, std::size_t bodies,
                     std::vector<ContactTask>& tasks) {
  tasks.resize(task_count(bodies));
  auto pair = pairs.begin();
  const auto index = [&] { return static_cast<std::size_t>(pair - pairs.begin()); };
  for_each_task(Serial{}, bodies, [&](std::size_t t, std::size_t first, std::size_t last) {
    ContactTask& task = tasks[t];
    task.first_body = first;
    task.last_body = last;
    task.first_pair = index();
    pair = std::partition_point(pair, pairs.end(),
                                [last](const ContactType& c) { return c.a < last; });
    task.last_pair = index();
    task.appended.clear();
    task.appended.reserve(16);  // a break allocates nothing here
    task.touching.clear();
    task.touching.reserve(task.pairs() + task.pairs() / 2);  // rarely grows again
    task.crossing.clear();
    task.shared_pairs.clear();
    task.shared_bodies.clear();
  });
  for (const ContactTask& task : tasks)
    for (std::size_t k = task.first_pair; k < task.last_pair; ++k)
      if (pairs[k].b >= task.last_body) {
        ContactTask& other = tasks[task_of(pairs[k].b)];
        other.shared_pairs.push_back(static_cast<std::uint32_t>(k));
        other.shared_bodies.push_back(pairs[k].b);
      }
  for (ContactTask& task : tasks) {
    std::vector<BodyIndex>& shared = task.shared_bodies;
    std::sort(shared.begin(), shared.end());
    shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  }
}

}  // namespace riprap
