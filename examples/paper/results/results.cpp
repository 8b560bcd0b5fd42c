// SPDX-License-Identifier: BSL-1.0
#include "results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <tuple>

#include <riprap/core/errors.hpp>

namespace report {

namespace {

// JSON has no NaN: it is written as null.
double real(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<double> reals(const Json& values) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const Json& v : values) out.push_back(real(v));
  return out;
}

Mode mode_of(const std::string& text) {
  if (text == "nb") return Mode::nb;
  if (text == "wb") return Mode::wb;
  throw riprap::InvalidInput("riprap: mode \"" + text + "\" of a run must be nb or wb");
}

ShearWindow read_shear(const Json& json) {
  ShearWindow window{.axial_strain = json.at("axial_strain"), .particles = {}};
  const riprap::Vec2 stretch{json.at("stretch_at_begin").at(0).get<double>(),
                             json.at("stretch_at_begin").at(1).get<double>()};
  const std::vector<double> x = reals(json.at("x_share"));
  const std::vector<double> y = reals(json.at("y_share"));
  const std::vector<double> shear = reals(json.at("shear"));
  for (std::size_t i = 0; i < x.size(); ++i)
    window.particles.push_back(
        {riprap::Vec2{x[i], y.at(i)}.cwiseProduct(stretch), {x[i], y[i]}, shear.at(i)});
  return window;
}

}  // namespace

std::string to_text(Mode mode) { return mode == Mode::nb ? "NB" : "WB"; }

std::string pressure_text(double pressure) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g MPa", pressure / 1e6);
  return buffer;
}

const std::vector<double>& Run::column(const std::string& name) const {
  const auto found = curve.find(name);
  if (found == curve.end())
    throw riprap::InvalidInput("riprap: " + this->name() + " has no column \"" + name + "\"");
  return found->second;
}

double Run::number(const std::string& name) const {
  const auto found = numbers.find(name);
  return found == numbers.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

std::size_t Run::breaks_in_shear() const {
  return static_cast<std::size_t>(
      std::count_if(breaks.begin(), breaks.end(), [](const Break& b) { return b.in_shear; }));
}

double Run::fracture_energy(double per_area) const {
  double length = 0;
  for (const Break& b : breaks)
    if (b.in_shear) length += b.crack_length;
  return per_area * length * number("thickness_m");
}

std::string Run::name() const {
  return to_text(mode) + " " + pressure_text(pressure) + ", sample " + std::to_string(seed) +
         (variation.empty() ? "" : ", " + variation);
}

Run read_run(const Json& json, const std::filesystem::path& folder) {
  Run run;
  run.folder = folder;
  run.mode = mode_of(json.at("mode"));
  run.variation = json.value("variation", "");
  run.pressure = json.at("pressure_Pa");
  run.seed = json.at("seed");
  run.particles = json.at("particles");
  run.relaxed_state = json.at("relaxed_state");
  run.wall_time = real(json.at("wall_s"));
  for (const auto& [name, values] : json.at("curve").items()) run.curve[name] = reals(values);
  for (const auto& [name, values] : run.curve)
    if (values.size() != run.column("axial_strain").size())
      throw riprap::InvalidInput("riprap: column \"" + name + "\" of " + run.name() +
                                 " must be as long as that of the axial strain");
  for (const Json& b : json.at("breaks")) {
    run.breaks.push_back({.in_shear = b.at("stage") == "shear",
                          .radius_share = real(b.at("radius_share")),
                          .crack_length = real(b.at("crack_m"))});
    if (b.contains("band_share") && !b.at("band_share").is_null())
      run.breaks.back().band_share = b.at("band_share").get<double>();
  }
  run.rat_at_shear_start = reals(json.at("rat_at_shear_start"));
  const Json& movement = json.at("movement");
  run.ring_displacement = reals(movement.at("mean_displacement_m"));
  const Json& forces = json.at("normal_forces");
  run.force_axial = reals(forces.at("mean_near_axis_2_N"));
  run.force_side = reals(forces.at("mean_near_axis_1_N"));
  if (json.contains("shear_around"))
    for (const Json& window : json.at("shear_around")) run.shear.push_back(read_shear(window));
  for (const auto& [name, value] : json.at("numbers").items())
    if (value.is_number() || value.is_null()) run.numbers[name] = real(value);
  const auto note = [&](const char* name, const Json::json_pointer& path) {
    if (json.contains(path)) run.numbers[name] = real(json.at(path));
  };
  note("boundary_work_J", Json::json_pointer("/energy/boundary_work_J"));
  note("thickness_m", Json::json_pointer("/parameters/assembly/thickness_m"));
  for (const Json& warning : json.at("warnings")) run.warnings.push_back(warning);
  return run;
}

std::vector<const Run*> Results::of(Mode mode, double pressure) const {
  return of_row("", mode, pressure);
}

std::vector<const Run*> Results::of_row(const std::string& variation, Mode mode,
                                        double pressure) const {
  std::vector<const Run*> out;
  for (const Run& run : variation.empty() ? runs : rows)
    if (run.variation == variation && run.mode == mode &&
        std::abs(run.pressure / pressure - 1) < 1e-9)
      out.push_back(&run);
  return out;
}

const Run* Results::first(Mode mode, double pressure) const {
  const auto found = of(mode, pressure);
  return found.empty() ? nullptr : found.front();
}

Json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  try {
    return Json::parse(in);
  } catch (const Json::exception& e) {
    throw riprap::InvalidInput("riprap: " + file.string() + ": " + e.what());
  }
}

namespace {

std::vector<Run> read_runs(const std::filesystem::path& folder) {
  std::vector<Run> runs;
  if (!std::filesystem::is_directory(folder)) return runs;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto file = entry.path() / "run.json";
    if (!std::filesystem::exists(file)) continue;
    try {
      runs.push_back(read_run(read_json(file), entry.path()));
    } catch (const Json::exception& e) {
      throw riprap::InvalidInput("riprap: " + file.string() + ": " + e.what());
    }
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::tie(a.variation, a.mode, a.pressure, a.seed) <
           std::tie(b.variation, b.mode, b.pressure, b.seed);
  });
  return runs;
}

}  // namespace

Results read_results(const std::filesystem::path& folder) {
  Results results{.runs = read_runs(folder / "runs"), .rows = read_runs(folder / "rows")};
  if (results.runs.empty())
    throw riprap::InvalidInput("riprap: no finished run in " + (folder / "runs").string());
  return results;
}

}  // namespace report
