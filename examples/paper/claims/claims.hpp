// SPDX-License-Identifier: BSL-1.0
#pragma once
// The paper's statements of result, each with the rule that judges it from the runs.

#include <string>
#include <string_view>
#include <vector>

#include "evidence.hpp"

namespace report {

enum class Verdict { holds, holds_in_part, open, does_not_hold, not_judged };
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
  std::string if_open = {};
  std::string if_not = {};
};

struct Claim {
  Statement statement;
  Evidence evidence;
  Verdict verdict = Verdict::not_judged;
  std::string reason;  // what the tests of its parts show, or what is missing
  std::string remark;  // what explains that; may be empty
};

// Holds if the pooled test of every part shows its effect and no single series and pressure
// contradicts; in part if that of some part shows one; does not hold if none does, and one part
// shows the opposite or no effect; else open. Not judged while anything is missing.
Verdict verdict_of(const Evidence& evidence);
Claim judged(const Statement& statement, const Evidence& evidence);

// All statements.
std::vector<Claim> judge_claims(const Results& results);

// Mean and standard error with as many decimals as two figures of the error ask for.
std::string number_text(const Estimate& estimate);

// {id, section, figures, statement, rule, quantity, tests, numbers, verdict, reason}
Json to_json(const Claim& claim);

// The statements by the part of the paper that makes them.
std::vector<Claim> microstructure_claims(const Results& results);
std::vector<Claim> coordination_claims(const Results& results);
std::vector<Claim> volume_claims(const Results& results);
std::vector<Claim> anisotropy_claims(const Results& results);
std::vector<Claim> friction_claims(const Results& results);

inline const std::vector<double>& all_pressures() {
  static const std::vector<double> all(pressures.begin(), pressures.end());
  return all;
}

inline const std::vector<Mode>& both_series() {
  static const std::vector<Mode> both{Mode::nb, Mode::wb};
  return both;
}

}  // namespace report
