// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the operator store: which influence operators stay in memory.

#include <concepts>
#include <cstddef>
#include <memory>

#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

namespace requirements {

/// Stands for the function that builds an operator.
struct OperatorBuilder {
  std::unique_ptr<InfluenceOperator> operator()() const { return nullptr; }
};

/// `O::State`, made from the policy: what a simulation keeps. `state.exact(i, build)` is the
/// operator of particle i, from memory or from `build()`, valid until the next call for another
/// particle; `state.find(i)` the same if it is in memory, or null; `state.forget(i)` discards it:
/// another particle has that index now; `state.begin_epoch(particles)` precedes the checks of a
/// step; `state.bytes()` is the memory in use.
template <class O>
concept OperatorStoreState =
    requires { typename O::State; } && std::constructible_from<typename O::State, const O&> &&
    requires(typename O::State& state, const typename O::State& constant, BodyIndex i,
             std::size_t particles) {
      {
        state.exact(i, requirements::OperatorBuilder{})
      } -> std::convertible_to<const InfluenceOperator&>;
      { constant.find(i) } -> std::convertible_to<const InfluenceOperator*>;
      state.forget(i);
      state.begin_epoch(particles);
      { constant.bytes() } -> std::convertible_to<std::size_t>;
    };

}  // namespace requirements

/// An `OperatorStore` keeps influence operators. It changes no result: an operator that is built
/// again has the same bytes.
template <class O>
concept OperatorStore = Policy<O> && requirements::OperatorStoreState<O>;

template <class O>
consteval bool check_operator_store() {
  check_policy<O>();
  static_assert(requirements::OperatorStoreState<O>,
                "riprap: an OperatorStore must have a class State, made from it, with exact(i, "
                "build), find(i) const, forget(i), begin_epoch(particles) and bytes() const");
  return OperatorStore<O>;
}

}  // namespace riprap
