// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the runs say about a statement: for each of its parts one pooled test, and the numbers of
// every series and pressure as evidence.

#include <functional>
#include <string>
#include <vector>

#include "../results/results.hpp"
#include "../results/samples.hpp"

namespace report {

// A number read from a run; not a number where the run does not have it.
using Feature = std::function<double(const Run&)>;

// Is the number claimed to be large or to be small?
enum class Claimed { above, below };

struct Finding {
  std::string series;  // "NB", "WB", "WB less NB", ...
  std::string place;   // "0.5 MPa", ...
  Estimate value;
  Outcome outcome = Outcome::within_scatter;
  bool counts = true;  // or is shown only
};

// A statement that one number is above, or below, a threshold.
struct Part {
  std::string label = {};     // or nothing, where a claim has one part
  std::string quantity = {};  // what the pooled number is: "mean", "slope per tenfold pressure"
  Claimed claimed = Claimed::above;
  double threshold = 0;
  double margin = 0;  // an effect of less counts as none; 0 where the threshold says it all
  std::vector<Finding> findings = {};
  Estimate pooled = {};
  Shown shown = Shown::neither;
  // A series at a pressure, or of a slope a step between two pressures, is clearly the other way:
  // by a test that divides the probability of error by their number (Bonferroni).
  bool contradicted = false;
  std::vector<std::string> missing = {};  // what the runs would have to have besides
};

// The effect that the part claims to be above 0: how far beyond the threshold a value of its number
// lies.
Estimate effect_of(const Part& part, Estimate value);

struct Evidence {
  std::vector<Part> parts;
  std::vector<Finding> shown_only = {};
};

// The numbers of all samples of a series that have it, by sample; in the second form also of a row.
Cell cell(const std::vector<const Run*>& runs, const Feature& feature);
std::vector<double> values(const Results& results, Mode mode, double pressure,
                           const Feature& feature);
// Sample by sample: both started from the same samples.
Cell less(const Cell& cell, const Cell& other);

// What a part is apart from its numbers.
struct Asked {
  std::string label = {};
  Claimed claimed = Claimed::above;
  double threshold = 0;
  double margin = 0;
};

// The mean, over the pressures, of the feature with breakage less that without.
Part difference_part(const Results& results, const Asked& asked, const std::vector<double>& at,
                     const Feature& feature);
// The mean of the feature over series and pressures.
Part level_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                const std::vector<double>& at, const Feature& feature);
// The slope of the feature over the decimal logarithm of all pressures, mean of the series; a step
// between neighbouring pressures that is clearly the other way contradicts it.
Part slope_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                const Feature& feature);
// A contrast of the pressures, mean of the series; single pressures cannot contradict it.
Part contrast_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                   const std::vector<double>& at, const std::vector<double>& weights,
                   const std::string& quantity, const Feature& feature);

}  // namespace report
