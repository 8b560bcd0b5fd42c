// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law with another friction, to compact samples with: the more, the looser they become.

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

namespace internal {

template <class L>
concept GivesOtherFriction = requires(const L& law) { law.with_friction(0.0); };
template <class L>
concept HasFriction = requires(L& law) { law.friction = 0.0; };

}  // namespace internal

/// A law whose friction can be set: by its own `with_friction(mu)`, or a member `friction`.
template <class L>
concept FrictionalLaw =
    ContactLaw<L> && (internal::GivesOtherFriction<L> || internal::HasFriction<L>);

/// The same law with a friction coefficient of mu [-]. Contacts of a simulation whose law is
/// exchanged keep their tangential forces, which slip at the next step where they are above the new
/// limit; the energy lost is booked as friction. Throws InvalidInput unless mu is finite, 0 or
/// above.
template <FrictionalLaw L>
[[nodiscard]] L with_friction(const L& law, double mu) {
  require_non_negative("with_friction: friction", mu);
  if constexpr (internal::GivesOtherFriction<L>) {
    return law.with_friction(mu);
  } else {
    L copy = law;
    copy.friction = mu;
    return copy;
  }
}

}  // namespace riprap
