// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/porosity.hpp>
#include <riprap/output/assembly_view.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const RandomAssembly few{.count = 40, .seed = 2};

Assembly assembly_for(const StrainField&) { return random_assembly(few); }
Assembly assembly_for(const RigidPlatens&) { return random_platen_assembly(few); }
Assembly assembly_for(const PeriodicCell&) { return random_periodic_assembly(few); }

// What is measured on a sample, and where its vertices are in the sample and in a picture.
struct Observed {
  std::vector<Vec2> vertices;
  std::vector<Vec2> pixels;
  Vec2 semi_axes;
  std::vector<double> numbers;
};

// Compressed from `shift` [m] for so many steps, or until six contacts have come.
template <class BoundaryT>
Observed compressed(const BoundaryT& boundary, const Vec2& shift, int& steps) {
  // Forces without jumps, so that round-off does not grow from one contact to the next.
  Simulation sim{Model{}
                     .boundary(boundary)
                     .criterion(NeverFails{})
                     .contact_law(OverlapAreaSpring{.friction = 0})
                     .damping(NoDamping{}),
                 assembly_for(boundary).moved(shift), Rock{}};
  sim.boundary().set_rate(40, 60);
  const Vec2 centre = centre_of(sim.boundary().region(sim.particles()));
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const Vec2 x = sim.particles().body(i).position - centre;
    if (sim.particles().body(i).is_free()) sim.set_velocity(i, {-40 * x.x(), -60 * x.y()});
  }
  const auto contacts = [&] { return state_averages(sim.contacts(), sim.particles()).contacts; };
  const bool search = steps == 0;
  for (int step = 0; search ? contacts() < 6 : step < steps; ++step) {
    sim.step();
    if (search) steps = step + 1;
  }

  const auto region = sim.boundary().region(sim.particles());
  const Ellipse inner{0.6 * Vec2(region.semi_axes()), centre_of(region)};
  const double thickness = sim.particles().thickness();
  const Stress2 stress = average_stress(sim.contacts(), region.area(), thickness);
  const Stress2 inside = average_stress_within(sim.contacts(), inner, thickness);
  Observed o{.vertices = {},
             .pixels = {},
             .semi_axes = region.semi_axes(),
             .numbers = {region.area(), region.solid_area(), porosity(region, sim.contacts()),
                         stress.s11 / 1e6, stress.s22 / 1e6, inside.s11 / 1e6, inside.s12 / 1e6,
                         static_cast<double>(region.lost()), kinetic_energy(sim.particles())}};
  const AssemblyView view(sim.particles());
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    for (const Vec2& v : sim.particles().ring(i)) {
      o.vertices.push_back(v - shift);
      o.pixels.push_back(view(v));
    }
  return o;
}

}  // namespace

TEST_CASE_TEMPLATE("a sample away from the origin is strained and measured as one about it",
                   BoundaryT, StrainField, RigidPlatens, PeriodicCell) {
  int steps = 0;
  const Observed here = compressed(BoundaryT{}, {0, 0}, steps);
  CHECK(std::max(here.numbers[3], here.numbers[4]) > 1e-3);  // particles have met
  CHECK(here.numbers[7] == 0);
  for (const auto& [shift, tolerance] :
       {std::pair{Vec2{0.06, 0}, 1e-9}, std::pair{Vec2{0.1, -0.1}, 1e-9},
        std::pair{Vec2{1000, 700}, 1e-5}}) {
    CAPTURE(shift.x());
    const Observed there = compressed(BoundaryT{}, shift, steps);
    CHECK((there.semi_axes - here.semi_axes).norm() <= tolerance * here.semi_axes.norm());
    for (std::size_t k = 0; k < here.numbers.size(); ++k) {
      CAPTURE(k);
      CHECK(std::abs(there.numbers[k] - here.numbers[k]) <= tolerance);
    }
    double moved = 0;
    double drawn = 0;
    for (std::size_t k = 0; k < here.vertices.size(); ++k) {
      moved = std::max(moved, (there.vertices[k] - here.vertices[k]).norm());
      drawn = std::max(drawn, (there.pixels[k] - here.pixels[k]).norm());
    }
    // A thousand metres away coordinates are rounded to 1e-13 m at each step.
    CHECK(moved <= tolerance * here.semi_axes.norm());
    CHECK(drawn <= 1000 * tolerance);
  }
}

TEST_CASE_TEMPLATE("a biaxial test runs wherever its sample lies", BoundaryT, StrainField,
                   RigidPlatens, PeriodicCell) {
  const BiaxialTest test{.confining_pressure = 4e6, .axial_strain = 0.01};
  const auto peak = [&](const Vec2& shift) {
    Simulation sim{Model{}.boundary(BoundaryT{}).criterion(NeverFails{}),
                   assembly_for(BoundaryT{}).moved(shift), Rock{}};
    Curve curve;
    const BiaxialResult result = test.run(sim, curve);
    CHECK(result.stage(Stage::hydrostatic).reached_target);
    CHECK(curve.points().back().lost_particles == 0);
    return std::pair(curve.peak().sin_phi(), curve.points().front().porosity);
  };
  const auto here = peak({0, 0});
  const auto there = peak({1000, 700});
  // Two samples of the same particles: round-off has grown to another packing.
  CHECK(there.first == near(here.first, 0.1));
  CHECK(there.second == near(here.second, 0.03));
}

TEST_CASE("a periodic assembly that lies elsewhere than its cell is refused") {
  Assembly assembly = random_periodic_assembly(few).moved({1000, 700});
  assembly.centre = {0, 0};
  CHECK_THROWS_WITH_AS(
      (Simulation{Model{}.boundary(PeriodicCell{}), assembly, Rock{}}),
      "PeriodicCell: no particle lies within a period of Assembly.centre = (0, 0) m", InvalidInput);
}
