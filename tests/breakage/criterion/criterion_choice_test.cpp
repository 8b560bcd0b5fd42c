// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/criterion_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/criterion/franklin.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/units.hpp>

using namespace riprap;

namespace {

using Choice = CriterionChoice<HoekBrown, MohrCoulomb, Franklin, NeverFails>;

static_assert(Criterion<Choice>);
// The choice is made at run time, so the stress analysis must be compiled in.
static_assert(!never_fails<Choice>);

template <class C>
void check_same(const C& criterion) {
  const Choice choice{criterion};
  CHECK(choice.tensile_strength() == criterion.tensile_strength());
  for (const double minor : {-20_MPa, -11.99_MPa, -6_MPa, 0_MPa, 3_MPa, 77_MPa}) {
    CHECK(choice.major_stress_at_failure(minor) == criterion.major_stress_at_failure(minor));
    CHECK(choice.friction_angle(minor) == friction_angle(criterion, minor));
    const Stress2 stress{minor, minor + 310_MPa, 4_MPa};
    CHECK(evaluate(choice, stress).mode == evaluate(criterion, stress).mode);
    CHECK(evaluate(choice, stress).safety_factor == evaluate(criterion, stress).safety_factor);
  }
}

}  // namespace

TEST_CASE("a chosen criterion gives the same bits as the criterion itself") {
  check_same(HoekBrown{});
  check_same(HoekBrown{.s = 0.4, .a_b = 0.6, .angle = HoekBrown::Angle::tangent});
  check_same(MohrCoulomb{.cohesion = 20_MPa, .angle = 40_deg, .tension = 8_MPa});
  check_same(Franklin{.exponent = 0.75});
}

TEST_CASE("nothing fails where it was chosen that nothing fails") {
  const Choice choice{NeverFails{}};
  CHECK_FALSE(evaluate(choice, Stress2{1e15, -1e15, 0}).failed());
}

TEST_CASE("a choice validates the chosen criterion") {
  CHECK_NOTHROW(Choice{NeverFails{}}.validate());
  CHECK_THROWS_WITH_AS(Choice{HoekBrown{.m_b = -1}}.validate(),
                       "HoekBrown.m_b = -1: must be a finite number above 0", InvalidInput);
}
