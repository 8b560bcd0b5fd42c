// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/claims.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <support/message_of.hpp>

#include <paper/made_up_study.hpp>

using report::Claim;
using report::Mode;
using report::Verdict;
using riprap::test::contains;
using riprap::test::made_up_study;
using riprap::test::World;

namespace {

Claim claim(const std::vector<Claim>& claims, const std::string& id) {
  for (const Claim& c : claims)
    if (c.statement.id == id) return c;
  FAIL("no claim " << id);
  return {};
}

}  // namespace

TEST_CASE("where all is as the paper has it, every claim holds") {
  const auto results = made_up_study({.as_claimed = true});
  for (const Claim& c : report::judge_claims(results)) {
    CAPTURE(c.statement.id);
    CAPTURE(c.reason);
    CHECK(to_text(c.verdict) == "holds");
  }
}

TEST_CASE("where all is the other way, no claim holds") {
  const auto results = made_up_study({.as_claimed = false});
  for (const Claim& c : report::judge_claims(results)) {
    CAPTURE(c.statement.id);
    CAPTURE(c.reason);
    // Where no particle reaches RatF, contrary to another claim, none can be left whole.
    if (c.statement.id == "crushed_above_ratf")
      CHECK(to_text(c.verdict) == "not judged");
    else
      CHECK(to_text(c.verdict) == "does not hold");
    CHECK_FALSE(contains(c.reason, "as claimed"));
  }
}

TEST_CASE("particles that stay whole above RatF are found") {
  auto results = made_up_study({});
  for (auto& run : results.runs)
    for (int i = 0; i < 3; ++i) run.rat_at_shear_start[static_cast<std::size_t>(i)] = 0.4;
  const auto claims = report::judge_claims(results);
  CHECK(claim(claims, "crushed_above_ratf").verdict == Verdict::does_not_hold);
}

TEST_CASE("some particles at RatF are not many") {
  auto results = made_up_study({.as_claimed = false});
  for (auto& run : results.runs)
    for (int i = 0; i < 4; ++i) run.rat_at_shear_start[static_cast<std::size_t>(i)] = 0.45;
  const auto claims = report::judge_claims(results);
  CHECK(claim(claims, "rat_at_start_of_shear").verdict == Verdict::holds_in_part);
  // The sixth in a hundred makes them many.
  for (auto& run : results.runs) run.rat_at_shear_start[4] = run.rat_at_shear_start[5] = 0.4;
  CHECK(claim(report::judge_claims(results), "rat_at_start_of_shear").verdict == Verdict::holds);
}

TEST_CASE("effects that appear at high pressure only are shown in the mean of all") {
  const auto claims =
      report::judge_claims(made_up_study({.as_claimed = true, .breakage_from = 3e6}));
  for (const std::string id :
       {"breakage_keeps_contacts", "breakage_lowers_dilation", "breakage_lowers_a_t"}) {
    CAPTURE(id);
    CHECK(claim(claims, id).verdict == Verdict::holds);
  }
  // "At all stress levels" has two parts.
  const Claim friction = claim(claims, "breakage_lowers_friction");
  CHECK(friction.verdict == Verdict::holds_in_part);
  CHECK(contains(friction.reason, "0.5 to 2 MPa: mean over the pressures 0.000"));
  CHECK(contains(friction.reason, "less than 0.005, which counts as none"));
  CHECK(contains(friction.reason, "4 to 14 MPa: mean over the pressures -0.0"));
  // At 2 MPa alone there is nothing left of it.
  CHECK(claim(claims, "breakage_keeps_contacts_at_2_MPa").verdict == Verdict::does_not_hold);
  // What does not ask for breakage is as it was.
  CHECK(claim(claims, "a_n_is_largest").verdict == Verdict::holds);
}

TEST_CASE("samples that differ more than the effect leave a claim open") {
  auto results = made_up_study({.samples = 4});
  for (auto& run : results.runs)
    if (run.mode == Mode::wb)
      for (double& v : run.curve["coordination_number"]) v += run.seed % 2 == 0 ? 1 : -1.2;
  const auto claims = report::judge_claims(results);
  CHECK(claim(claims, "breakage_keeps_contacts").verdict == Verdict::open);
}

