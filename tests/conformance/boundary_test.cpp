// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <support/archetypes.hpp>
#include <support/violated.hpp>
#include <vector>

#include <riprap/conformance/boundary.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>

using namespace riprap;
using test::check_violated;

namespace {

const RandomAssembly options{.count = 60, .seed = 2};
const Assembly ring = random_assembly(options);
const Assembly box = random_platen_assembly(options);
const Assembly cell = random_periodic_assembly(options);

/// Moves prescribed bodies to and fro.
struct ShakingTable {
  double speed = 0.05;     // [m/s]
  double frequency = 5e4;  // [Hz]
  double time = 0;         // [s]
  void drive(std::vector<Body>& bodies, double time_step) {
    time += time_step;
    for (Body& body : bodies)
      if (body.motion == Motion::prescribed)
        body.velocity = Vec2{speed * std::sin(frequency * time), 0};
  }
};

/// A ring whose bodies end each step where the rate would take them if it acted exponentially.
struct ExponentialField : StrainField {
  void drive(std::vector<Body>& bodies, double time_step) const {
    for (Body& body : bodies)
      if (body.motion == Motion::strain_field)
        for (int k : {0, 1})
          body.velocity[k] = body.position[k] * std::expm1(-rate()[k] * time_step) / time_step;
  }
};

/// The ring, and then `change` of every body.
template <class Change>
struct Altered : StrainField {
  Change change;
  void drive(std::vector<Body>& bodies, double time_step) const {
    StrainField::drive(bodies, time_step);
    for (Body& body : bodies) change(body);
  }
};

template <class Change>
Violations violations_of(Change change) {
  return boundary_violations(Altered<Change>{{}, change}, ring);
}

struct AddsBodies : StrainField {
  void drive(std::vector<Body>& bodies, double) const { bodies.emplace_back(); }
};

/// Exchanges the two axes.
struct SwappedAxes : StrainField {
  void set_rate(double axis_1, double axis_2) { StrainField::set_rate(axis_2, axis_1); }
};

/// Takes rates with the opposite sign.
struct WrongSign : StrainField {
  void set_rate(double axis_1, double axis_2) { StrainField::set_rate(-axis_1, -axis_2); }
};

/// The cell, the images of which stay where they are.
struct StiffCell : PeriodicCell {
  void drift(double) {}
};

/// The cell, the shear of which acts along the wrong direction.
struct ContraryCell : PeriodicCell {
  void drift(double time_step) {
    const double rate = shear_rate();
    PeriodicCell::set_shear_rate(-rate);
    PeriodicCell::drift(time_step);
    PeriodicCell::set_shear_rate(rate);
  }
};

/// The cell that takes tensor components of shear.
struct TensorCell : PeriodicCell {
  void set_shear_rate(double rate) { PeriodicCell::set_shear_rate(2 * rate); }
};

/// The ring, with another region.
template <class RegionType>
struct Measured : StrainField {
  RegionType region(const Particles& particles) const {
    return RegionType{StrainField::region(particles)};
  }
};
struct Whole : BoundaryPolygon {
  double solid_area() const { return 2 * area(); }
};
struct Empty : BoundaryPolygon {
  double solid_area() const { return 0; }
};
struct LosesAll : BoundaryPolygon {
  std::size_t lost() const { return 1; }
};
struct LosesNone : BoundaryPolygon {
  std::size_t lost() const { return 0; }
};
struct FullAxes : BoundaryPolygon {
  // As of the sides of a rectangle of the same area, whichever axis was shortened.
  Vec2 semi_axes() const { return Vec2{0.5, 0.5} * std::sqrt(area()); }
};

}  // namespace

TEST_CASE("the boundaries of riprap obey the axioms about their assemblies") {
  CHECK(to_text(boundary_violations(StrainField{}, ring)) == "");
  CHECK(to_text(boundary_violations(RigidPlatens{}, box)) == "");
  Assembly rough = box;
  for (PlacedParticle& p : rough.particles)
    if (p.motion == Motion::platen) p.motion = Motion::wall;
  CHECK(to_text(boundary_violations(RigidPlatens{}, rough)) == "");
  CHECK(to_text(boundary_violations(PeriodicCell{}, cell)) == "");
  for (const Assembly& any : {ring, box, cell})
    CHECK(to_text(boundary_violations(NoBoundary{}, any)) == "");
}

TEST_CASE("users' boundaries obey the axioms") {
  CHECK(to_text(boundary_violations(ShakingTable{}, box)) == "");
  CHECK(to_text(boundary_violations(ExponentialField{}, ring)) == "");
  CHECK(to_text(boundary_violations(test::archetype::Boundary{1}, ring)) == "");
  CHECK(to_text(boundary_violations(test::archetype::SampleBoundary{1}, ring)) == "");
}

TEST_CASE("a boundary that changes other bodies than its own is reported") {
  check_violated(violations_of([](Body& b) { b.velocity *= 0.999; }),
                 "drive leaves free bodies alone");
  check_violated(violations_of([](Body& b) { b.angular_velocity = 0; }),
                 "drive leaves free bodies alone");
  check_violated(violations_of([](Body& b) { b.position += 1e-5 * b.velocity; }),
                 "drive moves no body itself");
  check_violated(violations_of([](Body& b) { b.rotation = b.rotation.turned(1e-9); }),
                 "drive moves no body itself");
  check_violated(violations_of([](Body& b) {
                   if (b.is_free()) b.motion = Motion::prescribed;
                 }),
                 "a body stays what it is");
  check_violated(violations_of([](Body& b) { b.mass *= 2; }), "a body stays what it is");
  check_violated(boundary_violations(AddsBodies{}, ring),
                 "drive neither adds bodies nor takes any away");
}

TEST_CASE("a boundary that strains at other rates than were set is reported") {
  const Violations swapped = boundary_violations(SwappedAxes{}, ring);
  check_violated(swapped, "axis 1 shortens at its rate");
  check_violated(swapped, "axis 2 shortens at its rate");
  check_violated(boundary_violations(WrongSign{}, ring),
                 "the area shrinks at the sum of the rates");
  check_violated(boundary_violations(StiffCell{}, cell),
                 "the area shrinks at the sum of the rates");
  check_violated(violations_of([](Body& b) {
                   if (!b.is_free()) b.velocity *= 1.001;
                 }),
                 "the area shrinks at the sum of the rates");
  // Nothing moves at rate zero.
  const Violations creep = violations_of([](Body& b) {
    if (!b.is_free()) b.velocity -= 1e-6 * b.position;
  });
  check_violated(creep, "the area shrinks at the sum of the rates");
  check_violated(boundary_violations(Measured<FullAxes>{}, ring), "axis 1 shortens at its rate");
}

TEST_CASE("a cell whose images move otherwise than it says is reported") {
  check_violated(boundary_violations(StiffCell{}, cell),
                 "an image moves at the velocity of its domain");
  check_violated(boundary_violations(ContraryCell{}, cell),
                 "an image moves at the velocity of its domain");
  check_violated(boundary_violations(TensorCell{}, cell), "simple shear has the rate that was set");
}

TEST_CASE("a boundary that measures its region wrongly is reported") {
  check_violated(boundary_violations(Measured<Whole>{}, ring),
                 "the solid area is no more than that of the region");
  check_violated(boundary_violations(Measured<Empty>{}, ring),
                 "the solid area in the region is above 0");
  check_violated(boundary_violations(Measured<LosesAll>{}, ring), "what lies inside is not lost");
  check_violated(boundary_violations(Measured<LosesNone>{}, ring),
                 "a free particle far away is lost");
}
