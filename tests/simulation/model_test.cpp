// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <type_traits>

using namespace riprap;

namespace {

// A shipped policy whose parameters are never right.
template <class P>
struct Refused : P {
  void validate() const { throw InvalidInput("refused"); }
};

}  // namespace

TEST_CASE("a setter exchanges one policy and keeps the others with their settings") {
  const auto first = Model{}
                         .contact_law(LinearSpringCoulomb{.friction = 0.25})
                         .trigger(FailedElementRatio{.critical = 0.3})
                         .mesher(UniformMesher{.triangles = 60})
                         .check_every(7);
  const auto second = first.criterion(MohrCoulomb{.tension = 10e6});
  static_assert(std::is_same_v<decltype(second.breakage_model.criterion), MohrCoulomb>);
  static_assert(std::is_same_v<decltype(second.contact_model), decltype(first.contact_model)>);
  static_assert(std::is_same_v<decltype(second.motion_model), decltype(first.motion_model)>);
  static_assert(std::is_same_v<decltype(second.stress_model), decltype(first.stress_model)>);
  CHECK(second.contact_model.law.friction == 0.25);
  CHECK(second.breakage_model.trigger.critical == 0.3);
  CHECK(second.breakage_model.criterion.tension == 10e6);
  CHECK(second.stress_model.mesher.triangles == 60);
  CHECK(second.breakage_model.check_every == 7);
}

TEST_CASE("every setter puts its policy in its place") {
  const auto model = Model{}
                         .broad_phase(UniformGrid{.relative_skin = 0.2})
                         .narrow_phase(OverlapChord{})
                         .integrator(SymplecticEuler{})
                         .damping(NoDamping{})
                         .time_step(MassFloor{.fraction = 0.05})
                         .boundary(NoBoundary{})
                         .element(ConstantStrainTriangle{})
                         .plane_state(PlaneStrain{})
                         .support(TwoPinnedContacts{})
                         .line_fit(WeightedX{})
                         .splitter(StraightCut{.maximum_aspect = 5})
                         .inheritance(RigidField{});
  CHECK(model.contact_model.broad_phase.relative_skin == 0.2);
  CHECK(model.motion_model.time_step.fraction == 0.05);
  CHECK(model.breakage_model.splitter.maximum_aspect == 5);
  static_assert(std::is_same_v<decltype(model.motion_model.damping), NoDamping>);
  static_assert(std::is_same_v<decltype(model.motion_model.boundary), NoBoundary>);
  static_assert(std::is_same_v<decltype(model.stress_model.plane_state), PlaneStrain>);
  static_assert(std::is_same_v<decltype(model.stress_model.support), TwoPinnedContacts>);
  static_assert(std::is_same_v<decltype(model.breakage_model.line_fit), WeightedX>);
}

TEST_CASE("an invalid policy is named with its value and its rule") {
  CHECK_THROWS_WITH_AS(Model{}.contact_law(LinearSpringCoulomb{.friction = -0.5}).validate(),
                       "LinearSpringCoulomb.friction = -0.5: must be a finite number, 0 or above",
                       InvalidInput);
  CHECK_THROWS_WITH_AS(Model{}.damping(LocalDamping{1.5}).validate(),
                       "LocalDamping.coefficient = 1.5: must lie in [0, 1)", InvalidInput);
  CHECK_THROWS_WITH_AS(Model{}.check_every(0).validate(),
                       "Model.check_every = 0: must be 1 or more", InvalidInput);
  CHECK_THROWS_AS(Model{}.mesher(UniformMesher{.triangles = 1}).validate(), InvalidInput);
  CHECK_THROWS_AS(Model{}.criterion(HoekBrown{.m_b = 0}).validate(), InvalidInput);
  CHECK_THROWS_AS(Model{}.trigger(FailedElementRatio{-1}).validate(), InvalidInput);
  CHECK_NOTHROW(Model{}.validate());
}

TEST_CASE("the parameters of the policy of every role are validated") {
  const auto refuses = [](const auto& model) { CHECK_THROWS_AS(model.validate(), InvalidInput); };
  refuses(Model{}.broad_phase(Refused<UniformGrid>{}));
  refuses(Model{}.narrow_phase(Refused<OverlapChord>{}));
  refuses(Model{}.contact_law(Refused<LinearSpringCoulomb>{}));
  refuses(Model{}.integrator(Refused<SymplecticEuler>{}));
  refuses(Model{}.damping(Refused<LocalDamping>{}));
  refuses(Model{}.time_step(Refused<MassFloor>{}));
  refuses(Model{}.boundary(Refused<StrainField>{}));
  refuses(Model{}.mesher(Refused<UniformMesher>{}));
  refuses(Model{}.element(Refused<ConstantStrainTriangle>{}));
  refuses(Model{}.plane_state(Refused<PlaneStress>{}));
  refuses(Model{}.support(Refused<InertiaRelief>{}));
  refuses(Model{}.criterion(Refused<HoekBrown>{}));
  refuses(Model{}.trigger(Refused<FailedElementRatio>{}));
  refuses(Model{}.line_fit(Refused<WeightedXY>{}));
  refuses(Model{}.splitter(Refused<StraightCut>{}));
  refuses(Model{}.inheritance(Refused<RigidField>{}));
}
