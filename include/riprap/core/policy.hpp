// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What all policies have in common, whatever their role.

#include <concepts>
#include <string>

#include <riprap/core/compiler.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

namespace requirements {

/// A `Model` keeps policies by value and passes them on to the next one; nothing is assigned, so
/// that a lambda with captures will do.
template <class P>
concept PolicyCopy = std::copy_constructible<P>;

/// Optional: `policy.validate()` throws InvalidInput for parameters that break a rule. A function
/// that is not const would be ignored silently.
template <class P>
concept PolicyValidate =
    !requires(P& policy) { policy.validate(); } || requires(const P& policy) { policy.validate(); };

}  // namespace requirements

/// Requirements common to all policies.
template <class P>
concept Policy = requirements::PolicyCopy<P> && requirements::PolicyValidate<P>;

/// One sentence about the requirement that a policy breaks, in an error that names its type. Every
/// role has such a function beside its concept, with the same requirements; the setters of Model
/// call it.
template <class P>
consteval bool check_policy() {
  static_assert(requirements::PolicyCopy<P>,
                "riprap: a policy must be copy-constructible, for a Model keeps it by value");
  static_assert(requirements::PolicyValidate<P>, "riprap: validate() of a policy must be const");
  return Policy<P>;
}

/// Calls `validate()` of a policy that has one; throws InvalidInput.
template <class P>
void validate(const P& policy) {
  if constexpr (requires { policy.validate(); }) policy.validate();
}

/// The same; the error begins with a name, such as "criterion of material 2".
template <class P>
void validate_named(const std::string& name, const P& policy) {
  try {
    validate(policy);
  } catch (const InvalidInput& error) {
    throw InvalidInput(name + ": " + error.what());
  }
}

}  // namespace riprap
