// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sums over the contacts of a sample, which do not depend on its division into tasks.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include <riprap/core/exact_sum.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {

/// Sums of N values over contacts, plain over those of one body a and exact over bodies: as good as
/// exact, for less. The contacts of a body come one after the other, in order.
template <std::size_t N>
class ContactSum {
 public:
  void add(BodyIndex a, const std::array<double, N>& values) {
    if (a != body_) {
      close();
      body_ = a;
    }
    for (std::size_t n = 0; n < N; ++n) of_body_[n] += values[n];
  }
  /// Joins the sum of other bodies.
  ContactSum& operator+=(ContactSum& o) {
    close();
    o.close();
    for (std::size_t n = 0; n < N; ++n) sums_[n] += o.sums_[n];
    return *this;
  }
  [[nodiscard]] std::array<double, N> values() {
    close();
    std::array<double, N> out{};
    for (std::size_t n = 0; n < N; ++n) out[n] = sums_[n].value();
    return out;
  }

 private:
  void close() {
    for (std::size_t n = 0; n < N; ++n) sums_[n].add(of_body_[n]);
    of_body_ = {};
  }

  BodyIndex body_ = 0;
  std::array<double, N> of_body_{};
  std::array<ExactSum, N> sums_{};
};

/// Sums of `values(contact)`, an array of N numbers, over all touching pairs. Pairs that know their
/// tasks are summed task by task, in parallel, with the same result.
template <std::size_t N, class Contacts, class Values, Execution E = Serial>
[[nodiscard]] std::array<double, N> sum_over_contacts(const Contacts& contacts, Values&& values,
                                                      const E& execution = {}) {
  if constexpr (!std::is_same_v<E, Serial> && requires { contacts.tasks(); }) {
    constexpr std::size_t most_shares = 16;  // more than the usual number of threads
    const std::size_t tasks = contacts.tasks();
    const std::size_t shares = std::clamp<std::size_t>(tasks, 1, most_shares);
    std::array<ContactSum<N>, most_shares> sums;
    execution.run(shares, [&](std::size_t share) {
      for (std::size_t task = share; task < tasks; task += shares)
        contacts.for_each_touching_in(task,
                                      [&](const auto& c) { sums[share].add(c.a, values(c)); });
    });
    for (std::size_t share = 1; share < shares; ++share) sums[0] += sums[share];
    return sums[0].values();
  } else {
    ContactSum<N> sum;
    contacts.for_each_touching([&](const auto& c) { sum.add(c.a, values(c)); });
    return sum.values();
  }
}

}  // namespace riprap
