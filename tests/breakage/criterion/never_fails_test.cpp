// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/never_fails.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/failure/element_failure.hpp>

using namespace riprap;

static_assert(never_fails<NeverFails>);
static_assert(!never_fails<HoekBrown>);
static_assert(!never_fails<MohrCoulomb>);

TEST_CASE("no stress makes an element fail that never fails") {
  for (const Stress2& stress : {Stress2{1e30, 0, 0}, Stress2{-1e30, -1e30, 0}, Stress2{0, 0, 0},
                                Stress2{-1e12, 1e12, 5e11}}) {
    const ElementFailure element = evaluate(NeverFails{}, stress);
    CHECK(element.mode == FailureMode::intact);
    CHECK(std::isinf(element.safety_factor));
    CHECK(element.weight() == 0);
  }
}
