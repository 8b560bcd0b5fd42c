// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <optional>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct SoftSkin {           // faces carry no load until their outermost layer is crossed
  double thickness = 1e-4;  // of the layer, both bodies together [m]
  using Cache = OverlapChord::Cache;
  std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    std::optional<ContactGeometry> contact = OverlapChord{}(a, b, cache);
    if (!contact || contact->depth <= thickness) return std::nullopt;
    contact->depth -= thickness;
    return contact;
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  const auto model = Model{}.criterion(NeverFails{}).narrow_phase(SoftSkin{});
  Simulation sim{model, pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  double push = 0;
  sim.contacts().for_each_touching([&](const auto& contact) { push += contact.force.normal; });
  return std::abs(push / (2 * 2e7 * 9e-4) - 1) < 1e-9 ? 0 : 1;  // k_n times what is left of 1 mm
}
