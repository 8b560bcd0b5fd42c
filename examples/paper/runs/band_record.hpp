// SPDX-License-Identifier: BSL-1.0
#pragma once
// An observer that keeps where shear localised over each 6 % of strain, and how near to it
// particles broke.

#include <array>
#include <cmath>
#include <vector>

#include "plan.hpp"
#include "shear_bands.hpp"

namespace study {

class BandRecord {
 public:
  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) {
    if (view.stage != riprap::Stage::shear) return;
    radius_ = riprap::Vec2(view.sim.boundary().region(view.sim.particles()).semi_axes()).mean();
    begin(view);
  }

  template <class Sim>
  void record(const riprap::BiaxialView<Sim>& view) {
    if (next_ == ends.size() || view.stage != riprap::Stage::shear ||
        view.axial_strain() < ends[next_] - 1e-9)
      return;
    all_ = shear_around(movement_.moves(view.sim.particles()), stretch_);
    windows_.push_back(window_json(view.axial_strain()));
    judge_breaks();
    ++next_;
    begin(view);
  }

  template <class Sim>
  void record_break(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
    movement_.record_break(view, event);
    if (view.stage != riprap::Stage::shear) return;
    waiting_.push_back(event.place().cwiseQuotient(view.stretch));
  }

  // Adds its part to a run.json that has its breaks already.
  void write(Json& run) {
    // What broke behind the last window is compared with that.
    if (!all_.empty()) judge_breaks();
    run["shear_around"] = windows_;
    std::size_t next = 0;
    for (Json& b : run["breaks"])
      if (b["stage"] == riprap::to_text(riprap::Stage::shear) && next < shares_.size())
        b["band_share"] = shares_[next++];
  }

 private:
  static constexpr std::array ends{0.06, 0.12, 0.18};

  template <class Sim>
  void begin(const riprap::BiaxialView<Sim>& view) {
    movement_.begin(view.sim.particles());
    stretch_ = view.stretch;
  }
  // Of every particle, where it was without the strain so far, over the radius, and the shear
  // around it; more digits than that mean nothing.
  [[nodiscard]] Json window_json(double strain) const {
    const auto rounded = [](double value, double unit) { return std::round(value * unit) / unit; };
    Json j = {{"axial_strain", strain},
              {"stretch_at_begin", {stretch_.x(), stretch_.y()}},
              {"x_share", Json::array()},
              {"y_share", Json::array()},
              {"shear", Json::array()}};
    for (const Sheared& s : all_) {
      j["x_share"].push_back(rounded(s.place.x() / radius_, 1e4));
      j["y_share"].push_back(rounded(s.place.y() / radius_, 1e4));
      j["shear"].push_back(rounded(s.shear, 1e5));
    }
    return j;
  }
  void judge_breaks() {
    for (const riprap::Vec2& place : waiting_) shares_.push_back(band_share(all_, place));
    waiting_.clear();
  }

  double radius_ = 1;  // when shear begins [m]
  riprap::Vec2 stretch_{1, 1};
  riprap::IncrementalDisplacement movement_;
  std::size_t next_ = 0;
  std::vector<Sheared> all_;
  std::vector<riprap::Vec2> waiting_;  // where particles broke in this window
  std::vector<double> shares_;         // of all breaks in shear, in their order
  Json windows_ = Json::array();
};

}  // namespace study
