// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Runs that were never made: every number follows a formula, in one world as the paper has it and
/// in the other the opposite way.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <paper/results/results.hpp>

namespace riprap::test {

/// How a made-up study is; the curves are of no physical meaning.
struct World {
  bool as_claimed = true;
  int samples = 3;
  /// Below this pressure [Pa] breakage changes nothing.
  double breakage_from = 0;
};

/// One run of a world.
class MadeUpRun {
 public:
  MadeUpRun(const World& world, report::Mode mode, std::size_t pressure_index, int seed)
      : world_(world), p_(static_cast<double>(pressure_index)) {
    run_.mode = mode;
    run_.pressure = report::pressures[pressure_index];
    run_.seed = seed;
    run_.particles = 500;
    broken_ = mode != report::Mode::nb && run_.pressure >= world.breakage_from;
    add_curves();
    add_events();
  }
  [[nodiscard]] const report::Run& run() const { return run_; }

 private:
  // A small scatter, the same for all numbers of a run; runs that breakage leaves alone are those
  // without breakage.
  [[nodiscard]] double scatter() const {
    const int own = broken_ ? 5 * static_cast<int>(run_.mode) : 0;
    return 1e-4 * ((run_.seed * 7 + static_cast<int>(p_) * 3 + own) % 4 - 1.5);
  }
  [[nodiscard]] double pick(double claimed, double opposite) const {
    return world_.as_claimed ? claimed : opposite;
  }
  [[nodiscard]] double effect(double claimed, double opposite) const {
    return broken_ ? pick(claimed, opposite) : 0;
  }
  static double share(double from, double strain, double to) {
    return std::clamp((strain - from) / (to - from), 0.0, 1.0);
  }

  [[nodiscard]] double coordination(double e) const {
    const double kept = effect(0.1 + 0.04 * p_, -0.3 + 0.04 * p_);
    if (!world_.as_claimed)
      return 4 - 0.1 * p_ - 0.05 * share(0, e, 0.001) + (0.5 + kept) * e / 0.2;
    const double fall = (1 - kept) * (1 - std::exp(-std::max(0.0, e - 0.01) / 0.03));
    return 4 + 0.1 * p_ + 0.05 * share(0, e, 0.005) - fall;
  }
  [[nodiscard]] double volume(double e) const {
    const double end =
        pick(-0.08 + 0.01 * p_, 0.02 - 0.01 * p_) + effect(0.01 + 0.004 * p_, -0.01 - 0.004 * p_);
    return end * e / 0.2;
  }
  [[nodiscard]] double a(double e) const {
    const double late = share(0.1, e, 0.2) * p_;
    if (world_.as_claimed)
      return (0.45 - 0.03 * p_ - (broken_ ? 0.12 : 0)) * (1 - std::exp(-e / 0.1)) +
             (broken_ ? 0.034 * late : 0);
    return (0.1 + 0.03 * p_ + (broken_ ? 0.2 : 0)) * (1 - e / 0.4) - (broken_ ? 0.034 * late : 0);
  }
  [[nodiscard]] double a_n(double e) const {
    const double level =
        pick(0.9 - 0.03 * p_ - (p_ > 3 ? 0.25 : 0), 0.05 + 0.002 * p_) + effect(-0.05, 0.01);
    const double slowness = pick(0.004 + 0.006 * p_, 0.034 - 0.006 * p_);
    const bool loses = world_.as_claimed ? p_ <= 3 : p_ > 3;
    return level * (1 - std::exp(-e / slowness)) * (loses ? 1 - 0.25 * share(0.05, e, 0.15) : 1);
  }
  [[nodiscard]] double a_t(double e) const {
    const double level = pick(0.4 - 0.02 * p_, 0.3 + 0.02 * p_) + effect(-0.02, 0.05);
    if (!world_.as_claimed) return level * e / 0.2;
    return level * share(0, e, 0.02) * (1 - 0.25 * share(0.03, e, 0.15));
  }
  [[nodiscard]] double sin_phi(double e) const {
    const double steep = 0.02 * std::max(0.0, p_ - 3);
    const double peak =
        pick(0.65 - 0.005 * p_ - steep, 0.5 + 0.005 * p_ + steep) + effect(-0.02, 0.02);
    const double at = pick(0.05 + 0.015 * p_, 0.125 - 0.015 * p_);
    return peak * (1 - (e - at) * (e - at) / 0.04);
  }

  void add_curves() {
    for (int i = 0; i <= 80; ++i) {
      const double e = 0.0025 * i;
      const auto add = [&](const char* name, double value) { run_.curve[name].push_back(value); };
      add("axial_strain", e);
      add("coordination_number", coordination(e) + scatter());
      add("contacts_per_particle", coordination(e) / 2);
      add("volumetric_strain", volume(e) + scatter());
      add("a", a(e) + scatter());
      add("a_n", a_n(e) + scatter());
      add("a_t", a_t(e) + scatter());
      const double friction = sin_phi(e) + scatter();
      add("sin_phi", friction);
      add("sigma_22_Pa", pick(run_.pressure * (1 + friction) / (1 - friction),
                              1e12 / run_.pressure * (1 + friction)));
      add("sin_phi_eq_14",
          friction + pick(0.01, 0.05 + 0.005 * p_) + effect(-0.001, 0.01) + scatter());
      add("sin_phi_eq_15", friction + pick(0.03, 0.01) + scatter());
      add("sin_phi_full", friction + 0.005);
    }
  }

