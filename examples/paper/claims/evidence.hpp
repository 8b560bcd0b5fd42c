// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the runs say about a statement: one finding a series and pressure, each with its scatter.

#include <functional>
#include <string>
#include <vector>

#include "../results/results.hpp"
#include "../results/samples.hpp"

namespace report {

struct Finding {
  std::string series;  // "NB", "WB", "WB less NB", ...
  std::string place;   // "0.5 MPa", "0.5 to 14 MPa", ... or nothing
  Estimate value;      // what is shown
  Outcome outcome = Outcome::within_scatter;
  bool counts = true;  // or is shown only
};

struct Evidence {
  std::vector<Finding> findings;
  std::vector<std::string> missing;  // what the runs would have to have besides

  void add(const Evidence& other);
  // The same with a word behind the name of every series, to tell numbers of two kinds apart.
  [[nodiscard]] Evidence labelled(const std::string& text) const;
  // The same, but what is within the scatter agrees: for statements that something does not happen.
  [[nodiscard]] Evidence unless_against() const;
};

// A number read from a run; not a number where the run does not have it.
using Feature = std::function<double(const Run&)>;

// Is the number claimed to be large or to be small?
enum class Claimed { above, below };

// The numbers of all samples of a series that have it, in the order of the samples.
std::vector<double> values(const Results& results, Mode mode, double pressure,
                           const Feature& feature);

// One finding a pressure: the feature of one mode less that of the other, sample by sample, since
// both started from the same samples.
Evidence differences(const Results& results, Mode mode, Mode less, const std::vector<double>& at,
                     const Feature& feature, Claimed claimed);
// The differences of the samples themselves at one pressure.
std::vector<double> paired(const Results& results, Mode mode, double pressure, Mode less_mode,
                           double less_pressure, const Feature& feature);

// One finding a mode and pressure: the feature is clearly above, or below, 0 or another value that
// chance would give.
Evidence levels(const Results& results, const std::vector<Mode>& modes,
                const std::vector<double>& at, const Feature& feature, Claimed claimed,
                double chance = 0);
// The same against a tolerance, which leaves room already: the mean decides.
Evidence mean_levels(const Results& results, const std::vector<Mode>& modes,
                     const std::vector<double>& at, const Feature& feature, Claimed claimed,
                     double tolerance);

// One finding a mode: how the feature changes from the lowest to the highest pressure, sample by
// sample; it agrees if that does and no step between neighbouring pressures is against it. The
// means at the pressures are shown.
Evidence trend_with_pressure(const Results& results, const std::vector<Mode>& modes,
                             const Feature& feature, Claimed claimed);

}  // namespace report
