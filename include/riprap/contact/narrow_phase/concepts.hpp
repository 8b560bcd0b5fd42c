#pragma once
/// @file
/// The role of the narrow phase: do two convex rings touch, and how.

#include <concepts>
#include <optional>

#include <riprap/contact/contact_geometry.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// A `NarrowPhase` turns two placed rings into contact geometry.
///
/// - `N::Memory`: what a pair remembers from step to step (a separating edge, say); it may speed
///   the answer up and must never change it.
/// - `narrow(a, b, memory)` -> the contact, or nothing where the rings keep apart. Swapping the
///   rings flips the normal and changes nothing else; moving both rigidly moves the answer.
template <class N>
concept NarrowPhase = std::default_initializable<typename N::Memory> &&
                      requires(const N& narrow, Ring a, Ring b, typename N::Memory& memory) {
                        {
                          narrow(a, b, memory)
                        } -> std::convertible_to<std::optional<ContactGeometry>>;
                      };

}  // namespace riprap
