// SPDX-License-Identifier: BSL-1.0
#include "mixture.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include <riprap/measurement/breakage_indices.hpp>
#include <riprap/measurement/grading.hpp>
#include <riprap/output/material_picture.hpp>
#include <riprap/particle/share_materials.hpp>
#include <riprap/riprap.hpp>

#include "../study/statistics.hpp"

namespace two_rocks {

namespace {

using namespace riprap;

[[nodiscard]] double hardin_of(const Particles& particles, MaterialIndex material) {
  bool has_any = false;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    has_any |= particles.body(i).is_free() && particles.material(i) == material;
  if (!has_any) return std::numeric_limits<double>::quiet_NaN();
  return hardin_breakage(grading_before_breakage(particles, material),
                         grading(particles, material));
}

// An observer that writes a MixtureRecord at each record of the test.
struct Recorder {
  std::vector<MixtureRecord> records{};
  std::array<double, 2> breaks{};

  template <class Sim>
  void on_break(const Sim& sim, const BreakEvent& event) {
    for (const ParticleId piece : event.pieces)
      if (const auto i = sim.particles().find(piece)) {
        ++breaks[sim.particles().material(*i)];
        return;
      }
  }
  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    if (view.stage == Stage::shear) breaks = {};
  }
  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    const Particles& particles = view.sim.particles();
    records.push_back({view.axial_strain(),
                       view.stress().radius() / view.stress().mean(),
                       view.volumetric_strain(),
                       breaks,
                       {hardin_of(particles, strong), hardin_of(particles, weak)}});
  }
};

[[nodiscard]] Rock rock_of(const RockOfSample& r) {
  return {.young = r.young, .poisson = r.poisson, .density = r.density};
}
[[nodiscard]] HoekBrown criterion_of(const RockOfSample& r) {
  return {.compressive_strength = r.compressive_strength, .m_b = r.m_b};
}
[[nodiscard]] EnergyConservingSpring contact_of(const RockOfSample& r) {
  return {.friction = r.friction};
}

}  // namespace

std::vector<MixtureRecord> run(const Mixture& m, const std::filesystem::path& picture) {
  Assembly assembly = random_assembly({.count = m.particles, .seed = m.seed});
  share_materials(assembly, {1 - m.weak_share, m.weak_share}, m.seed);
  const auto model =
      Model{}
          .criterion(CriterionOfRock{{criterion_of(m.rock), criterion_of(m.weak_rock)}})
          .contact_law(MixedContactLaw{{contact_of(m.rock), contact_of(m.weak_rock)}});
  Simulation sim{model, assembly, Rocks{rock_of(m.rock), rock_of(m.weak_rock)}};
  Recorder recorder;
  BiaxialTest{.confining_pressure = m.pressure, .axial_strain = m.strain}.run(sim, recorder);
  if (!picture.empty()) {
    char title[80];
    std::snprintf(title, sizeof title, "%.0f %% of weak rock, %.0f %% axial strain, %g MPa",
                  100 * m.weak_share, 100 * recorder.records.back().strain, 1e-6 * m.pressure);
    material_picture(sim.particles(), {"strong rock", "weak rock"}, title).save(picture);
  }
  return recorder.records;
}

Strength strength_of(const std::vector<MixtureRecord>& records) {
  std::vector<double> sin_phi;
  for (const MixtureRecord& r : records) sin_phi.push_back(r.sin_phi);
  Strength strength{.peak = run_study::largest_mean(sin_phi, 5)};
  const double from = 0.75 * records.back().strain;
  double count = 0;
  for (const MixtureRecord& r : records)
    if (r.strain >= from) {
      strength.end += r.sin_phi;
      ++count;
    }
  strength.end /= count;
  return strength;
}

std::string to_lines(const std::vector<MixtureRecord>& records) {
  std::string text;
  for (const MixtureRecord& r : records) {
    char line[200];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%g,%g,%.17g,%.17g\n", r.strain, r.sin_phi,
                  r.volumetric_strain, r.breaks[0], r.breaks[1], r.hardin[0], r.hardin[1]);
    text += line;
  }
  return text;
}

std::vector<MixtureRecord> from_lines(const std::string& text) {
  std::vector<MixtureRecord> records;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    MixtureRecord r;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &r.strain, &r.sin_phi,
                    &r.volumetric_strain, &r.breaks[0], &r.breaks[1], &r.hardin[0],
                    &r.hardin[1]) == 7)
      records.push_back(r);
  }
  return records;
}

std::string key_of(const Mixture& m) {
  std::ostringstream text;
  text.precision(17);
  const auto rock = [&](const RockOfSample& r) {
    text << ", " << r.compressive_strength << " Pa, " << r.m_b << ", " << r.young << " Pa, "
         << r.poisson << ", " << r.density << " kg/m3, " << r.friction;
  };
  text << "# weak share " << m.weak_share << ", " << m.particles << " particles, " << m.pressure
       << " Pa, strain " << m.strain << ", seed " << m.seed;
  rock(m.rock);
  rock(m.weak_rock);
  return text.str();
}

}  // namespace two_rocks
