// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The pairs of neighbours, by body and by task.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_list.hpp>
#include <riprap/contact/pair/task_partition.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A pair list, the pairs of each body in it, and the tasks that they are distributed over. A break
/// adds the pairs of the new piece to all of them, at a cost that does not depend on their number.
template <class ContactType>
class PairTable {
 public:
  [[nodiscard]] const PairList<ContactType>& list() const { return list_; }
  [[nodiscard]] PairList<ContactType>& list() { return list_; }
  [[nodiscard]] std::span<const ContactType> pairs() const { return list_.pairs(); }
  [[nodiscard]] std::span<ContactType> pairs() { return list_.pairs(); }
  [[nodiscard]] const PairIndex& index() const { return index_; }
  [[nodiscard]] std::span<const ContactTask> tasks() const { return tasks_; }
  [[nodiscard]] std::span<ContactTask> tasks() { return tasks_; }

  /// After a search: sets everything up for the new list. No pair is listed as touching.
  void arrange(const Particles& particles) {
    for (ContactType& pair : pairs())
      pair.know_bodies(particles.body(pair.a), particles.body(pair.b));
    partition_pairs(std::as_const(list_).pairs(), particles.size(), tasks_);
    index_.build(pairs(), particles.size());
  }

  /// The body at `parent` has become two pieces, one at the same index, one at `second`, above all
  /// others: adds the pairs of the second one, which are to be evaluated.
  void divide(const Particles& particles, BodyIndex parent, BodyIndex second) {
    const std::size_t before = list_.size();
    list_.divide(index_.of(parent), parent, second);
    if (task_of(second) == tasks_.size())
      tasks_.push_back({.first_body = second,
                        .last_body = second,
                        .first_pair = list_.searched(),
                        .last_pair = list_.searched()});
    tasks_.back().last_body = second + std::size_t{1};
    for (std::size_t k = before; k < list_.size(); ++k) index_.add(second, {k, true});
    for (std::size_t k = before; k < list_.size(); ++k) {
      ContactType& pair = pairs()[k];
      pair.know_bodies(particles.body(pair.a), particles.body(pair.b));
      index_.add(pair.a, {k, false});
      add_to_tasks(static_cast<std::uint32_t>(k));
    }
  }

  /// Lists the touching pairs of all tasks, from the pairs' own flags.
  void list_touching() {
    for (ContactTask& task : tasks_) {
      task.touching.clear();
      task.crossing.clear();
      task.for_each_pair([&](std::size_t k) {
        if (!pairs()[k].touching) return;
        task.touching.push_back(static_cast<std::uint32_t>(k));
        if (pairs()[k].crosses_boundary) task.crossing.push_back(static_cast<std::uint32_t>(k));
      });
    }
  }
  /// Lists pair k as touching or not, from its own flag.
  void list_touching(std::uint32_t k) {
    const ContactType& pair = pairs()[k];
    ContactTask& task = tasks_[task_of(pair.a)];
    list_if(pair.touching, k, task.touching);
    if (pair.crosses_boundary) list_if(pair.touching, k, task.crossing);
  }

 private:
  void add_to_tasks(std::uint32_t k) {
    const ContactType& pair = pairs()[k];
    std::vector<AppendedPair>& own = tasks_[task_of(pair.a)].appended;
    const auto precedes = [this](const AppendedPair& p, std::uint32_t q) {
      return list_.precedes(p.pair, q);
    };
    own.insert(std::lower_bound(own.begin(), own.end(), k, precedes),
               {k, static_cast<std::uint32_t>(list_.place(k))});
    if (task_of(pair.a) == task_of(pair.b)) return;
    ContactTask& other = tasks_[task_of(pair.b)];
    list_if(true, k, other.shared_pairs);
    if (other.shared_bodies.empty() || other.shared_bodies.back() != pair.b)
      other.shared_bodies.push_back(pair.b);
  }

  // Puts k in its place in an ordered list, or takes it out.
  void list_if(bool member, std::uint32_t k, std::vector<std::uint32_t>& list) const {
    const auto precedes = [this](std::uint32_t p, std::uint32_t q) { return list_.precedes(p, q); };
    const auto at = std::lower_bound(list.begin(), list.end(), k, precedes);
    const bool listed = at != list.end() && *at == k;
    if (member && !listed) list.insert(at, k);
    if (!member && listed) list.erase(at);
  }

  PairList<ContactType> list_;
  PairIndex index_;
  std::vector<ContactTask> tasks_;
};

}  // namespace riprap
