// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/modified_griffith.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

struct Row {
  double minor;
  double major;
};

}  // namespace

TEST_CASE("circles of modified Griffith rock at failure touch the two-part envelope") {
  // The least circle that meets tau^2 = 4 T (T + sigma) at sigma <= 0 or tau = 2 T + f sigma at
  // sigma >= 0: bisection over distances in 30 digits; half a unit of the last printed digit.
  const ModifiedGriffith smooth;
  for (const Row& row : {Row{-11, 50.8564065}, Row{-6, 80.9116882}, Row{0, 115.882251},
                         Row{5, 145.024387}, Row{10, 174.166522}, Row{50, 407.303607}}) {
    CAPTURE(row.minor);
    CHECK(smooth.major_stress_at_failure(row.minor * 1e6) == near_relative(row.major * 1e6, 5e-9));
  }
  // On the parabola, and then, long before it ends, on the line.
  const ModifiedGriffith cornered{.friction = 0.5};
  for (const Row& row : {Row{-11.5, 46.297959}, Row{-11, 48.8672576}, Row{-9, 54.1033256},
                         Row{-6, 61.9574275}, Row{0, 77.6656315}, Row{50, 208.567331}}) {
    CAPTURE(row.minor);
    CHECK(cornered.major_stress_at_failure(row.minor * 1e6) ==
          near_relative(row.major * 1e6, 5e-9));
  }
}

TEST_CASE("closed cracks slide as McClintock and Walsh have it") {
  for (const double f : {0.1, 0.5, 1.0}) {
    const ModifiedGriffith rock{.tension = 9_MPa, .friction = f};
    const double w = std::sqrt(1 + f * f);
    CHECK(rock.tensile_strength() == 9_MPa);
    CHECK(rock.major_stress_at_failure(0) == near_relative(4 * 9_MPa * (w + f), 1e-14));
    for (const double minor : {0_MPa, 3_MPa, 60_MPa}) {
      const double major = rock.major_stress_at_failure(minor);
      CHECK(major * (w - f) - minor * (w + f) == near_relative(4 * 9_MPa, 1e-13));
      CHECK(rock.friction_angle(minor) == std::atan(f));
    }
  }
}

TEST_CASE("open cracks grow as Griffith has it") {
  for (const double f : {0.1, 0.5, 1.0}) {
    const ModifiedGriffith rock{.friction = f};
    for (const double minor : {-12_MPa, -11.99_MPa}) {
      CHECK(rock.major_stress_at_failure(minor) == Griffith{}.major_stress_at_failure(minor));
      CHECK(rock.friction_angle(minor) == Griffith{}.friction_angle(minor));
    }
  }
}

TEST_CASE("with a friction of 1 curve and angle are continuous where cracks close") {
  const ModifiedGriffith rock;
  const double closing = -2 * 12_MPa / (1 + std::numbers::sqrt2);
  const double step = 1e-9 * 12_MPa;
  // sigma_1 = -T^2 4 / sigma_3 on the circle through (0, 2 T); slope 5.8 times the step.
  CHECK(rock.major_stress_at_failure(closing - step) ==
        near(-4 * 12_MPa * 12_MPa / closing, 6 * step));
  CHECK(rock.major_stress_at_failure(closing + step) ==
        near(-4 * 12_MPa * 12_MPa / closing, 6 * step));
  CHECK(rock.friction_angle(closing - step) == near(45_deg, 1e-8));
  CHECK(rock.friction_angle(closing + step) == 45_deg);
}

TEST_CASE("modified Griffith curves obey the axioms in any units") {
  CHECK(to_text(criterion_violations(ModifiedGriffith{}, 4 * 12_MPa * (1 + std::sqrt(2.0)))) == "");
  CHECK(to_text(criterion_violations(ModifiedGriffith{.friction = 0.5})) == "");
  CHECK(to_text(criterion_violations(ModifiedGriffith{.friction = 0.01})) == "");
  CHECK(to_text(criterion_unit_violations(ModifiedGriffith{.friction = 0.5},
                                          ModifiedGriffith{.tension = 12, .friction = 0.5})) == "");
}

TEST_CASE("modified Griffith parameters that break a rule are named") {
  const auto message = [](const ModifiedGriffith& rock) {
    return test::message_of([&] { rock.validate(); });
  };
  CHECK(message({}).empty());
  CHECK(message({.tension = -2}) ==
        "ModifiedGriffith.tension = -2: must be a finite number above 0");
  CHECK(message({.friction = 0}).starts_with("ModifiedGriffith.friction = 0: must lie in (0, 1]"));
  CHECK(message({.friction = 1.5}).starts_with("ModifiedGriffith.friction = 1.5: must lie in"));
}