TEST_CASE("runs of many particles stand beside the bands of the series") {
  auto results = made_up_study({});
  results.rows.push_back(results.runs.back());
  results.rows.back().variation = "many_particles";
  results.rows.back().particles = 5000;
  const Claim c = claim(report::judge_claims(results), "shear_bands_inclined");
  REQUIRE(c.evidence.shown_only.size() == 1);
  CHECK(c.evidence.shown_only[0].series == "WB, 5000 particles");
  CHECK(c.evidence.shown_only[0].place == "14 MPa");
  CHECK(c.evidence.parts[0].pooled.samples == 3);
}

TEST_CASE("a claim without its runs is not judged, and says what is missing") {
  auto results = made_up_study({});
  std::erase_if(results.runs,
                [](const report::Run& r) { return r.mode == Mode::wb && r.pressure == 4e6; });
  const auto claims = report::judge_claims(results);
  const Claim lost = claim(claims, "breakage_lowers_friction");
  CHECK(lost.verdict == Verdict::not_judged);
  CHECK(lost.reason == "Missing: WB less NB at 4 MPa (no sample).");
  CHECK(lost.remark.empty());
  // What needs other pressures only is still judged.
  CHECK(claim(claims, "axial_forces_larger").verdict == Verdict::holds);
  CHECK(claim(claims, "breakage_keeps_contacts_at_2_MPa").verdict == Verdict::holds);
}

TEST_CASE("one sample has no scatter to judge by") {
  for (const Claim& c : report::judge_claims(made_up_study({.samples = 1}))) {
    CAPTURE(c.statement.id);
    CHECK(c.verdict == Verdict::not_judged);
    CHECK(c.reason.starts_with("Missing: "));
  }
}

TEST_CASE("claims are distinct, and each has what a reader needs") {
  std::set<std::string> ids;
  const auto claims = report::judge_claims(made_up_study({}));
  CHECK(claims.size() >= 20);
  for (const Claim& c : claims) {
    CAPTURE(c.statement.id);
    CHECK(ids.insert(c.statement.id).second);
    CHECK_FALSE(c.statement.section.empty());
    CHECK_FALSE(c.statement.figures.empty());
    CHECK_FALSE(c.statement.text.empty());
    CHECK_FALSE(c.statement.rule.empty());
    CHECK_FALSE(c.statement.quantity.empty());
    // No finding hides another of the same name.
    const report::Json json = report::to_json(c);
    std::size_t findings = c.evidence.shown_only.size();
    for (const report::Part& part : c.evidence.parts) findings += part.findings.size();
    CHECK(json.at("numbers").size() == findings);
    CHECK(json.at("tests").size() == c.evidence.parts.size());
    CHECK(json.at("verdict") == to_text(c.verdict));
  }
}

TEST_CASE("the verdict follows from what the parts show") {
  using report::Shown;
  const auto with = [](std::vector<Shown> all) {
    report::Evidence e;
    for (const Shown shown : all) e.parts.push_back({.shown = shown});
    return e;
  };
  CHECK(verdict_of(with({Shown::effect, Shown::effect})) == Verdict::holds);
  CHECK(verdict_of(with({Shown::effect, Shown::opposite})) == Verdict::holds_in_part);
  CHECK(verdict_of(with({Shown::effect, Shown::neither})) == Verdict::holds_in_part);
  CHECK(verdict_of(with({Shown::small_effect})) == Verdict::holds_in_part);
  CHECK(verdict_of(with({Shown::neither, Shown::neither})) == Verdict::open);
  CHECK(verdict_of(with({Shown::neither, Shown::opposite})) == Verdict::does_not_hold);
  CHECK(verdict_of(with({Shown::no_effect})) == Verdict::does_not_hold);
  CHECK(verdict_of(with({})) == Verdict::not_judged);
  report::Evidence e = with({Shown::effect});
  e.parts[0].contradicted = true;
  CHECK(verdict_of(e) == Verdict::holds_in_part);
  e.parts[0].missing.push_back("WB");
  CHECK(verdict_of(e) == Verdict::not_judged);
}

TEST_CASE("numbers are shown with two figures of their standard error") {
  CHECK(report::number_text({0.12345, 0.0123, 3}) == "0.123 ± 0.012");
  CHECK(report::number_text({-551.2, 33.3, 3}) == "-551 ± 33");
  CHECK(report::number_text({0.5, std::nan(""), 1}) == "0.500");
}
