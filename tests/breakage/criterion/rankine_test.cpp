// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/rankine.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/core/units.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;

static_assert(!never_fails<Rankine>);

TEST_CASE("Rankine rock fails in tension alone") {
  const Rankine rock{.tension = 8_MPa};
  const ElementFailure torn = evaluate(rock, Stress2{0, -10_MPa, 0});
  CHECK(torn.mode == FailureMode::tension);
  CHECK(torn.safety_factor == near(0.8, 1e-15));
  CHECK(evaluate(rock, Stress2{900_MPa, -8_MPa, 0}).mode == FailureMode::tension);
  CHECK_FALSE(evaluate(rock, Stress2{0, -7.999_MPa, 0}).failed());
  for (const double major : {0.0, 1_MPa, 1e30}) {
    const ElementFailure pressed = evaluate(rock, Stress2{major, -1_MPa, 0});
    CHECK_FALSE(pressed.failed());
    CHECK(std::isinf(pressed.safety_factor));
    CHECK(pressed.weight() == 0);
  }
}

TEST_CASE("pure shear tears Rankine rock when it reaches the tensile strength") {
  CHECK(evaluate(Rankine{.tension = 8_MPa}, Stress2{0, 0, 8.001_MPa}).failed());
  CHECK_FALSE(evaluate(Rankine{.tension = 8_MPa}, Stress2{0, 0, 7.999_MPa}).failed());
}

TEST_CASE("the default Rankine rock has the tensile strength of the default Hoek-Brown rock") {
  CHECK(Rankine{}.tensile_strength() == near(HoekBrown{}.tensile_strength(), 1e-8));
}

TEST_CASE("the tensile strength of Rankine rock must be a positive number") {
  CHECK_NOTHROW(Rankine{}.validate());
  CHECK_THROWS_WITH_AS(Rankine{.tension = 0}.validate(),
                       "Rankine.tension = 0: must be a finite number above 0", InvalidInput);
}
