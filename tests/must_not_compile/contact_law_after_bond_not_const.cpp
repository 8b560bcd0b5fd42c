// SPDX-License-Identifier: BSL-1.0
// riprap: history_after_bond of a ContactLaw must be History
// history_after_bond(const ContactGeometry&, const FormerBond&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : EnergyConservingSpring {
  History history_after_bond(const ContactGeometry&, const FormerBond&) { return {}; }
};

const auto model = Model{}.contact_law(Mine{});
