// SPDX-License-Identifier: BSL-1.0
#pragma once
// What section 3.2 of the paper says of unconfined tests, each with the rule that judges it.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "study.hpp"

namespace unconfined {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

struct Claim {
  std::string name;
  std::string rule;
  Json number;
  std::string verdict;
  std::string reason;
};

inline constexpr auto holds = "holds";
inline constexpr auto holds_in_part = "holds in part";
inline constexpr auto does_not_hold = "does not hold";

// A change of Rat that counts; a single triangle of the default mesh is 0.0002.
inline constexpr double noticeable = 0.005;

inline Claim judge_fall(const std::string& name, const Sweep& s, const std::string& reason) {
  const bool falls = s.change() < -noticeable;
  return {name,
          "over the " + s.parameter + " from " + riprap::to_text(s.points.front().x()) + " to " +
              riprap::to_text(s.points.back().x()) +
              ", nothing else changed, Rat falls by more than " + riprap::to_text(noticeable),
          {{"change_of_Rat", s.change()}, {"lowest", s.lowest()}, {"highest", s.highest()}},
          falls ? holds : does_not_hold,
          reason};
}

inline Claim judge_poisson(const Study& s) {
  int falling = 0;
  Json changes = Json::object();
  for (const PoissonSweep& p : s.poisson) {
    falling += p.sweep.change() < -noticeable;
    changes["m_b_" + riprap::to_text(p.m_b)] = p.sweep.change();
  }
  const bool all = falling == static_cast<int>(s.poisson.size());
  return {
      "Rat at failure falls as Poisson's ratio rises (Fig. 4)",
      "for every m_b Rat falls by more than " + riprap::to_text(noticeable) +
          " from the lowest Poisson's ratio to the highest; in part if for some. The paper's words "
          "are that the relation to the mechanical parameters is opposite",
      {{"change_of_Rat", changes}},
      all           ? holds
      : falling > 0 ? holds_in_part
                    : does_not_hold,
      "what the platens add to the uniform stress grows in proportion to Poisson's ratio, and a "
      "field that is magnified marks nearly the same elements"};
}

// Rat over all pairs of Poisson's ratio and m_b.
inline std::vector<double> all_ratios(const Study& s) {
  std::vector<double> ratios;
  for (const PoissonSweep& p : s.poisson)
    for (const auto& point : p.sweep.points) ratios.push_back(point.y());
  return ratios;
}

inline double mean_ratio(const Study& s) {
  double sum = 0;
  const auto ratios = all_ratios(s);
  for (const double r : ratios) sum += r;
  return sum / static_cast<double>(ratios.size());
}

inline Claim judge_range(const Study& s) {
  const auto ratios = all_ratios(s);
  const double share = static_cast<double>(std::ranges::count_if(
                           ratios, [](double r) { return r >= paper_low && r <= paper_high; })) /
                       static_cast<double>(ratios.size());
  return {
      "RatF lies between 0.32 and 0.39",
      "Rat at failure of every pair of Poisson's ratio and m_b does; in part if half of them do",
      {{"share_within", share},
       {"lowest", std::ranges::min(ratios)},
       {"highest", std::ranges::max(ratios)}},
      share == 1     ? holds
      : share >= 0.5 ? holds_in_part
                     : does_not_hold,
      "the proportions of the specimen set it, rather than the rock"};
}

// What the mesh alone moves Rat by, from 1000 triangles on.
inline double mesh_range(const Study& s) {
  double low = 1;
  double high = 0;
  for (const auto& p : s.others.back().points) {
    if (p.x() < 1000) continue;
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  return high - low;
}

inline Claim judge_mean(const Study& s) {
  const double off = std::abs(mean_ratio(s) - paper_mean);
  return {
      "the average of RatF is 0.34",
      "the mean over all pairs of Poisson's ratio and m_b rounds to it; in part if it is off by "
      "less than the mesh alone moves Rat, from 1000 triangles on",
      {{"mean", mean_ratio(s)}, {"range_over_meshes", mesh_range(s)}},
      off <= 0.005           ? holds
      : off <= mesh_range(s) ? holds_in_part
                             : does_not_hold,
      "an even grid of rocks in one specimen, for the paper's specimens are not known"};
}

inline Claim judge_line(const Study& s) {
  const auto& lines = s.specimen.lines;
  const bool drawn = !lines.empty();
  const double angle = drawn ? lines.front().angle() : 90;
  const double plane = s.specimen.plane_angle;
  return {
      "the fitted line predicts the failure of a specimen (Fig. 3)",
      "it lies within 5 degrees of a failure plane of the first failed element, as where a "
      "specimen shears; in part if it lies within 5 degrees of the axis, as where one splits. The "
      "paper has a picture and no data to compare with",
      {{"line_to_axis_degrees", angle}, {"plane_to_axis_degrees", plane}},
      drawn && std::abs(angle - plane) <= 5 ? holds
      : drawn && angle <= 5                 ? holds_in_part
                                            : does_not_hold,
      "the failed elements of an even rock are symmetric about the axis, and so is their line: "
      "it can show a split along the axis, but no shear plane"};
}

inline std::vector<Claim> claims(const Study& s) {
  return {judge_fall("Rat at failure falls as Young's modulus rises", s.young,
                     "stress at a given platen stress does not depend on the modulus in linear "
                     "elasticity"),
          judge_fall("Rat at failure falls as the uniaxial strength rises (Fig. 5)", s.strength,
                     "at failure stress over strength is the same for every strength, and the "
                     "criterion asks for nothing else at one m_b"),
          judge_poisson(s),
          judge_range(s),
          judge_mean(s),
          judge_line(s)};
}

}  // namespace unconfined
