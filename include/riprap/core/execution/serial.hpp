// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// One task after the other: the default.

#include <riprap/core/execution/concepts.hpp>

namespace riprap {

/// A plain loop, which costs nothing.
struct Serial {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    for (std::size_t k = 0; k < tasks; ++k) work(k);
  }
};

static_assert(Execution<Serial>);

}  // namespace riprap
