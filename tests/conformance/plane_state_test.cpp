// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/plane_state.hpp>
#include <riprap/stress/plane_state/plane_state_choice.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct BeddedRock {
  double ratio = 0.5;
  Eigen::Matrix3d elasticity(const Rock& rock) const {
    const double along = rock.young;
    const double across = ratio * along;
    const double nu = rock.poisson;
    const double f = 1 / (1 - nu * nu * ratio);
    const double shear = along * across / (along + across + 2 * nu * across);
    Eigen::Matrix3d d;
    d << f * along, f * nu * across, 0, f * nu * across, f * across, 0, 0, 0, shear;
    return d;
  }
  double out_of_plane_stress(const Rock&, const Stress2&) const { return 0; }
};

template <class Change>
struct Altered : PlaneStress {
  Change change;
  Eigen::Matrix3d elasticity(const Rock& rock) const {
    Eigen::Matrix3d d = PlaneStress::elasticity(rock);
    change(d, rock);
    return d;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return plane_state_violations(Altered<Change>{{}, change});
}

struct Squeezed : PlaneStress {
  double out_of_plane_stress(const Rock&, const Stress2&) const { return 1e6; }
};

/// Plane strain without the out-of-plane stress that holds the strain at zero.
struct UnheldStrain : PlaneStrain {
  double out_of_plane_stress(const Rock&, const Stress2&) const { return 0; }
};

}  // namespace

TEST_CASE("the plane states of riprap obey the axioms and Hooke's law") {
  CHECK(to_text(plane_state_violations(PlaneStress{})) == "");
  CHECK(to_text(plane_state_violations(PlaneStrain{})) == "");
  CHECK(to_text(plane_state_hooke_violations(PlaneStress{})) == "");
  CHECK(to_text(plane_state_hooke_violations(PlaneStrain{})) == "");
  using Choice = PlaneStateChoice<PlaneStress, PlaneStrain>;
  for (const Choice& chosen : {Choice{PlaneStress{}}, Choice{PlaneStrain{}}}) {
    CHECK(to_text(plane_state_violations(chosen)) == "");
    CHECK(to_text(plane_state_hooke_violations(chosen)) == "");
  }
}

TEST_CASE("a user's plane state obeys the axioms, and its bedding is not isotropic") {
  CHECK(to_text(plane_state_violations(BeddedRock{})) == "");
  check_violated(plane_state_hooke_violations(BeddedRock{}),
                 "strains are those of Hooke's law: difference");
  CHECK(to_text(plane_state_hooke_violations(BeddedRock{.ratio = 1})) == "");
}

TEST_CASE("a plane state without an energy is reported") {
  check_violated(violations_of([](auto& d, const Rock&) { d(0, 1) *= 1.001; }),
                 "elasticity is symmetric");
  check_violated(violations_of([](auto& d, const Rock&) { d(2, 2) = -d(2, 2); }),
                 "strain stores energy: smallest eigenvalue over Young's modulus");
}

TEST_CASE("a plane state with a modulus of its own is reported") {
  check_violated(violations_of([](auto& d, const Rock&) { d(2, 2) += 1e3; }),
                 "elasticity is proportional to Young's modulus");
}

TEST_CASE("a plane state with the wrong stress out of the plane is reported") {
  check_violated(plane_state_violations(Squeezed{}),
                 "the out-of-plane stress is proportional to the stress in the plane");
  check_violated(plane_state_hooke_violations(UnheldStrain{}),
                 "strains are those of Hooke's law: difference");
}
