// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts without force: bodies pass through each other. The file to copy for a law of your own.

#include <riprap/contact/contact_law/concepts.hpp>

namespace riprap {

/// Zero force, no stored energy; contacts are detected all the same.
struct NoContactForce {
  struct History {};

  [[nodiscard]] ContactForce operator()(const ContactGeometry&, const ContactMotion&,
                                        History&) const {
    return {};
  }
  [[nodiscard]] double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  /// Sets the time step where nothing else does [N/m].
  [[nodiscard]] double peak_stiffness() const { return 2e7; }
};

static_assert(ContactLaw<NoContactForce>);

}  // namespace riprap
