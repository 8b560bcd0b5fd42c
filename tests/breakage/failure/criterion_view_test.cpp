// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/failure/criterion_view.hpp>

#include <doctest/doctest.h>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>

using namespace riprap;

TEST_CASE("a view has the strength, the modes and the planes of the criterion behind it") {
  const auto check = [](const auto& criterion) {
    const CriterionView view{criterion};
    CHECK(view.tensile_strength() == criterion.tensile_strength());
    for (const Stress2& stress :
         {Stress2{-1e9, 0, 1e5}, Stress2{5e8, 1e6, -2e7}, Stress2{1e3, 2e3, 0}}) {
      const ElementFailure failure = evaluate(criterion, stress);
      CHECK(view.evaluate(stress).mode == failure.mode);
      CHECK(view.evaluate(stress).safety_factor == failure.safety_factor);
      const FailurePlanes planes = failure_planes(criterion, stress, failure.mode);
      const FailurePlanes seen = view.failure_planes(stress, failure.mode);
      REQUIRE(seen.count == planes.count);
      for (std::size_t k = 0; k < planes.count; ++k)
        CHECK(seen.directions[k] == planes.directions[k]);
    }
  };
  check(HoekBrown{});
  check(MohrCoulomb{});
}
