// SPDX-License-Identifier: BSL-1.0
#pragma once
// One specimen of rock between platens, as the options describe it.

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/experiment/unconfined_compression.hpp>
#include <riprap/stress/plane_state/plane_state_choice.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>

namespace unconfined {

using ChosenCriterion = riprap::CriterionChoice<riprap::HoekBrown, riprap::MohrCoulomb>;

struct Options {
  double width = 0.054;
  double aspect = 2;  // height over width
  double poisson = 0.17;
  double young = 70e9;
  double strength = 300e6;
  double m_b = 25;
  double friction = std::numeric_limits<double>::infinity();  // rough
  double load = 1;                                            // platen stress over strength
  unsigned triangles = 5000;
  std::string criterion = "hoek-brown";
  std::string plane = "stress";
  std::string out = "unconfined";
};

// Mohr-Coulomb is the straight line with the compressive and the tensile strength of Hoek-Brown, at
// its angle of eq. 7 for sigma_3 = 0.
inline ChosenCriterion criterion_of(const Options& o) {
  const riprap::HoekBrown curve{.compressive_strength = o.strength, .m_b = o.m_b};
  if (o.criterion == "hoek-brown") return {curve};
  curve.validate();
  const double angle = curve.friction_angle(0);
  return {
      riprap::MohrCoulomb{.cohesion = 0.5 * o.strength * (1 - std::sin(angle)) / std::cos(angle),
                          .angle = angle,
                          .tension = curve.tensile_strength()}};
}

// Throws InvalidInput for an option that breaks a rule.
inline riprap::UnconfinedResult test(const Options& o) {
  riprap::require_positive("--aspect", o.aspect);
  const riprap::UnconfinedCompression test{
      .width = o.width, .height = o.aspect * o.width, .friction = o.friction, .load = o.load};
  riprap::PlaneStateChoice<riprap::PlaneStress, riprap::PlaneStrain> plane;
  if (o.plane == "strain") plane.chosen = riprap::PlaneStrain{};
  return test.run(riprap::Rock{.young = o.young, .poisson = o.poisson}, criterion_of(o),
                  riprap::UniformMesher{o.triangles}, plane);
}

}  // namespace unconfined
