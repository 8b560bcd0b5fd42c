// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/plane_state/plane_stress.hpp>

#include <Eigen/LU>
#include <doctest/doctest.h>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

// Hooke's law of three dimensions, isotropic: normal stresses from normal strains.
Eigen::Vector3d hooke(const Rock& rock, const Eigen::Vector3d& strain) {
  const double shear = rock.young / (2 * (1 + rock.poisson));
  const double lame = rock.young * rock.poisson / ((1 + rock.poisson) * (1 - 2 * rock.poisson));
  return Eigen::Vector3d::Constant(lame * strain.sum()) + 2 * shear * strain;
}

}  // namespace

TEST_CASE("plane stress is Hooke's law of three dimensions with free faces") {
  for (const double poisson : {0.0, 0.17, 0.3, 0.49}) {
    const Rock rock{70e9, poisson, 2500};
    const Eigen::Vector3d in_plane{3e-4, -8e-4, 5e-4};
    // The strain out of plane that leaves the faces free: nu/(1-nu) times the sum, negative.
    const double thinning = -poisson / (1 - poisson) * (in_plane[0] + in_plane[1]);
    const Eigen::Vector3d solid = hooke(rock, {in_plane[0], in_plane[1], thinning});
    const Eigen::Vector3d plane = PlaneStress{}.elasticity(rock) * in_plane;
    const double largest = solid.cwiseAbs().maxCoeff();
    // Round-off; near nu = 1/2 Lame's constant is some 50 times larger than the result.
    CHECK(std::abs(solid[2]) <= 1e-13 * largest);
    CHECK(plane[0] == near_relative(solid[0], 1e-13));
    CHECK(plane[1] == near_relative(solid[1], 1e-13));
    CHECK(plane[2] == near_relative(rock.young / (2 * (1 + poisson)) * 5e-4, 1e-14));
  }
}

TEST_CASE("under 100 MPa rock of 70 GPa shortens by 100/70000 and widens by nu of that") {
  const Eigen::Matrix3d elasticity = PlaneStress{}.elasticity(Rock{});
  const Eigen::Vector3d strain = elasticity.inverse() * Eigen::Vector3d{0, -100e6, 0};
  CHECK(strain[1] == near_relative(-1.4285714e-3, 1e-7));  // printed digits
  CHECK(strain[0] == near_relative(2.4285714e-4, 1e-7));
  CHECK(std::abs(strain[2]) <= 1e-18);
}

TEST_CASE("no stress acts out of plane in plane stress") {
  CHECK(PlaneStress{}.out_of_plane_stress(Rock{}, {30e6, 100e6, 5e6}) == 0);
}
