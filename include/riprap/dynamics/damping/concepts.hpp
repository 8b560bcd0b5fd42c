#pragma once
/// @file
/// The role of damping: what takes energy out of a moving body beside its contacts.

#include <concepts>

#include <riprap/particle/body.hpp>

namespace riprap {

/// A `Damping` gives the wrench to be added to the one applied to a free body. The simulation books
/// its work.
///
/// - `damping(body, applied)` -> Wrench
/// - `damping.validate()`: throws InvalidInput for parameters that break a rule.
template <class D>
concept Damping = requires(const D& damping, const Body& body, const Wrench& applied) {
  { damping(body, applied) } -> std::same_as<Wrench>;
  damping.validate();
};

}  // namespace riprap