  void add_events() {
    const int count = broken_ ? static_cast<int>(pick(20 + 20 * p_, 120 - 20 * p_)) + run_.seed : 0;
    const int in_centre = static_cast<int>(pick(0.05, 0.5) * count);
    for (int i = 0; i < count; ++i)
      run_.breaks.push_back({.in_shear = true,
                             .radius_share = i < in_centre ? 0.2 : 0.7,
                             .crack_length = 0.01,
                             .band_share = pick(0.95, 0.3) + scatter()});
    if (broken_ && world_.as_claimed)
      run_.breaks.resize(run_.breaks.size() + 10, {.in_shear = false, .radius_share = 0.5});
    run_.rat_at_shear_start.assign(100, 0.1);
    run_.ring_displacement = {1, 3, 5, 7, 9 + scatter()};
    if (!world_.as_claimed)
      std::reverse(run_.ring_displacement.begin(), run_.ring_displacement.end());
    run_.force_axial = {100, pick(250, 80) + 1000 * scatter()};
    run_.force_side = {100, pick(105, 150)};
    run_.shear = {band(0.06, pick(0.9, 0.6)), band(0.18, pick(0.6, 0.9) + scatter())};
  }

  // Twenty particles in a straight band among 180 on a grid; as claimed it is inclined.
  [[nodiscard]] report::ShearWindow band(double strain, double half_length) const {
    report::ShearWindow window{.axial_strain = strain, .particles = {}};
    const double angle = pick(1, 0);
    const auto add = [&](const Vec2& place, double shear) {
      window.particles.push_back({place, place, shear});
    };
    for (int i = 0; i < 20; ++i)
      add((i - 9.5) / 9.5 * half_length * Vec2{std::cos(angle), std::sin(angle)}, 1);
    for (int i = 0; i < 12; ++i)
      for (int k = 0; k < 15; ++k) add({-0.9 + 1.8 * i / 11, -0.9 + 1.8 * k / 14}, 0);
    return window;
  }

  World world_;
  double p_ = 0;
  bool broken_ = false;
  report::Run run_;
};

/// All pressures, with and without breakage.
[[nodiscard]] inline report::Results made_up_study(const World& world) {
  report::Results results;
  for (const report::Mode mode : {report::Mode::nb, report::Mode::wb})
    for (std::size_t p = 0; p < report::pressures.size(); ++p)
      for (int seed = 1; seed <= world.samples; ++seed)
        results.runs.push_back(MadeUpRun(world, mode, p, seed).run());
  return results;
}

/// What such a run would leave as run.json.
[[nodiscard]] inline report::Json run_json(const report::Run& run) {
  report::Json curve = run.curve;
  for (std::size_t i = 0; i < run.column("sin_phi").size(); ++i) {
    curve["sigma_11_Pa"].push_back(run.pressure);
    curve["porosity"].push_back(0.2);
  }
  report::Json breaks = report::Json::array();
  for (const report::Break& b : run.breaks)
    breaks.push_back({{"stage", b.in_shear ? "shear" : "hydrostatic"},
                      {"radius_share", b.radius_share},
                      {"crack_m", b.crack_length},
                      {"band_share", b.band_share ? report::Json(*b.band_share) : report::Json()}});
  report::Json shear = report::Json::array();
  for (const report::ShearWindow& w : run.shear) {
    report::Json window = {{"axial_strain", w.axial_strain}, {"stretch_at_begin", {1, 1}}};
    for (const report::ShearedParticle& p : w.particles) {
      window["x_share"].push_back(p.unstrained.x());
      window["y_share"].push_back(p.unstrained.y());
      window["shear"].push_back(p.shear);
    }
    shear.push_back(window);
  }
  const std::string mode = run.mode == report::Mode::nb ? "nb" : "wb";
  return {{"mode", mode},
          {"variation", run.variation},
          {"pressure_Pa", run.pressure},
          {"seed", run.seed},
          {"particles", run.particles},
          {"wall_s", 60},
          {"curve", curve},
          {"breaks", breaks},
          {"rat_at_shear_start", run.rat_at_shear_start},
          {"relaxed_state", run.relaxed_state},
          {"movement", {{"mean_displacement_m", run.ring_displacement}}},
          {"normal_forces",
           {{"mean_near_axis_2_N", run.force_axial}, {"mean_near_axis_1_N", run.force_side}}},
          {"shear_around", shear},
          {"grading",
           {{"size_m", {0.01, 0.02}},
            {"finer_before", {0, 1}},
            {"finer_after", {0.1, 1}},
            {"marsal_b_g", 0.1}}},
          {"numbers", {{"kappa", 1e-3}, {"energy_error", nullptr}}},
          {"warnings", {"made up"}},
          {"parameters", {{"motion", {{"friction", 0.5}}}}}};
}

}  // namespace riprap::test
