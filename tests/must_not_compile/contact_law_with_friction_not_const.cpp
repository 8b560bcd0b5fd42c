// SPDX-License-Identifier: BSL-1.0
// riprap: with_friction(double) of a ContactLaw must be const and return such a law
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : LinearSpringCoulomb {
  Mine with_friction(double) { return {}; }
};

const auto model = Model{}.contact_law(Mine{});
