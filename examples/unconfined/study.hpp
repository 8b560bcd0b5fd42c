// SPDX-License-Identifier: BSL-1.0
#pragma once
// Rat at failure of one specimen, and what moves it: one parameter after another.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>

#include "specimen.hpp"

namespace unconfined {

// The range and the mean of RatF that section 3.2 of the paper gives for its 51 specimens.
inline constexpr double paper_low = 0.32;
inline constexpr double paper_high = 0.39;
inline constexpr double paper_mean = 0.34;

// Rat at failure against one parameter.
struct Sweep {
  std::string parameter{};  // with its unit
  std::vector<riprap::Vec2> points{};

  [[nodiscard]] double lowest() const {
    return std::ranges::min(points, {}, [](const auto& p) { return p.y(); }).y();
  }
  [[nodiscard]] double highest() const {
    return std::ranges::max(points, {}, [](const auto& p) { return p.y(); }).y();
  }
  // From the first value to the last.
  [[nodiscard]] double change() const { return points.back().y() - points.front().y(); }
};

struct PoissonSweep {
  double m_b = 0;
  Sweep sweep{};
};

// A line through the failed elements, by the name of the fit.
struct FailureLine {
  std::string fit;
  riprap::Line line;

  // Against the loading axis [degrees], 0 to 90.
  [[nodiscard]] double angle() const {
    return 57.29577951308232 *
           std::atan2(std::abs(line.direction.x()), std::abs(line.direction.y()));
  }
};

struct Specimen {
  Options options{};
  riprap::UnconfinedResult result{};
  std::vector<FailureLine> lines{};
  double plane_angle = 0;  // of the first failed element's planes to the axis [degrees]
};

struct Study {
  Options options{};
  Specimen specimen{};
  std::vector<PoissonSweep> poisson{};
  Sweep young{};
  Sweep strength{};
  std::vector<Sweep> others{};  // m_b, aspect, friction, load, triangles
  double load_at_0_4 = 0;       // platen stress over strength at which Rat reaches 0.4
};

inline Specimen specimen(const Options& o) {
  Specimen s{.options = o, .result = test(o)};
  const ChosenCriterion criterion = criterion_of(o);
  const auto add = [&](const char* name, const auto& fit) {
    if (const auto line = riprap::failure_line(s.result, criterion, fit))
      s.lines.push_back({name, *line});
  };
  add("weighted X or Y", riprap::WeightedXY{});
  add("total least squares", riprap::TotalLeastSquares{});
  add("failure plane through the centroid", riprap::FailurePlaneThroughCentroid{});
  if (s.result.failures.failed > 0) {
    const std::size_t first = s.result.failures.first_failed;
    s.plane_angle = 57.29577951308232 * riprap::failure_planes(criterion, s.result.stress[first],
                                                               s.result.elements[first].mode)
                                            .angle_to({0, 1});
  }
  return s;
}

// `set(options, value)` puts each value in its place.
template <class Set>
Sweep sweep(const Options& o, const std::string& parameter, const std::vector<double>& values,
            const Set& set) {
  Sweep s{.parameter = parameter};
  for (const double value : values) {
    Options changed = o;
    set(changed, value);
    s.points.push_back({value, test(changed).ratio()});
  }
  return s;
}

inline std::vector<double> evenly(double first, double last, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + (last - first) * i / (count - 1));
  return values;
}

// By bisection, for Rat rises with the load; infinity where 4 times the strength is not enough.
inline double load_for(Options o, double ratio) {
  double low = 0;
  double high = 4;
  o.load = high;
  if (test(o).ratio() < ratio) return std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    o.load = 0.5 * (low + high);
    (test(o).ratio() < ratio ? low : high) = o.load;
  }
  return high;
}

inline std::vector<Sweep> other_sweeps(const Options& o) {
  return {
      sweep(o, "m_b [-]", {1, 2, 3, 4, 5, 7, 10, 12.5, 15, 17.5, 20, 25, 30, 35, 40},
            [](Options& x, double v) { x.m_b = v; }),
      sweep(o, "height over width [-]", evenly(1, 3, 17),
            [](Options& x, double v) { x.aspect = v; }),
      sweep(o, "friction of the platens [-]",
            {0.001, 0.005, 0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4},
            [](Options& x, double v) { x.friction = v; }),
      sweep(o, "platen stress over strength [-]", evenly(0.9, 1.1, 21),
            [](Options& x, double v) { x.load = v; }),
      sweep(
          o, "triangles in the mesh [-]",
          {60, 100, 150, 200, 300, 400, 600, 800, 1000, 1500, 2000, 3000, 4000, 5000, 7000, 10000},
          [](Options& x, double v) { x.triangles = static_cast<unsigned>(v); }),
  };
}

inline void check(const Options& o) {
  riprap::require(
      o.friction > 0, "--friction", o.friction,
      "must be above 0: between smooth platens all elements fail at once, and round-off "
      "decides what Rat is");
  riprap::require(o.poisson > 0, "--poisson", o.poisson,
                  "must be above 0: at 0 platens have no effect, all elements fail at once, and "
                  "round-off decides what Rat is");
}

// Throws InvalidInput for an option that breaks a rule.
inline Study unconfined_study(const Options& o) {
  check(o);
  Study s{.options = o};
  s.specimen = specimen(o);
  for (const double m_b : {4.0, 10.0, 17.0, 25.0, 32.0})
    s.poisson.push_back(
        {m_b, sweep(o, "Poisson's ratio [-]", evenly(0.05, 0.4, 15), [&](Options& x, double v) {
           x.m_b = m_b;
           x.poisson = v;
         })});
  s.young = sweep(o, "Young's modulus [Pa]", evenly(10e9, 100e9, 10),
                  [](Options& x, double v) { x.young = v; });
  s.strength = sweep(o, "uniaxial strength [Pa]", evenly(25e6, 400e6, 16),
                     [](Options& x, double v) { x.strength = v; });
  s.others = other_sweeps(o);
  s.load_at_0_4 = load_for(o, 0.4);
  return s;
}

}  // namespace unconfined
