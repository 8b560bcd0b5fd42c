// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Loops over the pairs of a contact list that touch.

#include <cstddef>
#include <cstdint>

#include <riprap/contact/pair/task_partition.hpp>

namespace riprap {

/// Base of a contact list, which has `table()`.
template <class List>
class TouchingPairs {
 public:
  /// Calls `visit(contact)` for every pair that touches, in the order (a, b, image).
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (std::size_t task = 0; task < tasks(); ++task) for_each_touching_in(task, visit);
  }
  /// Number of tasks, and the touching pairs whose first body is of one of them, in order.
  [[nodiscard]] std::size_t tasks() const { return list().table().tasks().size(); }
  template <class Visit>
  void for_each_touching_in(std::size_t task, Visit&& visit) const {
    for (const std::uint32_t k : list().table().tasks()[task].touching) visit(list().pairs()[k]);
  }

  /// Calls `visit(contact, index)` once for every touching pair with a body of a task of
  /// `for_each_task`, in the order of the pairs, so that tasks can gather by body in parallel.
  template <class Visit>
  void for_each_touching_of(std::size_t task, Visit&& visit) const {
    if (task >= tasks()) return;
    const ContactTask& of = list().table().tasks()[task];
    for (const std::uint32_t k : of.shared_pairs)
      if (list().pairs()[k].touching) visit(list().pairs()[k], k);
    for (const std::uint32_t k : of.touching) visit(list().pairs()[k], k);
  }

 private:
  friend List;
  TouchingPairs() = default;
  [[nodiscard]] const List& list() const { return static_cast<const List&>(*this); }
};

}  // namespace riprap
