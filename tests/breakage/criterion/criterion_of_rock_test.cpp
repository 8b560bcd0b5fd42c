// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/criterion_of_rock.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/criterion/three_principal_stresses.hpp>
#include <riprap/breakage/line_fit/mean_stress_failure_plane.hpp>
#include <riprap/breakage/trigger/mean_stress_failure.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/experiment/brazilian_test.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/breakage_passes.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/same_run.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

using HoekBrowns = CriterionOfRock<HoekBrown>;
using Choice = CriterionChoice<HoekBrown, MohrCoulomb>;
static_assert(MaterialCriterion<HoekBrowns> && !MaterialCriterion<HoekBrown>);
static_assert(MaterialCriterion<CriterionOfRock<Choice>>);
static_assert(never_fails<CriterionOfRock<NeverFails>> && !never_fails<HoekBrowns>);
static_assert(OutOfPlaneCriterion<CriterionOfRock<ThreePrincipalStresses<HoekBrown>>>);

const HoekBrown weak{.compressive_strength = 3e6};
const HoekBrown strong{.compressive_strength = 3e12};
const Rocks two{Rock{}, Rock{}};

// Which of the two squares of breakage_passes.hpp break; the first one is of material 1.
template <class ModelType>
std::vector<BodyIndex> broken(const ModelType& model) {
  Assembly assembly = crushed;
  assembly.particles[0].material = 1;
  const Simulation sim{model, assembly, two};
  BreakageStage<ModelType> stage{model};
  std::vector<BodyIndex> out;
  for (const auto& [i, crack] : stage.find_cracks(model, two, sim.mean_area(), sim.particles(),
                                                  sim.contacts(), NoPhaseTimer{}))
    out.push_back(i);
  return out;
}

}  // namespace

TEST_CASE("each material has its own criterion; without a material the weakest counts") {
  const HoekBrowns criterion{{weak, HoekBrown{.compressive_strength = 4e6, .m_b = 100}}};
  CHECK(criterion.materials() == 2);
  CHECK(criterion_of(criterion, 0).compressive_strength == 3e6);
  CHECK(criterion_of(criterion, 1).m_b == 100);
  CHECK(&criterion_of(weak, 7) == &weak);
  const HoekBrown& other = criterion.criteria[1];
  CHECK(criterion.tensile_strength() == 4e4);
  for (const double minor : {-3e4, 0.0, 1e6, 1e8})
    CHECK(criterion.major_stress_at_failure(minor) ==
          std::min(weak.major_stress_at_failure(minor), other.major_stress_at_failure(minor)));
}

TEST_CASE("the particle of the weak criterion breaks, whatever asks the criterion") {
  const std::vector<BodyIndex> first{0};
  const std::vector<BodyIndex> last{3};
  const auto check = [&](const auto& model) {
    CHECK(broken(model.criterion(HoekBrowns{{strong, weak}})) == first);
    CHECK(broken(model.criterion(HoekBrowns{{weak, strong}})) == last);
    CHECK(broken(model.without_acceleration().criterion(HoekBrowns{{weak, strong}})) == last);
    const CriterionOfRock<Choice> mixed{
        {Choice{strong}, Choice{MohrCoulomb{.cohesion = 1e6, .tension = 1e4}}}};
    CHECK(broken(model.criterion(mixed)) == first);
  };
  check(Model{});
  check(Model{}.trigger(WeibullStrength{}));
  check(Model{}.trigger(MeanStressFailure{}));
  check(Model{}.trigger(MeanStressFailure{}).line_fit(MeanStressFailurePlane{}));
}

TEST_CASE("the crack is that of the particle's own criterion") {
  // Both break: each as in a simulation of that criterion alone.
  const HoekBrown other{.compressive_strength = 1e6, .m_b = 5};
  const auto model = Model{}.criterion(HoekBrowns{{weak, other}});
  Assembly assembly = crushed;
  assembly.particles[0].material = 1;
  const auto cracks_of = [&](const auto& m, const Rocks& rocks, const Assembly& from) {
    const Simulation sim{m, from, rocks};
    BreakageStage<std::remove_cvref_t<decltype(m)>> stage{m};
    return BreakagePass::Cracks(stage.find_cracks(m, sim.rocks(), sim.mean_area(), sim.particles(),
                                                  sim.contacts(), NoPhaseTimer{}));
  };
  const auto both = cracks_of(model, two, assembly);
  const auto by_weak = cracks_of(Model{}.criterion(weak), Rock{}, crushed);
  const auto by_other = cracks_of(Model{}.criterion(other), Rock{}, crushed);
  REQUIRE(both.size() == 2);
  const auto same = [](const Crack& p, const Crack& q) {
    return p.line.point == q.line.point && p.line.direction == q.line.direction &&
           p.failures.failed == q.failures.failed && p.mode == q.mode;
  };
  CHECK(same(both[0].second, by_other[0].second));
  CHECK(same(both[1].second, by_weak[1].second));
  CHECK_FALSE(same(both[0].second, by_weak[0].second));
}

TEST_CASE("equal criteria run to the same bytes as the criterion itself") {
  const auto one = run_of(Model{}, 1500);
  const auto model = Model{}.criterion(HoekBrowns{{HoekBrown{}, HoekBrown{}}});
  CHECK(same_bytes(run_of(model, 1500, two, {0, 1, 1, 0}), one));
}

TEST_CASE("the Brazilian strength of a rock is that by its own criterion and strength factor") {
  const auto model = Model{}.criterion(HoekBrowns{{HoekBrown{}, weak}});
  const BrazilianTest test;
  CHECK(test.strength(model, Rock{}, 0) == test.strength(Model{}, Rock{}));
  const double of_weak = test.strength(Model{}.criterion(weak), Rock{});
  CHECK(test.strength(model, Rock{}, 1) == of_weak);
  CHECK(test.strength(model, Rock{.strength_factor = 3}, 1) == near_relative(3 * of_weak, 1e-8));
}

TEST_CASE("a criterion that breaks a rule is named, and a number of rocks that does not fit") {
  CHECK(message_of([] { HoekBrowns{}.validate(); }) == "CriterionOfRock.criteria is empty");
  CHECK(message_of([] {
          HoekBrowns{{weak, HoekBrown{.m_b = -1}}}.validate();
        }) == "criterion of material 1: HoekBrown.m_b = -1: must be a finite number above 0");
  CHECK(message_of([] {
          Simulation sim{Model{}.criterion(HoekBrowns{{weak, weak, weak}}), crushed, two};
        }) == "criterion: number of materials = 3: must be that of the rocks, 2");
}
