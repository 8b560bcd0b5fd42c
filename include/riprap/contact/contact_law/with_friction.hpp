// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law with another friction, to compact samples with: the more, the looser they become.

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// A law whose friction can be set: by its own `with_friction(mu)`, or a member `friction`.
template <class L>
concept FrictionalLaw = ContactLaw<L> && (
                                             requires(const L& law) { law.with_friction(0.0); } ||
                                             requires(L& law) { law.friction = 0.0; });

/// The same law with a friction coefficient of mu [-]. Contacts of a simulation whose law is
/// exchanged keep their tangential forces, which slip at the next step where they are above the new
/// limit; the energy lost is booked as friction. Throws InvalidInput unless mu is finite, 0 or
/// above.
template <FrictionalLaw L>
[[nodiscard]] L with_friction(const L& law, double mu) {
  require_non_negative("with_friction: friction", mu);
  if constexpr (requires { law.with_friction(mu); }) {
    return law.with_friction(mu);
  } else {
    L copy = law;
    copy.friction = mu;
    return copy;
  }
}

}  // namespace riprap
