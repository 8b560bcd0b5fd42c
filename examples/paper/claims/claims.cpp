// SPDX-License-Identifier: BSL-1.0
#include "claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace report {

namespace {

std::string short_number(double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "%.3g", value + 0.0);
  return buffer;
}

std::string to_text(const Part& part) {
  const std::string no_effect = "less than " + short_number(part.margin) + ", which counts as none";
  std::string out;
  switch (part.shown) {
  case Shown::effect:
    out = "as claimed";
    break;
  case Shown::small_effect:
    out = "as claimed, but " + no_effect;
    break;
  case Shown::neither:
    out = "neither shown nor refuted";
    break;
  case Shown::no_effect:
    out = no_effect;
    break;
  case Shown::opposite:
    out = "the other way";
    break;
  }
  if (part.contradicted)
    out += part.shown == Shown::effect ? ", but not everywhere" : "; not so everywhere";
  return out;
}

// "a_n: slope per tenfold pressure -0.041 +- 0.006, p = 0.0003: as claimed".
std::string test_text(const Part& part) {
  std::string out = (part.label.empty() ? "" : part.label + ": ") + part.quantity + " " +
                    number_text(part.pooled);
  if (part.threshold != 0)
    out += std::string(part.claimed == Claimed::above ? ", to be above " : ", to be below ") +
           short_number(part.threshold);
  const double p = p_value(effect_of(part, part.pooled));
  return out + ", p " + (p < 1e-4 ? "< 0.0001" : "= " + short_number(p)) + ": " + to_text(part);
}

std::string missing_text(const std::vector<std::string>& missing) {
  std::string out = "Missing: ";
  constexpr std::size_t named = 3;
  for (std::size_t i = 0; i < std::min(missing.size(), named); ++i)
    out += (i > 0 ? "; " : "") + missing[i];
  if (missing.size() <= named) return out + ".";
  return out + "; and " + std::to_string(missing.size() - named) + " more.";
}

std::vector<std::string> missing_of(const Evidence& evidence) {
  std::vector<std::string> out;
  for (const Part& part : evidence.parts)
    for (const std::string& what : part.missing)
      if (std::find(out.begin(), out.end(), what) == out.end()) out.push_back(what);
  return out;
}

std::string reason_of(const Evidence& evidence, Verdict verdict) {
  if (verdict == Verdict::not_judged) return missing_text(missing_of(evidence));
  std::string out;
  for (const Part& part : evidence.parts) out += (out.empty() ? "" : ". ") + test_text(part);
  return out + ".";
}

std::string remark_of(const Statement& statement, Verdict verdict) {
  switch (verdict) {
  case Verdict::holds:
    return statement.if_holds;
  case Verdict::holds_in_part:
    return statement.if_in_part;
  case Verdict::open:
    return statement.if_open;
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
  constexpr std::array names = {"holds", "holds in part", "open", "does not hold", "not judged"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict verdict_of(const Evidence& evidence) {
  bool all = true;
  bool some = false;
  bool refuted = false;
  for (const Part& part : evidence.parts) {
    if (!part.missing.empty()) return Verdict::not_judged;
    const bool is_shown = part.shown == Shown::effect || part.shown == Shown::small_effect;
    all = all && part.shown == Shown::effect && !part.contradicted;
    some = some || is_shown;
    refuted = refuted || part.shown == Shown::opposite || part.shown == Shown::no_effect;
  }
  if (evidence.parts.empty()) return Verdict::not_judged;
  return all       ? Verdict::holds
         : some    ? Verdict::holds_in_part
         : refuted ? Verdict::does_not_hold
                   : Verdict::open;
}

Claim judged(const Statement& statement, const Evidence& evidence) {
  const Verdict verdict = verdict_of(evidence);
  return {statement, evidence, verdict, reason_of(evidence, verdict),
          remark_of(statement, verdict)};
}

std::vector<Claim> judge_claims(const Results& results) {
  std::vector<Claim> all;
  for (const auto part : {microstructure_claims, coordination_claims, volume_claims,
                          anisotropy_claims, friction_claims})
    for (Claim& claim : part(results)) all.push_back(std::move(claim));
  return all;
}

Json to_json(const Claim& claim) {
  Json tests = Json::array();
  Json numbers = Json::object();
  const auto add = [&](const std::string& label, const Finding& f) {
    Json entry = {{"mean", real_json(f.value.mean)},
                  {"standard_error", real_json(f.value.standard_error)},
                  {"samples", f.value.samples}};
    if (f.counts) entry["outcome"] = to_text(f.outcome);
    numbers[f.series + ", " + f.place + (label.empty() ? "" : ", " + label)] = entry;
  };
  for (const Part& part : claim.evidence.parts) {
    for (const Finding& f : part.findings) add(part.label, f);
    if (!part.missing.empty()) continue;
    tests.push_back({{"part", part.label},
                     {"quantity", part.quantity},
                     {"claimed", part.claimed == Claimed::above ? "above" : "below"},
                     {"threshold", part.threshold},
                     {"margin", part.margin},
                     {"mean", real_json(part.pooled.mean)},
                     {"standard_error", real_json(part.pooled.standard_error)},
                     {"samples", part.pooled.samples},
                     {"p", real_json(p_value(effect_of(part, part.pooled)))},
                     {"shown", to_text(part)}});
  }
  for (const Finding& f : claim.evidence.shown_only) add("", f);
  const Statement& s = claim.statement;
  return {{"id", s.id},
          {"section", s.section},
          {"figures", s.figures},
          {"statement", s.text},
          {"rule", s.rule},
          {"quantity", s.quantity},
          {"tests", tests},
          {"numbers", numbers},
          {"verdict", to_text(claim.verdict)},
          {"reason", claim.reason + (claim.remark.empty() ? "" : " ") + claim.remark}};
}

}  // namespace report
