// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/presets/recommended.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/preset_run.hpp>

using namespace riprap;
using test::is;

namespace {

const auto preset = presets::recommended();

}  // namespace

TEST_CASE("the recommended policies, with the limit of their mesh") {
  CHECK(is<OverlapMoments>(preset.contact_model.narrow_phase));
  CHECK(is<EnergyConservingSpring>(preset.contact_model.law));
  CHECK(is<LinearStrainTriangle>(preset.stress_model.element));
  CHECK(is<InertiaRelief>(preset.stress_model.support));
  CHECK(is<HoekBrown>(preset.breakage_model.criterion));
  CHECK(is<FailedAreaRatio>(preset.breakage_model.trigger));
  CHECK(is<MeanTensionLine>(preset.breakage_model.line_fit));
  CHECK(preset.stress_model.mesher.triangles == 50);
  // That of 200 sampling points in the table of calibrated_limit.
  CHECK(preset.breakage_model.trigger.critical == test::near_relative(0.377, 1e-12));
}

TEST_CASE("a biaxial test with the recommended policies breaks particles, screened or not") {
  const test::PresetRun run = test::run_preset(preset);
  CHECK(run.breaks > 0);
  CHECK(test::run_preset(preset.without_acceleration()).tables == run.tables);
}

TEST_CASE("with the recommended policies no result depends on what only accelerates") {
  CHECK(to_text(acceleration_violations(preset)) == "");
}
