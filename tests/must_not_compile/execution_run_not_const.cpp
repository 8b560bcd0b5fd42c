// SPDX-License-Identifier: BSL-1.0
// riprap: an Execution must have template <class Work> void run(std::size_t tasks, Work&&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class Work>
  void run(std::size_t tasks, Work&& work) {
    for (std::size_t k = 0; k < tasks; ++k) work(k);
  }
};

const auto model = Model{}.execution(Mine{});
