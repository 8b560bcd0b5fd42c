#pragma once
/// @file
/// The role of inheritance: the motion of a piece at birth.

#include <concepts>

#include <riprap/particle/body.hpp>

namespace riprap {

/// An `Inheritance` gives a piece its velocities. The piece is already in place, with its mass.
///
/// - `inherit(parent, piece)`: sets `piece.velocity` and `piece.angular_velocity`.
template <class I>
concept Inheritance =
    requires(const I& inherit, const Body& parent, Body& piece) { inherit(parent, piece); };

}  // namespace riprap
