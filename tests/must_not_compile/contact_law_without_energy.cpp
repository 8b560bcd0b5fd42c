// SPDX-License-Identifier: BSL-1.0
// riprap: a ContactLaw must have double stored_energy(const ContactGeometry&, const History&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct History {};
  ContactForce operator()(const ContactGeometry& at, const ContactMotion&, History&) const {
    return {.normal = 1e7 * at.depth};
  }
  double peak_stiffness() const { return 1e7; }
};

const auto model = Model{}.contact_law(Mine{});
