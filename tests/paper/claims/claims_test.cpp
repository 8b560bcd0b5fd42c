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
  const auto results = made_up_study({.as_claimed = true}, true);
  for (const Mode mode : {Mode::wb, Mode::pinned})
    for (const Claim& c : report::judge_claims(results, mode)) {
      CAPTURE(c.statement.id);
      CAPTURE(c.reason);
      CHECK(to_text(c.verdict) == "holds");
    }
}

TEST_CASE("where all is the other way, no claim holds") {
  const auto results = made_up_study({.as_claimed = false});
  for (const Claim& c : report::judge_claims(results, Mode::wb)) {
    CAPTURE(c.statement.id);
    CAPTURE(c.reason);
    // Where no particle reaches RatF, contrary to another claim, none can be left whole.
    if (c.statement.id == "crushed_above_ratf")
      CHECK(to_text(c.verdict) == "not judged");
    else
      CHECK(to_text(c.verdict) == "does not hold");
    CHECK_FALSE((c.verdict == Verdict::does_not_hold && contains(c.reason, "As claimed")));
  }
}

TEST_CASE("particles that stay whole above RatF are found") {
  auto results = made_up_study({});
  for (auto& run : results.runs)
    for (int i = 0; i < 3; ++i) run.rat_at_shear_start[static_cast<std::size_t>(i)] = 0.4;
  const auto claims = report::judge_claims(results, Mode::wb);
  CHECK(claim(claims, "crushed_above_ratf").verdict == Verdict::does_not_hold);
}

TEST_CASE("some particles at RatF are not many") {
  auto results = made_up_study({.as_claimed = false});
  for (auto& run : results.runs)
    for (int i = 0; i < 4; ++i) run.rat_at_shear_start[static_cast<std::size_t>(i)] = 0.45;
  const auto claims = report::judge_claims(results, Mode::wb);
  CHECK(claim(claims, "rat_at_start_of_shear").verdict == Verdict::holds_in_part);
  // The fifth in a hundred makes them many.
  for (auto& run : results.runs) run.rat_at_shear_start[4] = 0.4;
  CHECK(claim(report::judge_claims(results, Mode::wb), "rat_at_start_of_shear").verdict ==
        Verdict::holds);
}

TEST_CASE("effects that appear at high pressure only hold in part, and the reason says where") {
  const auto claims =
      report::judge_claims(made_up_study({.as_claimed = true, .breakage_from = 3e6}), Mode::wb);
  for (const std::string id : {"breakage_keeps_contacts", "breakage_lowers_dilation",
                               "breakage_lowers_a_t", "breakage_lowers_friction"}) {
    CAPTURE(id);
    const Claim c = claim(claims, id);
    CHECK(c.verdict == Verdict::holds_in_part);
    CHECK(contains(c.reason, "As claimed: WB less NB at 4 MPa, 8 MPa, 14 MPa."));
    CHECK(contains(c.reason, "Not clear: WB less NB at 0.5 MPa, 1 MPa, 2 MPa."));
  }
  // At 2 MPa alone there is nothing left of it.
  CHECK(claim(claims, "breakage_keeps_contacts_at_2_MPa").verdict == Verdict::does_not_hold);
  // What does not ask for breakage is as it was.
  CHECK(claim(claims, "a_n_is_largest").verdict == Verdict::holds);
}

TEST_CASE("a claim without its runs is not judged, and says what is missing") {
  auto results = made_up_study({});
  std::erase_if(results.runs,
                [](const report::Run& r) { return r.mode == Mode::wb && r.pressure == 4e6; });
  const auto claims = report::judge_claims(results, Mode::wb);
  const Claim lost = claim(claims, "breakage_lowers_friction");
  CHECK(lost.verdict == Verdict::not_judged);
  CHECK(lost.reason == "Missing: WB less NB at 4 MPa (no sample).");
  CHECK(lost.remark.empty());
  // What needs other pressures only is still judged.
  CHECK(claim(claims, "axial_forces_larger").verdict == Verdict::holds);
  CHECK(claim(claims, "breakage_keeps_contacts_at_2_MPa").verdict == Verdict::holds);
}

TEST_CASE("one sample has no scatter to judge by") {
  for (const Claim& c : report::judge_claims(made_up_study({.samples = 1}), Mode::wb)) {
    CAPTURE(c.statement.id);
    // Correlation is over all pressures.
    if (c.statement.id == "dilation_goes_with_loss_of_contacts") continue;
    CHECK(c.verdict == Verdict::not_judged);
    CHECK(c.reason.starts_with("Missing: "));
  }
}

TEST_CASE("claims are distinct, and each has what a reader needs") {
  std::set<std::string> ids;
  const auto claims = report::judge_claims(made_up_study({}), Mode::wb);
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
    CHECK(json.at("numbers").size() == c.evidence.findings.size());
    CHECK(json.at("verdict") == to_text(c.verdict));
  }
}

TEST_CASE("the verdict depends on the findings that count, and on nothing else") {
  using report::Finding;
  using report::Outcome;
  const auto with = [](std::vector<Outcome> outcomes) {
    report::Evidence e;
    for (const Outcome o : outcomes) e.findings.push_back({"NB", "", {}, o});
    e.findings.push_back({"NB", "shown only", {}, Outcome::against, false});
    return e;
  };
  CHECK(verdict_of(with({Outcome::agrees, Outcome::agrees})) == Verdict::holds);
  CHECK(verdict_of(with({Outcome::agrees, Outcome::against})) == Verdict::holds_in_part);
  CHECK(verdict_of(with({Outcome::agrees, Outcome::within_scatter})) == Verdict::holds_in_part);
  CHECK(verdict_of(with({Outcome::within_scatter})) == Verdict::does_not_hold);
  CHECK(verdict_of(with({})) == Verdict::not_judged);
  report::Evidence incomplete = with({Outcome::agrees});
  incomplete.missing.push_back("WB");
  CHECK(verdict_of(incomplete) == Verdict::not_judged);
}

TEST_CASE("numbers are shown with two figures of their standard error") {
  CHECK(report::number_text({0.12345, 0.0123, 3}) == "0.123 ± 0.012");
  CHECK(report::number_text({-551.2, 33.3, 3}) == "-551 ± 33");
  CHECK(report::number_text({0.5, std::nan(""), 1}) == "0.500");
}
