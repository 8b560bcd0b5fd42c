// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs of a study, read back from their folders: runs/MODE_PRESSURE_SEED/run.json, and
// rows/MODE_PRESSURE_SEED_VARIATION/run.json.

#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shear_field.hpp"

namespace report {

using Json = nlohmann::ordered_json;

// Without breakage, with breakage.
enum class Mode { nb, wb };

// "NB", "WB".
std::string to_text(Mode mode);

// The paper's confining pressures [Pa].
inline constexpr std::array<double, 6> pressures = {0.5e6, 1e6, 2e6, 4e6, 8e6, 14e6};
// "0.5 MPa".
std::string pressure_text(double pressure);

struct Break {
  bool in_shear = true;                   // or in the hydrostatic stage
  double radius_share = 0;                // distance of the parent from the centre over the radius
  double crack_length = 0;                // [m]
  std::optional<double> band_share = {};  // share of the particles with less shear around them
};

struct Run {
  Mode mode = Mode::nb;
  std::string variation = {};  // what a row of the study changes; nothing in the series
  double pressure = 0;         // [Pa]
  int seed = 0;
  std::filesystem::path folder;
  std::size_t particles = 0;
  std::string relaxed_state;  // equal if all particles lie alike
  double wall_time = 0;       // [s]
  std::map<std::string, std::vector<double>> curve;
  std::vector<Break> breaks;
  std::vector<double> rat_at_shear_start;
  std::vector<double> ring_displacement;        // [m], from the centre outwards
  std::vector<double> force_axial, force_side;  // [N], from the start of shear on
  std::vector<ShearWindow> shear;               // of the stretches of 6 % of strain
  std::map<std::string, double> numbers;
  std::vector<std::string> warnings;

  // Throws riprap::InvalidInput if there is no such column.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  // Not a number if there is no such number.
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::size_t breaks_in_shear() const;
  // Of all cracks in shear [J], for an energy per area of crack [J/m^2].
  [[nodiscard]] double fracture_energy(double per_area) const;
  [[nodiscard]] std::string name() const;  // "WB 0.5 MPa, sample 1"
};

// Throws riprap::InvalidInput where columns differ in length or an entry is missing.
Run read_run(const Json& json, const std::filesystem::path& folder);

struct Results {
  std::vector<Run> runs;  // by mode, pressure and seed

  std::vector<Run> rows;  // by variation, mode, pressure and seed

  [[nodiscard]] std::vector<const Run*> of(Mode mode, double pressure) const;
  // Of a row of the study, or of the series for nothing.
  [[nodiscard]] std::vector<const Run*> of_row(const std::string& variation, Mode mode,
                                               double pressure) const;
  // The first sample's run, or none.
  [[nodiscard]] const Run* first(Mode mode, double pressure) const;
};

// All finished runs of a study. Throws riprap::InvalidInput if there is none.
Results read_results(const std::filesystem::path& folder);

Json read_json(const std::filesystem::path& file);

}  // namespace report
