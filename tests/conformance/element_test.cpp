// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/element.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>

using namespace riprap;
using test::check_violated;

namespace {

using Corners = std::array<Vec2, 3>;

double area_of(const Corners& corners) {
  return 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
}

struct LumpedTriangle : ConstantStrainTriangle {
  NodalMass<3> mass(const Corners& corners) const {
    return area_of(corners) / 3 * NodalMass<3>::Identity();
  }
};

template <class Change>
struct AlteredStrain : ConstantStrainTriangle {
  Change change;
  StrainDisplacement<3> strain_displacement(const Corners& corners, const Barycentric&) const {
    StrainDisplacement<3> b = ConstantStrainTriangle::strain_displacement(corners);
    change(b);
    return b;
  }
};
template <class Change>
Violations with_strain(Change change) {
  return element_violations(AlteredStrain<Change>{{}, change});
}

template <class Change>
struct AlteredMass : ConstantStrainTriangle {
  Change change;
  NodalMass<3> mass(const Corners& corners) const {
    NodalMass<3> m = ConstantStrainTriangle::mass(corners);
    change(m);
    return m;
  }
};
template <class Change>
Violations with_mass(Change change) {
  return element_violations(AlteredMass<Change>{{}, change});
}

struct Hourglass : LinearStrainTriangle {
  static constexpr auto integration_points = centroid_rule;
};

}  // namespace

TEST_CASE("the elements of riprap obey the axioms") {
  CHECK(to_text(element_violations(LinearStrainTriangle{})) == "");
  CHECK(to_text(element_violations(LinearStrainTriangle{}, 10)) == "");
  CHECK(to_text(element_violations(ConstantStrainTriangle{})) == "");
  CHECK(to_text(element_violations(ConstantStrainTriangle{}, 10)) == "");
}

TEST_CASE("a user's element obeys the axioms") {
  CHECK(to_text(element_violations(LumpedTriangle{})) == "");
}

TEST_CASE("an element that is strained by rigid motion is reported") {
  check_violated(with_strain([](auto& b) { b(0, 0) *= 1.001; }), "a shift causes no strain");
  // The shear of the one direction without that of the other.
  check_violated(with_strain([](auto& b) { b(2, 0) = b(2, 2) = b(2, 4) = 0; }),
                 "a small turn causes no strain");
}

TEST_CASE("an element with the wrong strain is reported") {
  check_violated(with_strain([](auto& b) { b.row(2) *= 0.5; }),
                 "linear displacements have their uniform strain");
}

TEST_CASE("an element with too few integration points is reported") {
  check_violated(element_violations(Hourglass{}),
                 "only rigid motions cost no energy: smallest eigenvalue but three");
}

TEST_CASE("an element that is wrong at one of its sampling points is reported") {
  struct Bent : LinearStrainTriangle {
    StrainDisplacement<6> strain_displacement(const Corners& corners, const Barycentric& at) const {
      return (at[2] > 0.5 ? 1.001 : 1.0) * LinearStrainTriangle::strain_displacement(corners, at);
    }
  };
  check_violated(element_violations(Bent{}), "linear displacements have their uniform strain");
}

TEST_CASE("an element with the wrong mass is reported") {
  check_violated(with_mass([](auto& m) { m *= 1.001; }), "the mass matrix sums to the area");
  check_violated(with_mass([](auto& m) { m(0, 1) *= 1.001; }), "the mass matrix is symmetric");
  check_violated(with_mass([](auto& m) {
                   const double sum = m.sum();
                   m.setZero();
                   m.diagonal() << 0.5 * sum, 0.25 * sum, 0.25 * sum;
                 }),
                 "a uniform load acts at the centroid");
  check_violated(with_mass([](auto& m) { m.setConstant(m.sum() / 9); }),
                 "the mass matrix is positive definite: smallest eigenvalue");
}
