// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Runs an action when a scope is left, by an exception too.

#include <utility>

#include <riprap/core/compiler.hpp>

namespace riprap::internal {

/// Restores what a scope has changed, say.
template <class Action>
class ScopeExit {
 public:
  explicit ScopeExit(Action action) : action_(std::move(action)) {}
  ScopeExit(const ScopeExit&) = delete;
  ScopeExit& operator=(const ScopeExit&) = delete;
  ~ScopeExit() { action_(); }

 private:
  Action action_;
};

}  // namespace riprap::internal
