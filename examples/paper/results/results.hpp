// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs of a study, read back from their folders: runs/MODE_PRESSURE_SEED/run.json.

#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace report {

using Json = nlohmann::ordered_json;

// Without breakage, with breakage, with breakage and two pinned contacts.
enum class Mode { nb, wb, pinned };

// "NB", "WB", "pinned".
std::string to_text(Mode mode);

// The paper's confining pressures [Pa].
inline constexpr std::array<double, 6> pressures = {0.5e6, 1e6, 2e6, 4e6, 8e6, 14e6};
// "0.5 MPa".
std::string pressure_text(double pressure);

struct Break {
  bool in_shear = true;              // or in the hydrostatic stage
  double radius_share = 0;           // distance of the parent from the centre over the radius
  std::optional<double> band_share;  // share of the particles with less shear around them
};

// The tenth of the particles with the most shear around them, up to a strain.
struct Bands {
  double axial_strain = 0;
  double radius_share = 0;    // mean distance from the centre over the radius
  double diagonal_share = 0;  // share of them within 22.5 degrees of a diagonal through the centre
};

struct Run {
  Mode mode = Mode::nb;
  double pressure = 0;  // [Pa]
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
  std::vector<Bands> bands;
  std::map<std::string, double> numbers;
  std::vector<std::string> warnings;

  // Throws riprap::InvalidInput if there is no such column.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  // Not a number if there is no such number.
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] std::size_t breaks_in_shear() const;
  [[nodiscard]] std::string name() const;  // "WB 0.5 MPa, sample 1"
};

// Throws riprap::InvalidInput where columns differ in length or an entry is missing.
Run read_run(const Json& json, const std::filesystem::path& folder);

struct Results {
  std::vector<Run> runs;  // by mode, pressure and seed

  [[nodiscard]] std::vector<const Run*> of(Mode mode, double pressure) const;
  [[nodiscard]] bool has(Mode mode) const;
  // The first sample's run, or none.
  [[nodiscard]] const Run* first(Mode mode, double pressure) const;
};

// All finished runs of a study. Throws riprap::InvalidInput if there is none.
Results read_results(const std::filesystem::path& folder);

Json read_json(const std::filesystem::path& file);

}  // namespace report
