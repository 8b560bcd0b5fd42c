// SPDX-License-Identifier: BSL-1.0
#pragma once
// A study as engineers who build with rock look at it: strength against normal stress beside what
// is published, breakage, gradings, porosity and stiffness.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <riprap/output/chart.hpp>

namespace rockfill {

// Rows of text below a head.
struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

// Of the rock and its contacts, for the law of Barton and Kjaernsli.
struct Rock {
  double compressive_strength = 300e6;          // [Pa], Table 1 of the paper
  double basic_friction_angle = 0.46364760900;  // atan of the contact friction 0.5 [rad]
};

struct Findings {
  std::vector<riprap::Chart> charts;  // strength, breakage, gradings, porosity, stiffness
  std::vector<Table> tables;          // by mode and pressure; envelopes; published strengths
  std::vector<std::string> notes;     // what the numbers are, and where the published ones end
};

// From the contents of the run.json of every run. Throws riprap::InvalidInput if there is none, or
// for values that cannot be, and nlohmann::json::exception for a missing entry.
Findings findings(const std::vector<nlohmann::ordered_json>& runs, const Rock& rock = {});

}  // namespace rockfill
