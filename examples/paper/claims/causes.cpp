// SPDX-License-Identifier: BSL-1.0
#include "causes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "../results/curve_features.hpp"
#include "evidence.hpp"

namespace report {

namespace {

// What a run is about, from the name of its folder: wb_8MPa_1_stocky_pieces.
std::string cause_of(const std::string& folder) {
  static constexpr std::array<std::array<const char*, 2>, 4> texts{{
      {"stocky_pieces", "slender pieces: their aspect is 2 at most instead of 3"},
      {"large_pieces", "small pieces: they have 16 % of the mean area at least instead of 8 %"},
      {"blunt_particles", "sharp particles: 5 to 8 vertices instead of 3 to 5"},
      {"slow_shear", "haste: half the rate of strain"},
  }};
  for (const auto& [name, text] : texts)
    if (folder.ends_with(name)) return text;
  return folder;
}

std::string number(double value, const char* format = "%.3f") {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, value + 0.0);
  return buffer;
}

std::vector<std::string> row(const Run& run, const std::string& cause, const std::string& effect) {
  return {pressure_text(run.pressure),
          cause,
          number(mean_gap(run, "sin_phi_eq_14")),
          number(mean_gap(run, "sin_phi_eq_15")),
          number(mean_gap(run, "sin_phi_full")),
          std::to_string(run.breaks_in_shear()),
          effect};
}

// The standard deviation of the samples of a series.
std::string scatter(const Results& results, const Run& run) {
  const std::vector<double> gaps = values(
      results, run.mode, run.pressure, [](const Run& r) { return mean_gap(r, "sin_phi_eq_14"); });
  const Estimate e = estimate(gaps);
  return "scatter " +
         number(e.standard_error * std::sqrt(static_cast<double>(gaps.size())), "%.3f");
}

}  // namespace

Table causes_table(const Results& results, const std::filesystem::path& folder) {
  Table table{{"pressure", "suspected, and changed", "eq. 14", "eq. 15", "full relation",
               "breakages", "change of eq. 14"},
              {}};
  const auto place = folder / "causes";
  if (!std::filesystem::is_directory(place)) return table;
  std::vector<Run> runs;
  for (const auto& entry : std::filesystem::directory_iterator(place))
    if (const auto file = entry.path() / "run.json"; std::filesystem::exists(file))
      runs.push_back(read_run(read_json(file), entry.path()));
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::pair(a.pressure, a.folder) < std::pair(b.pressure, b.folder);
  });
  const Run* base = nullptr;
  for (const Run& run : runs) {
    const std::vector<const Run*> series = results.of(run.mode, run.pressure);
    const auto same = std::find_if(series.begin(), series.end(),
                                   [&](const Run* r) { return r->seed == run.seed; });
    if (same == series.end()) continue;
    if (*same != base) {
      base = *same;
      table.rows.push_back(
          row(*base, "nothing: the same sample in the series", scatter(results, *base)));
    }
    const double change = mean_gap(run, "sin_phi_eq_14") - mean_gap(*base, "sin_phi_eq_14");
    table.rows.push_back(
        row(run, cause_of(run.folder.filename().string()), number(change, "%+.3f")));
  }
  return table;
}

}  // namespace report
