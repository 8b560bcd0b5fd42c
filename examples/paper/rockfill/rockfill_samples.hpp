// SPDX-License-Identifier: BSL-1.0
#pragma once
// What an engineer who builds with rock reads from the runs of a study: strength, breakage,
// porosity and stiffness of each, and their means over the samples of one pressure.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <riprap/measurement/grading.hpp>
#include <riprap/measurement/secant_modulus.hpp>
#include <riprap/measurement/secant_strength.hpp>

namespace rockfill {

using Json = nlohmann::ordered_json;

struct Sample {
  std::string mode;                 // "nb" or "wb"
  double pressure = 0;              // [Pa]
  riprap::SecantStrength strength;  // at the peak
  riprap::SecantModulus e_50;
  double initial_porosity = 0;  // when shear begins
  double final_porosity = 0;    // when it ends
  double marsal = 0;            // B_g [-]; not a number where the run does not tell it
  riprap::Grading before;
  riprap::Grading after;
};

// From the contents of a run.json. The peak is the largest mean of sin phi over 2 % of strain, and
// sigma_3 the mean of sigma_11 there: a single record scatters too much. Throws
// riprap::InvalidInput for columns of unequal length and a strength that cannot be, and
// Json::exception for a missing entry.
Sample read_sample(const Json& run);

struct Statistic {
  double mean = 0;
  double deviation = 0;  // standard deviation over the samples; 0 for a single one
};

// Samples of one mode at one pressure.
struct Group {
  std::string mode;
  double pressure = 0;  // [Pa]
  std::vector<Sample> samples;

  // Of quantity(sample).
  template <class Quantity>
  [[nodiscard]] Statistic statistic(Quantity quantity) const {
    std::vector<double> values;
    for (const Sample& s : samples) values.push_back(quantity(s));
    return statistic_of(values);
  }

 private:
  static Statistic statistic_of(const std::vector<double>& values);
};

// By mode, in the order nb, wb, and ascending pressure.
std::vector<Group> grouped(const std::vector<Json>& runs);

// The mean share that is finer than each of `count` sizes, evenly spread over the logarithm of size
// [m] from the finest to the coarsest of all the curves.
std::vector<riprap::GradingPoint> mean_grading(const std::vector<riprap::Grading>& curves,
                                               int count = 60);

}  // namespace rockfill
