// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of damping: what takes energy out of a moving body beside its contacts.

#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace requirements {

/// `damping(body, applied)` -> Wrench. Given, not applied to the body, so that its work can be
/// booked; const, for one damping serves all bodies.
template <class D>
concept DampingCall = requires(const D& damping, const Body& body, const Wrench& applied) {
  { damping(body, applied) } -> std::convertible_to<Wrench>;
};

}  // namespace requirements

/// A `Damping` gives the wrench to be added to the one applied to a free body. The simulation books
/// its work.
template <class D>
concept Damping = Policy<D> && requirements::DampingCall<D>;

template <class D>
consteval bool check_damping() {
  check_policy<D>();
  static_assert(requirements::DampingCall<D>,
                "riprap: a Damping must have Wrench operator()(const Body&, const Wrench&) const");
  return Damping<D>;
}

}  // namespace riprap
