// SPDX-License-Identifier: BSL-1.0
#include "claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace report {

namespace {

// "NB at 0.5 MPa, 1 MPa; WB at all pressures" of the findings with an outcome.
std::string places(const std::vector<Finding>& findings, Outcome outcome) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> by_series;
  for (const Finding& f : findings) {
    if (!f.counts || f.outcome != outcome) continue;
    if (!by_series.contains(f.series)) order.push_back(f.series);
    by_series[f.series].push_back(f.place);
  }
  std::string out;
  for (const std::string& series : order) {
    const std::vector<std::string>& all = by_series[series];
    out += (out.empty() ? "" : "; ") + series;
    if (all.size() == pressures.size()) {
      out += " at all pressures";
      continue;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!all[i].empty()) out += (i > 0 ? ", " : all[i].ends_with("MPa") ? " at " : " ") + all[i];
  }
  return out;
}

std::string missing_text(const std::vector<std::string>& missing) {
  std::string out = "Missing: ";
  constexpr std::size_t named = 3;
  for (std::size_t i = 0; i < std::min(missing.size(), named); ++i)
    out += (i > 0 ? "; " : "") + missing[i];
  if (missing.size() <= named) return out + ".";
  return out + "; and " + std::to_string(missing.size() - named) + " more.";
}

std::string reason_of(const Evidence& evidence, Verdict verdict) {
  if (verdict == Verdict::not_judged) return missing_text(evidence.missing);
  if (verdict == Verdict::holds) return "As claimed throughout.";
  std::string out;
  for (const auto& [outcome, name] : {std::pair{Outcome::agrees, "As claimed"},
                                      {Outcome::within_scatter, "Not clear"},
                                      {Outcome::against, "The other way"}})
    if (const std::string where = places(evidence.findings, outcome); !where.empty())
      out += (out.empty() ? "" : " ") + std::string(name) + ": " + where + ".";
  return out;
}

std::string remark_of(const Statement& statement, Verdict verdict) {
  switch (verdict) {
  case Verdict::holds:
    return statement.if_holds;
  case Verdict::holds_in_part:
    return statement.if_in_part;
  case Verdict::does_not_hold:
    return statement.if_not;
  case Verdict::not_judged:
    break;
  }
  return "";
}

std::string to_text(Outcome outcome) {
  return outcome == Outcome::agrees    ? "as claimed"
         : outcome == Outcome::against ? "the other way"
                                       : "not clear";
}

Json real_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::string number_text(const Estimate& e) {
  int decimals = 3;
  if (e.standard_error > 0)
    decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(e.standard_error))), 0, 4);
  char buffer[96];
  if (e.samples < 2 || std::isnan(e.standard_error))
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, e.mean + 0.0);
  else
    std::snprintf(buffer, sizeof buffer, "%.*f ± %.*f", decimals, e.mean + 0.0, decimals,
                  e.standard_error);
  return buffer;
}

std::string to_text(Verdict verdict) {
  constexpr std::array names = {"holds", "holds in part", "does not hold", "not judged"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict verdict_of(const Evidence& evidence) {
  std::size_t agree = 0;
  std::size_t all = 0;
  for (const Finding& f : evidence.findings) {
    all += f.counts;
    agree += f.counts && f.outcome == Outcome::agrees;
  }
  if (!evidence.missing.empty() || all == 0) return Verdict::not_judged;
  return agree == all ? Verdict::holds
         : agree > 0  ? Verdict::holds_in_part
                      : Verdict::does_not_hold;
}

Claim judged(const Statement& statement, const Evidence& evidence) {
  const Verdict verdict = verdict_of(evidence);
  return {statement, evidence, verdict, reason_of(evidence, verdict),
          remark_of(statement, verdict)};
}

std::vector<Claim> judge_claims(const Results& results, Mode breakable) {
  std::vector<Claim> all;
  for (const auto part : {microstructure_claims, coordination_claims, volume_claims,
                          anisotropy_claims, friction_claims})
    for (Claim& claim : part(results, breakable)) all.push_back(std::move(claim));
  return all;
}

std::string findings_text(const Evidence& evidence) {
  std::string out;
  std::string series;
  for (const Finding& f : evidence.findings) {
    if (!f.counts) continue;
    if (out.empty() || f.series != series)
      out += (out.empty() ? "" : "; ") + f.series + ": ";
    else
      out += ", ";
    out += (f.place.empty() ? "" : f.place + " ") + number_text(f.value);
    series = f.series;
  }
  return out;
}

Json to_json(const Claim& claim) {
  Json numbers = Json::object();
  for (const Finding& f : claim.evidence.findings) {
    Json entry = {{"mean", real_json(f.value.mean)},
                  {"standard_error", real_json(f.value.standard_error)},
                  {"samples", f.value.samples}};
    if (f.counts) entry["outcome"] = to_text(f.outcome);
    numbers[f.series + (f.place.empty() ? "" : ", " + f.place)] = entry;
  }
  const Statement& s = claim.statement;
  return {{"id", s.id},
          {"section", s.section},
          {"figures", s.figures},
          {"statement", s.text},
          {"rule", s.rule},
          {"quantity", s.quantity},
          {"numbers", numbers},
          {"verdict", to_text(claim.verdict)},
          {"reason", claim.reason + (claim.remark.empty() ? "" : " ") + claim.remark}};
}

}  // namespace report
