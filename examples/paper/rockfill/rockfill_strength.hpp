// SPDX-License-Identifier: BSL-1.0
#pragma once
// Strength of the samples and its envelopes, beside the published ones.

#include <optional>
#include <string>
#include <vector>

#include <riprap/measurement/barton_kjaernsli.hpp>
#include <riprap/measurement/strength_envelope.hpp>

#include "rockfill.hpp"
#include "rockfill_samples.hpp"

namespace rockfill {

// How a mode is drawn and called.
struct Style {
  std::string name;
  std::string colour;
  riprap::Mark mark = riprap::Mark::circle;
};
Style style_of(const std::string& mode);

// Through all samples of a mode, if they cover three pressures.
struct Envelopes {
  std::string mode;
  riprap::PowerLawEnvelope power;
  riprap::LogarithmicEnvelope logarithmic;
};
std::vector<Envelopes> envelopes(const std::vector<Group>& groups);

// Two ends of what the charts of Barton and Kjaernsli could give for angular stones of this size.
struct RoughnessBound {
  std::string name;
  riprap::BartonKjaernsli law;
};
std::vector<RoughnessBound> roughness_bounds(const Rock& rock);

riprap::Chart strength_chart(const std::vector<Group>& groups, const Rock& rock);
Table envelope_table(const std::vector<Group>& groups);
// At the normal stresses of the groups.
Table published_table(const std::vector<Group>& groups, const Rock& rock);

// Text of numbers.
std::string fixed(double value, int decimals);
std::string with_deviation(const Statistic& value, int decimals);

}  // namespace rockfill
