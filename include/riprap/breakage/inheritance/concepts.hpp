// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of inheritance: the initial velocity of a piece.

#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace requirements {

/// `inherit(parent, piece)` sets `piece.velocity` and `piece.angular_velocity`. The piece is the
/// body itself, already in place, with its mass, for its velocities depend on both. Const, for one
/// inheritance serves all pieces.
template <class I>
concept InheritanceCall =
    requires(const I& inherit, const Body& parent, Body& piece) { inherit(parent, piece); };

}  // namespace requirements

/// An `Inheritance` gives a piece its velocities.
template <class I>
concept Inheritance = Policy<I> && requirements::InheritanceCall<I>;

template <class I>
consteval bool check_inheritance() {
  check_policy<I>();
  static_assert(
      requirements::InheritanceCall<I>,
      "riprap: an Inheritance must have void operator()(const Body& parent, Body& piece) const");
  return Inheritance<I>;
}

}  // namespace riprap
