// SPDX-License-Identifier: BSL-1.0
#pragma once
// Threads that take one run after the other.

#include <cstddef>
#include <functional>
#include <string>

namespace run_table {

// Calls `work(k)` for k = 0, 1, ... below `count`, in this order, `jobs` at a time on threads of
// their own; meanwhile `watch()` on this one, some times a second. `work` must not throw.
void work_through(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void()>& watch = {});

// "40 s", "12 min", "5.2 h"
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace run_table
