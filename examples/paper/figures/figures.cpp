// SPDX-License-Identifier: BSL-1.0
#include "figures.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "charts.hpp"

namespace report {

namespace {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string figure_name(int number) {
  return std::string(number < 10 ? "fig_0" : "fig_") + std::to_string(number);
}

// A picture in the folder of the first sample's run.
struct Source {
  Mode mode;
  double pressure;
  std::string file;  // without .svg
  std::string caption;
};

Figure drawn(const Results& results, int number, const std::string& title, const std::string& text,
             const std::vector<std::vector<Source>>& rows) {
  Figure figure{number, title, text, {}};
  std::string missing;
  for (const auto& sources : rows) {
    Pictures row;
    for (const Source& s : sources) {
      const Run* run = results.first(s.mode, s.pressure);
      const auto file = run ? run->folder / (s.file + ".svg") : std::filesystem::path{};
      if (!run || !std::filesystem::exists(file)) {
        missing += (missing.empty() ? "" : "; ") + s.caption;
        continue;
      }
      std::string mode = to_text(s.mode);
      std::transform(mode.begin(), mode.end(), mode.begin(), [](char c) {
        return c == 'N' ? 'n' : c == 'B' ? 'b' : c == 'W' ? 'w' : c;
      });
      std::string pressure = pressure_text(s.pressure);
      pressure.replace(pressure.find(' '), 1, "");
      row.pictures.push_back({figure_name(number) + "_" + mode + "_" + pressure + "_" + s.file,
                              s.caption, read_text(file)});
    }
    if (!row.pictures.empty()) figure.rows.push_back(row);
  }
  if (!missing.empty()) figure.text += " Not drawn in these runs: " + missing + ".";
  return figure;
}

Figure charted(int number, const std::string& title, const std::string& text,
               const std::vector<riprap::Chart>& charts) {
  return {
      number, title, text, {{{{figure_name(number), "", riprap::chart_sheet(charts).document()}}}}};
}

// Snapshots of both series: a row without and a row with breakage.
std::vector<std::vector<Source>> snapshots(const std::vector<std::string>& strains,
                                           const std::string& file) {
  std::vector<std::vector<Source>> rows;
  for (const Mode mode : {Mode::nb, Mode::wb}) {
    rows.emplace_back();
    for (const std::string& strain : strains)
      rows.back().push_back({mode, 2e6, file + "_" + strain,
                             to_text(mode) + ", " + std::to_string(std::stoi(strain)) + " %"});
  }
  return rows;
}

// The pictures that the study of unconfined tests left, in the order of their names.
std::vector<Figure> unconfined_figures(const std::filesystem::path& folder) {
  std::vector<Figure> all{
      {3, "A specimen in unconfined compression and its predicted failure", "", {}},
      {4, "Rat at failure against Poisson's ratio", "", {}},
      {5, "Rat at failure against the uniaxial strength", "", {}}};
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".svg") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (Figure& figure : all) {
    for (const auto& file : files) {
      const std::string name = file.stem().string();
      if (!name.starts_with("fig" + std::to_string(figure.number))) continue;
      figure.rows.push_back({{{figure_name(figure.number), "", read_text(file)}}});
    }
    if (figure.rows.empty())
      figure.text = "Not drawn: the unconfined tests are no part of this folder.";
  }
  const auto others = folder / "what_moves_rat.svg";
  if (std::filesystem::exists(others))
    all.back().rows.push_back(
        {{{"fig_05_what_moves_rat", "What does move Rat at failure", read_text(others)}}});
  return all;
}

constexpr auto mean_note =
    "Means over the samples; bars are one standard deviation of the samples to either side.";

std::vector<Figure> particle_figures(const Results& r) {
  constexpr double high = 14e6;
  constexpr double low = 0.5e6;
  constexpr double two = 2e6;
  return {
      drawn(
          r, 6, "The compacted assembly, and the paths of its particles",
          "Compaction moves the boundary towards the centre at a constant rate, and the particles "
          "follow.",
          {{{Mode::wb, two, "compaction_assembly", "(a) assembly"},
            {Mode::wb, two, "compaction_paths", "(b) paths in compaction"}}}),
      drawn(r, 7, "The assembly at 18 % axial strain and 14 MPa, and the paths in shear",
            "The test shortens the sample along axis 2, upwards in the pictures.",
            {{{Mode::nb, high, "sheared_assembly", "(a) NB"},
              {Mode::wb, high, "sheared_assembly", "(a) WB"}},
             {{Mode::nb, high, "sheared_paths", "(b) NB"},
              {Mode::wb, high, "sheared_paths", "(b) WB"}}}),
      drawn(r, 8, "Rat of every particle when shear begins, and at its end",
            "The size of a dot is that of Rat. The end of shear, and 14 MPa, are there to compare "
            "with.",
            {{{Mode::wb, low, "rat_dots", "WB, 0.5 MPa, start of shear"},
              {Mode::wb, low, "rat_dots_end", "WB, 0.5 MPa, end"},
              {Mode::wb, high, "rat_dots_end", "WB, 14 MPa, end"}}}),
      drawn(
          r, 9, "From forces to pieces: one particle of a run",
          "The first particle with three contacts or more that breaks in shear: forces on it, its "
          "support, failed elements, the lines fitted along x and along y, and the pieces. With "
          "inertia relief the particle has no fixed point; the paper pins two contacts.",
          {{{Mode::wb, two, "particle_process", "WB, 2 MPa, inertia relief"}}}),
      drawn(r, 10, "Movement of the particles over the last 6 % of strain, at 2 MPa",
            "Above without, below with breakage.", snapshots({"06", "12", "18"}, "movement")),
      drawn(r, 11, "Normal contact forces at 2 MPa, in the paper's classes",
            "Above without, below with breakage.", snapshots({"00", "06", "18"}, "forces")),
      charted(12, "Coordination number against axial strain",
              std::string("Contacts per particle, M/N, as in eq. 8; every contact belongs to two "
                          "particles, so that the usual coordination number is twice that. ") +
                  mean_note,
              pressure_charts(r, "contacts_per_particle", "contacts per particle M/N", 1)),
      drawn(r, 13, "Contacts of every particle at 2 MPa",
            "The size of a dot is the number of contacts. Above without, below with breakage.",
            snapshots({"00", "06", "18"}, "coordination"))};
}

}  // namespace

