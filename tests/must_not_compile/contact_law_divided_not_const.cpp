// SPDX-License-Identifier: BSL-1.0
// riprap: divided_history of a ContactLaw must be History divided_history(const History&, const
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : LinearSpringCoulomb {
  History divided_history(const History& history, const ContactGeometry&, const DividedContact&) {
    return history;
  }
};

const auto model = Model{}.contact_law(Mine{});
