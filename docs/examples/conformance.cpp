// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <iostream>

#include <riprap/conformance/contact_law.hpp>
using namespace riprap;

struct HertzianSpring {    // normal force stiffness * depth^1.5, no friction
  double stiffness = 1e9;  // [N/m^1.5]
  double deepest = 1e-4;   // depth for which the time step is chosen [m]
  struct History {};       // a contact carries nothing from step to step
  ContactForce operator()(const ContactGeometry& at, const ContactMotion&, History&) const {
    return {.normal = stiffness * at.depth * std::sqrt(at.depth) * at.depth_gradient};
  }
  double stored_energy(const ContactGeometry& at, const History&) const {
    return 0.4 * stiffness * at.depth * at.depth * std::sqrt(at.depth);
  }
  double peak_stiffness() const { return 1.5 * stiffness * std::sqrt(deepest); }
};

int main() {
  const Violations violations = contact_law_violations(HertzianSpring{}, {.deepest = 1e-4});
  std::cerr << to_text(violations);
  return violations.empty() ? 0 : 1;
}
