// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/presets/bagherzadeh_2008.hpp>

#include <doctest/doctest.h>

#include <support/preset_run.hpp>

using namespace riprap;
using test::is;

namespace {

const auto preset = presets::bagherzadeh_2008();

}  // namespace

TEST_CASE("the paper's policies") {
  CHECK(is<OverlapChord>(preset.contact_model.narrow_phase));
  CHECK(is<LinearSpringCoulomb>(preset.contact_model.law));
  CHECK(is<ConstantStrainTriangle>(preset.stress_model.element));
  CHECK(is<PlaneStress>(preset.stress_model.plane_state));
  CHECK(is<TwoPinnedContacts>(preset.stress_model.support));
  CHECK(is<HoekBrown>(preset.breakage_model.criterion));
  CHECK(is<FailedElementRatio>(preset.breakage_model.trigger));
  CHECK(is<WeightedXY>(preset.breakage_model.line_fit));
}

TEST_CASE("Table 1") {
  CHECK(preset.contact_model.law.normal_stiffness == 2e7);
  CHECK(preset.contact_model.law.tangential_stiffness == 2e7);
  CHECK(preset.contact_model.law.friction == 0.5);
  const HoekBrown& criterion = preset.breakage_model.criterion;
  CHECK(criterion.compressive_strength == 300e6);
  CHECK(criterion.m_b == 25);
  CHECK(criterion.s == 1);
  CHECK(criterion.a_b == 0.5);
  CHECK(preset.breakage_model.trigger.critical == 0.4);
  CHECK(Rock{}.density == 2500);
  CHECK(Rock{}.young == 7e10);
  CHECK(Rock{}.poisson == 0.17);
}

TEST_CASE("a biaxial test with the paper's policies breaks particles, the same without caches") {
  const test::PresetRun run = test::run_preset(preset);
  CHECK(run.breaks > 0);
  CHECK(test::run_preset(preset.without_acceleration()).tables == run.tables);
}

TEST_CASE("with the paper's policies no result depends on what only accelerates") {
  CHECK(to_text(acceleration_violations(preset)) == "");
}
