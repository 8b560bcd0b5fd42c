// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law with its friction taken away, to compact samples with.

#include <riprap/contact/contact_law/concepts.hpp>

namespace riprap {

/// The law's own `frictionless()` where it has one, else a copy with its member `friction` set to
/// 0; a law without either is returned as it is.
template <ContactLaw L>
[[nodiscard]] L frictionless(const L& law) {
  if constexpr (requires { law.frictionless(); }) {
    return law.frictionless();
  } else {
    L copy = law;
    if constexpr (requires { copy.friction = 0.0; }) copy.friction = 0.0;
    return copy;
  }
}

}  // namespace riprap
