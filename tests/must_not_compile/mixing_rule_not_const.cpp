// SPDX-License-Identifier: BSL-1.0
// riprap: a MixingRule must have Law operator()(const Law& a, const Law& b, const MaterialPair&)
// const
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>
using namespace riprap;

struct Mine {
  LinearSpringCoulomb operator()(const LinearSpringCoulomb& a, const LinearSpringCoulomb&,
                                 const MaterialPair&) {
    return a;
  }
};

using Law = MixedContactLaw<LinearSpringCoulomb, Mine>;
const Law law{std::vector<LinearSpringCoulomb>(2)};
