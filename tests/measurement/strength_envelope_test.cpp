// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/strength_envelope.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near;
using test::near_relative;

namespace {

// A least-squares fit of a few logarithms below ten, raised to a power again.
constexpr double round_off = 1e-13;

const std::vector<double> stresses{0.8e6, 1.6e6, 3.1e6, 6.2e6, 12e6, 21e6};

SecantStrength on_plane(double normal_stress, double shear_stress) {
  return {std::atan(shear_stress / normal_stress), normal_stress, shear_stress};
}

/// Tests on an envelope tau = a p (sigma / p)^b with p = 1 MPa.
std::vector<SecantStrength> power_law_tests(double a, double b) {
  std::vector<SecantStrength> tests;
  for (const double s : stresses) tests.push_back(on_plane(s, a * 1e6 * std::pow(s / 1e6, b)));
  return tests;
}

}  // namespace

TEST_CASE("tests on a power law give back its two numbers") {
  const PowerLawEnvelope e = fit_power_law(power_law_tests(1.3, 0.84), 1e6);
  CHECK(e.coefficient == near_relative(1.3, round_off));
  CHECK(e.exponent == near_relative(0.84, round_off));
  CHECK(e.scatter == near(0, round_off));
  CHECK(e.shear_stress(1e6) == near_relative(1.3e6, round_off));
  CHECK(e.friction_angle(1e6) == near_relative(std::atan(1.3), round_off));
  CHECK(e.shear_stress(32e6) == near_relative(1.3e6 * std::pow(32, 0.84), round_off));
}

TEST_CASE("another reference stress gives another coefficient and the same envelope") {
  const PowerLawEnvelope e = fit_power_law(power_law_tests(1.3, 0.84));
  CHECK(e.reference == 101325);
  // tau = A p^(1-b) sigma^b, so that A p^(1-b) is common to all references.
  CHECK(e.coefficient == near_relative(1.3 * std::pow(1e6 / 101325, 0.16), round_off));
  CHECK(e.exponent == near_relative(0.84, round_off));
  CHECK(e.shear_stress(5e6) == near_relative(1.3e6 * std::pow(5, 0.84), round_off));
}

TEST_CASE("a constant friction angle has the exponent 1 and its tangent") {
  std::vector<SecantStrength> tests;
  for (const double pressure : {0.5e6, 2e6, 14e6}) tests.push_back(secant_strength(0.5, pressure));
  const PowerLawEnvelope e = fit_power_law(tests);
  CHECK(e.exponent == near_relative(1, round_off));
  CHECK(e.coefficient == near_relative(std::sqrt(1.0 / 3), round_off));
  const LogarithmicEnvelope l = fit_logarithmic_law(tests);
  CHECK(l.fall_per_decade == near(0, round_off));
  CHECK(l.angle_at_reference == near_relative(30.0_deg, round_off));
}

TEST_CASE("scatter is what the tests were moved off the envelope by") {
  // By e^0.05 up and down in pairs of equal stress: the fit stays where it was.
  std::vector<SecantStrength> tests;
  for (const SecantStrength& t : power_law_tests(1.3, 0.84))
    for (const double shift : {0.05, -0.05})
      tests.push_back(on_plane(t.normal_stress, t.shear_stress * std::exp(shift)));
  const PowerLawEnvelope e = fit_power_law(tests, 1e6);
  CHECK(e.coefficient == near_relative(1.3, round_off));
  CHECK(e.exponent == near_relative(0.84, round_off));
  CHECK(e.scatter == near_relative(0.05, round_off));

  std::vector<SecantStrength> angles;
  for (const double s : stresses)
    for (const double shift : {1.5_deg, -1.5_deg})
      angles.push_back({50.0_deg - 7.0_deg * std::log10(s / 1e5) + shift, s, 0});
  const LogarithmicEnvelope l = fit_logarithmic_law(angles, 1e5);
  CHECK(l.angle_at_reference == near_relative(50.0_deg, round_off));
  CHECK(l.fall_per_decade == near_relative(7.0_deg, round_off));
  CHECK(l.scatter == near_relative(1.5_deg, round_off));
}

TEST_CASE("tests on a logarithmic law give back its two numbers, whatever the reference") {
  std::vector<SecantStrength> tests;
  for (const double s : stresses) tests.push_back({52.0_deg - 8.5_deg * std::log10(s / 1e6), s, 1});
  const LogarithmicEnvelope e = fit_logarithmic_law(tests, 1e6);
  CHECK(e.angle_at_reference == near_relative(52.0_deg, round_off));
  CHECK(e.fall_per_decade == near_relative(8.5_deg, round_off));
  CHECK(e.friction_angle(1e7) == near_relative(43.5_deg, round_off));
  const LogarithmicEnvelope other = fit_logarithmic_law(tests, 1e5);
  CHECK(other.angle_at_reference == near_relative(60.5_deg, round_off));
  CHECK(other.friction_angle(1e7) == near_relative(43.5_deg, round_off));
}

TEST_CASE("a fit in other units of stress is the same one") {
  std::vector<SecantStrength> megapascal = power_law_tests(1.2, 0.9);
  megapascal[1].shear_stress *= 1.1;
  std::vector<SecantStrength> pascal = megapascal;
  for (SecantStrength& t : megapascal) {
    t.normal_stress *= 1e-6;
    t.shear_stress *= 1e-6;
  }
  const PowerLawEnvelope a = fit_power_law(pascal, 1e5);
  const PowerLawEnvelope b = fit_power_law(megapascal, 0.1);
  CHECK(a.coefficient == near_relative(b.coefficient, round_off));
  CHECK(a.exponent == near_relative(b.exponent, round_off));
  CHECK(a.scatter == near_relative(b.scatter, 10 * round_off));
}

TEST_CASE("what has no envelope is refused") {
  const std::vector<SecantStrength> one{secant_strength(0.5, 1e6)};
  CHECK(message_of([&] { (void)fit_power_law(one); }) ==
        "regression_line: number of points = 1: must be 2 or more");
  const std::vector<SecantStrength> weak{secant_strength(0.5, 1e6), secant_strength(0, 2e6)};
  CHECK(message_of([&] { (void)fit_power_law(weak); }) ==
        "SecantStrength.shear_stress = 0: must be a finite number above 0");
  CHECK(message_of([&] { (void)fit_power_law(one, 0); }) ==
        "reference stress = 0: must be a finite number above 0");
  CHECK(message_of([&] { (void)fit_logarithmic_law(one, -1); }) ==
        "reference stress = -1: must be a finite number above 0");
  CHECK(message_of([&] { (void)fit_logarithmic_law(std::vector<SecantStrength>(2)); }) ==
        "SecantStrength.normal_stress = 0: must be a finite number above 0");
  CHECK(message_of([] { (void)PowerLawEnvelope{}.friction_angle(0); }) ==
        "normal stress = 0: must be a finite number above 0");
  CHECK(message_of([] { (void)LogarithmicEnvelope{}.friction_angle(-1); }) ==
        "normal stress = -1: must be a finite number above 0");
}
