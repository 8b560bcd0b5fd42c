// SPDX-License-Identifier: BSL-1.0
#pragma once
// The paper's statements of result, each with the rule that judges it from the runs.

#include <string>
#include <string_view>
#include <vector>

#include "evidence.hpp"

namespace report {

enum class Verdict { holds, holds_in_part, does_not_hold, not_judged };
std::string to_text(Verdict verdict);

// A statement and its rule, in our words.
struct Statement {
  std::string id = {};
  std::string section = {};  // of the paper
  std::vector<int> figures = {};
  std::string text = {};
  std::string rule = {};
  std::string quantity = {};  // what the numbers are
  // What explains the verdict besides the findings; may be empty.
  std::string if_holds = {};
  std::string if_in_part = {};
  std::string if_not = {};
};

struct Claim {
  Statement statement;
  Evidence evidence;
  Verdict verdict = Verdict::not_judged;
  std::string reason;  // where it is as claimed and where not, or what is missing
  std::string remark;  // what explains that; may be empty
};

// Holds if all findings that count agree, in part if some do, not if none does; not judged while
// anything is missing.
Verdict verdict_of(const Evidence& evidence);
Claim judged(const Statement& statement, const Evidence& evidence);

// All statements, judged with the runs of `breakable` as those with breakage.
std::vector<Claim> judge_claims(const Results& results, Mode breakable);

// Mean and standard error with as many decimals as two figures of the error ask for.
std::string number_text(const Estimate& estimate);

// The findings that count, in a few words: "WB less NB: 0.5 MPa 0.012 +- 0.004, ...".
std::string findings_text(const Evidence& evidence);

// {id, section, figures, statement, rule, quantity, numbers, verdict, reason}
Json to_json(const Claim& claim);

// The statements by the part of the paper that makes them.
std::vector<Claim> microstructure_claims(const Results& results, Mode breakable);
std::vector<Claim> coordination_claims(const Results& results, Mode breakable);
std::vector<Claim> volume_claims(const Results& results, Mode breakable);
std::vector<Claim> anisotropy_claims(const Results& results, Mode breakable);
std::vector<Claim> friction_claims(const Results& results, Mode breakable);

inline const std::vector<double>& all_pressures() {
  static const std::vector<double> all(pressures.begin(), pressures.end());
  return all;
}

}  // namespace report
