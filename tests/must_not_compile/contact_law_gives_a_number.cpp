// SPDX-License-Identifier: BSL-1.0
// riprap: a ContactLaw must have ContactForce operator()(const ContactGeometry&, const
// ContactMotion&, History&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct History {};
  double operator()(const ContactGeometry& at, const ContactMotion&, History&) const {
    return 1e7 * at.depth;
  }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  double peak_stiffness() const { return 1e7; }
};

const auto model = Model{}.contact_law(Mine{});
