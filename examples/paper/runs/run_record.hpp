// SPDX-License-Identifier: BSL-1.0
#pragma once
// An observer that keeps what run.json holds beside the curve.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <riprap/core/splitmix64.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/incremental_displacement.hpp>

#include "plan.hpp"

namespace study {

// Equal for equal poses of all bodies, to the last bit.
inline std::string fingerprint(const riprap::Particles& particles) {
  std::uint64_t sum = 0;
  for (const riprap::Body& body : particles.bodies())
    for (const double value : {body.position.x(), body.position.y(), body.rotation.sine})
      sum = riprap::splitmix64(sum ^ std::bit_cast<std::uint64_t>(value));
  return std::to_string(sum);
}

class RunRecord {
 public:
  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) {
    const auto& particles = view.sim.particles();
    radius_ = riprap::Vec2(view.sim.boundary().region(particles).semi_axes()).mean();
    if (view.stage == riprap::Stage::hydrostatic) relaxed_ = fingerprint(particles);
    if (view.stage != riprap::Stage::shear) return;
    movement_.begin(particles);
    if constexpr (Sim::breakable) ratios_ = free_ratios(view.sim);
  }

  template <class Sim>
  void record(const riprap::BiaxialView<Sim>& view) {
    constexpr std::array snapshots{0.0, 0.05, 0.10, 0.20};
    const std::size_t taken = forces_["axial_strain"].size();
    if (taken < snapshots.size() && view.axial_strain() > snapshots[taken] - 1e-9)
      record_forces(view);
    if constexpr (Sim::breakable) record_ratios(view);
  }

  template <class Sim>
  void record_break(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
    movement_.record_break(view, event);
    const riprap::Vec2 place = event.place().cwiseQuotient(view.stretch) / radius_;
    breaks_.push_back({{"stage", riprap::to_text(view.stage)},
                       {"axial_strain", view.axial_strain()},
                       {"radius_share", place.norm()},
                       {"x_share", place.x()},
                       {"y_share", place.y()},
                       {"mode", riprap::to_text(event.mode)},
                       {"area_m2", event.areas[0] + event.areas[1]},
                       {"smaller_piece_m2", std::min(event.areas[0], event.areas[1])},
                       {"crack_m", event.crack_length},
                       {"band_share", nullptr}});
  }

  template <class Sim>
  void end_stage(const riprap::BiaxialView<Sim>& view) {
    if (view.stage == riprap::Stage::shear) moves_ = movement_.moves(view.sim.particles());
  }

  // Adds its part to a run.json.
  void write(Json& run) const {
    run["radius_m"] = radius_;
    run["relaxed_state"] = relaxed_;
    run["breaks"] = breaks_;
    run["rat_at_shear_start"] = ratios_;
    run["rat_in_shear"] = rat_;
    run["movement"] = movement_json();
    run["normal_forces"] = forces_;
  }

 private:
  template <class Sim>
  [[nodiscard]] static std::vector<double> free_ratios(const Sim& sim) {
    const std::vector<double> all = sim.failed_ratios();
    std::vector<double> ratios;
    for (riprap::BodyIndex i = 0; i < sim.particles().size(); ++i)
      if (sim.particles().body(i).is_free()) ratios.push_back(all[i]);
    return ratios;
  }

  template <class Sim>
  void record_ratios(const riprap::BiaxialView<Sim>& view) {
    constexpr std::array snapshots{0.0, 0.005, 0.01, 0.03, 0.05};
    const std::size_t taken = rat_["axial_strain"].size();
    if (taken == snapshots.size() || view.axial_strain() < snapshots[taken] - 1e-9) return;
    const double critical = view.sim.model().breakage_model.trigger.critical;
    const std::vector<double> ratios = free_ratios(view.sim);
    rat_["axial_strain"].push_back(view.axial_strain());
    rat_["largest"].push_back(*std::max_element(ratios.begin(), ratios.end()));
    rat_["at_ratf"].push_back(
        std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r >= critical; }));
  }

  template <class Sim>
  void record_forces(const riprap::BiaxialView<Sim>& view) {
    std::array<double, 2> sum{};
    std::array<double, 2> count{};
    view.sim.contacts().for_each_touching([&](const auto& c) {
      const riprap::Vec2& n = c.geometry.normal;
      const std::size_t axis = std::abs(n.y()) > std::abs(n.x()) ? 1 : 0;
      sum[axis] += c.force.normal;
      count[axis] += 1;
    });
    forces_["axial_strain"].push_back(view.axial_strain());
    forces_["mean_near_axis_2_N"].push_back(sum[1] / count[1]);
    forces_["mean_near_axis_1_N"].push_back(sum[0] / count[0]);
  }

  // Mean distance between start and end, by the ring where a free particle started.
  [[nodiscard]] Json movement_json() const {
    constexpr std::array rings{0.2, 0.4, 0.6, 0.8, 1.0};
    std::array<double, rings.size()> sum{};
    std::array<double, rings.size()> count{};
    for (const riprap::Move& move : moves_) {
      if (!move.is_free) continue;
      std::size_t ring = 0;
      while (ring + 1 < rings.size() && move.from.norm() > rings[ring] * radius_) ++ring;
      sum[ring] += (move.to - move.from).norm();
      count[ring] += 1;
    }
    Json means = Json::array();
    for (std::size_t k = 0; k < rings.size(); ++k) means.push_back(sum[k] / count[k]);
    return {{"ring_outer_share", rings}, {"mean_displacement_m", means}};
  }

  double radius_ = 0;  // at the start of the stage
  std::string relaxed_;
  Json breaks_ = Json::array();
  std::vector<double> ratios_;
  riprap::IncrementalDisplacement movement_;
  std::vector<riprap::Move> moves_;
  // The largest Rat, and how many free particles stand at RatF and more.
  Json rat_ = {
      {"axial_strain", Json::array()}, {"largest", Json::array()}, {"at_ratf", Json::array()}};
  Json forces_ = {{"axial_strain", Json::array()},
                  {"mean_near_axis_2_N", Json::array()},
                  {"mean_near_axis_1_N", Json::array()}};
};

}  // namespace study
