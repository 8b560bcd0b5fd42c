// SPDX-License-Identifier: BSL-1.0
// riprap: a Detection must have template <class Narrow> class State with carry(),
// forget(), forget_all() and find(input, task)
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class Narrow>
  struct State {
    void forget(std::size_t) {}
    void forget_all() {}
    template <class Input>
    void find(const Input&, ContactTask&) {}
  };
};

const auto model = Model{}.detection(Mine{});