std::vector<Figure> figures(const Results& r, const std::filesystem::path& folder) {
  std::vector<Figure> all = unconfined_figures(folder / "unconfined");
  for (Figure& figure : particle_figures(r)) all.push_back(std::move(figure));
  const auto by_pressure = [&](int number, const std::string& title, const std::string& column,
                               const std::string& label, double factor) {
    all.push_back(charted(number, title, mean_note, pressure_charts(r, column, label, factor)));
  };
  by_pressure(14, "Volumetric strain against axial strain; contraction is positive",
              "volumetric_strain", "volumetric strain [%]", 100);
  all.push_back(charted(15, "The three anisotropy coefficients at 0.5, 4 and 14 MPa", mean_note,
                        anisotropy_charts(r)));
  by_pressure(16, "Anisotropy of contact normals", "a", "a", 1);
  by_pressure(17, "Anisotropy of normal forces", "a_n", "a_n", 1);
  by_pressure(18, "Anisotropy of tangential forces", "a_t", "a_t", 1);
  by_pressure(19, "Mobilised friction against axial strain", "sin_phi", "sin phi", 1);
  all.push_back(charted(20, "Friction by eq. 14, from the anisotropies, and by eq. 12", mean_note,
                        fabric_charts(r)));
  all.push_back(
      charted(21, "Friction by eqs 14 and 15, and by eq. 12", mean_note, simplified_charts(r)));
  return all;
}

}  // namespace report
