// SPDX-License-Identifier: BSL-1.0
// riprap: a ContactLaw must have a type History that can be default-constructed and copied
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  ContactForce operator()(const ContactGeometry& at, const ContactMotion&) const {
    return {.normal = 1e7 * at.depth};
  }
  double stored_energy(const ContactGeometry& at) const { return 5e6 * at.depth * at.depth; }
  double peak_stiffness() const { return 1e7; }
};

const auto model = Model{}.contact_law(Mine{});
