// SPDX-License-Identifier: BSL-1.0
// Which variations at which pressures, with how many samples.

#include "study_design.hpp"

#include <algorithm>

namespace study {

namespace {

constexpr double low = 0.5e6;
constexpr double two = 2e6;
constexpr double high = 14e6;

// At 2 and 4 MPa, where some tens of particles break, single samples say the least.
constexpr unsigned additional_samples = 2;

std::vector<Row> whole_study(unsigned samples) {
  using enum Variation;
  std::vector<Row> rows;
  for (const Mode mode : {Mode::nb, Mode::wb}) {
    rows.push_back({none, mode, {low, 1e6, 8e6, high}, samples});
    rows.push_back({none, mode, {two, 4e6}, samples + additional_samples});
    rows.push_back({many_particles, mode, {high}, 1});
    rows.push_back({periodic_cell, mode, {two, high}});
  }
  // What the paper leaves open, or has otherwise, where breakage matters most.
  for (const Variation variation : {mean_tension_line, failure_plane, small_pieces})
    rows.push_back({variation, Mode::wb, {two, high}});
  rows.push_back({weak_rock, Mode::wb, {low, high}});
  rows.push_back({recommended_preset, Mode::wb, {two, high}});
  rows.push_back({paper_preset, Mode::wb, {high}});
  for (const Variation variation :
       {two_pinned_contacts, stocky_pieces, large_pieces, blunt_particles, slow_shear})
    rows.push_back({variation, Mode::wb, {high}});
  rows.push_back({stiff_contacts, Mode::nb, {low, two, high}});
  return rows;
}

}  // namespace

std::vector<Row> study_rows(const Options& options) {
  std::vector<Row> rows = whole_study(options.samples);
  if (!options.quick) return rows;
  // A glance: three pressures, and every row once.
  std::vector<Row> glance;
  for (Row row : rows) {
    std::erase_if(row.pressures, [&](double p) {
      return row.variation == Variation::none ? p != low && p != two && p != high : p != high;
    });
    row.samples = row.variation == Variation::none ? options.samples : 1;
    if (!row.pressures.empty()) glance.push_back(row);
  }
  return glance;
}

std::vector<RunPlan> all_runs(const Options& options) {
  const unsigned particles = options.quick ? 150 : 500;
  std::vector<RunPlan> runs;
  for (const Row& row : study_rows(options)) {
    const bool is_row = row.variation != Variation::none;
    const unsigned samples = is_row ? std::min(row.samples, options.samples) : row.samples;
    const unsigned count = row.variation == Variation::many_particles ? 10 * particles : particles;
    for (const double pressure : row.pressures)
      for (unsigned seed = 1; seed <= samples; ++seed)
        runs.push_back({.mode = row.mode,
                        .pressure = pressure,
                        .seed = seed,
                        .particles = count,
                        .variation = row.variation});
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RunPlan& a, const RunPlan& b) { return a.work() > b.work(); });
  return runs;
}

}  // namespace study
