// SPDX-License-Identifier: BSL-1.0
// riprap: an OperatorStore must have a class State, made from it, with exact(i,
// build), find(i) const, forget(i), begin_epoch(particles) and bytes() const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct State : KeepAllOperators::State {
    explicit State(const Mine&) {}
    void find(BodyIndex) const {}
  };
};

const auto model = Model{}.operator_store(Mine{});
