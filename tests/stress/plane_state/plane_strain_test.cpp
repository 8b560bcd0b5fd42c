// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/plane_state/plane_strain.hpp>

#include <Eigen/LU>
#include <doctest/doctest.h>

#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("plane strain is Hooke's law of three dimensions with no strain out of plane") {
  for (const double poisson : {0.0, 0.17, 0.3, 0.49}) {
    const Rock rock{70e9, poisson, 2500};
    const double shear = rock.young / (2 * (1 + poisson));
    const double lame = rock.young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const Eigen::Vector3d strain{3e-4, -8e-4, 5e-4};
    const double volume = lame * (strain[0] + strain[1]);
    const Eigen::Vector3d stress = PlaneStrain{}.elasticity(rock) * strain;
    // Round-off, times 50 near nu = 1/2 where 1 - 2 nu loses digits.
    CHECK(stress[0] == near_relative(volume + 2 * shear * strain[0], 1e-13));
    CHECK(stress[1] == near_relative(volume + 2 * shear * strain[1], 1e-13));
    CHECK(stress[2] == near_relative(shear * strain[2], 1e-13));
    // Lame's term alone acts out of plane, whatever the sign that stress is counted with.
    const Stress2 tension{stress[0], stress[1], stress[2]};
    CHECK(PlaneStrain{}.out_of_plane_stress(rock, tension) == near_relative(volume, 1e-13));
    CHECK(PlaneStrain{}.out_of_plane_stress(rock, -1.0 * tension) == near_relative(-volume, 1e-13));
  }
}

TEST_CASE("100 MPa along axis 2 cause 17 MPa out of plane in rock with Poisson's ratio 0.17") {
  const Eigen::Matrix3d elasticity = PlaneStrain{}.elasticity(Rock{});
  const Eigen::Vector3d strain = elasticity.inverse() * Eigen::Vector3d{0, -100e6, 0};
  CHECK(strain[1] == near_relative(-1.3872857e-3, 1e-7));  // printed digits
  CHECK(strain[0] == near_relative(2.8414286e-4, 1e-7));
  CHECK(PlaneStrain{}.out_of_plane_stress(Rock{}, {0, 100e6, 0}) == near_relative(17e6, 1e-14));
}

TEST_CASE("plane strain is plane stress with E/(1-nu^2) and nu/(1-nu)") {
  for (const double poisson : {0.0, 0.17, 0.3}) {
    const Rock rock{70e9, poisson, 2500};
    const Rock substitute{70e9 / (1 - poisson * poisson), poisson / (1 - poisson), 2500};
    const Eigen::Matrix3d strain = PlaneStrain{}.elasticity(rock);
    const Eigen::Matrix3d stress = PlaneStress{}.elasticity(substitute);
    CHECK((strain - stress).norm() <= 1e-14 * strain.norm());  // round-off
  }
}
