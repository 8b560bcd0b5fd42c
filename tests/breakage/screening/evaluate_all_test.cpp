// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>

#include <doctest/doctest.h>

#include <support/breakage_passes.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct CountingCriterion : HoekBrown {
  int* evaluations = nullptr;
  [[nodiscard]] double tensile_strength() const {
    ++*evaluations;
    return HoekBrown::tensile_strength();
  }
};

}  // namespace

TEST_CASE("every loaded particle is evaluated at every check") {
  int evaluations = 0;
  CountingCriterion criterion;
  criterion.evaluations = &evaluations;
  const auto model = Model{}.criterion(criterion).screening(EvaluateAll{});
  const Simulation sim{model.contact_law(LinearSpringCoulomb{.normal_stiffness = 2e5}), crushed,
                       Rock{}};
  Pass pass(model);
  evaluations = 0;
  CHECK(pass.find(sim).empty());
  const int first = evaluations;
  CHECK(first >= 200);  // two particles of a hundred elements
  CHECK(pass.find(sim).empty());
  CHECK(evaluations == 2 * first);
}
