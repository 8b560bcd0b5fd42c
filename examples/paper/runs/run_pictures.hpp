// SPDX-License-Identifier: BSL-1.0
#pragma once
// An observer that draws what the paper draws of this run (Figs 6, 7, 8, 10, 11, 13).

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <riprap/experiment/displacement_paths.hpp>
#include <riprap/experiment/incremental_displacement.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/displacement_picture.hpp>
#include <riprap/output/dot_picture.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/output/movement_picture.hpp>

#include "plan.hpp"

namespace study {

class RunPictures {
 public:
  RunPictures(const RunPlan& plan, std::filesystem::path folder)
      : plan_(plan), folder_(std::move(folder)) {}

  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) {
    if (shows_compaction() && view.stage == riprap::Stage::compaction) paths_.record(view);
    if (view.stage != riprap::Stage::shear) return;
    paths_ = {};
    movement_.begin(view.sim.particles());
    if constexpr (Sim::breakable)
      if (shows_rat()) draw_rat(view, "rat_dots", "at the start of shear");
  }

  template <class Sim>
  void progress(const riprap::BiaxialView<Sim>& view) {
    if (!shows_compaction() || view.stage != riprap::Stage::compaction) return;
    // A few points of each path.
    if (view.done < next_point_) return;
    paths_.record(view);
    next_point_ += 0.2;
  }

  template <class Sim>
  void record(const riprap::BiaxialView<Sim>& view) {
    const double strain = view.axial_strain();
    while (next_ < strains.size() && strain > strains[next_] - 1e-9) {
      if (shows_shear()) paths_.record(view);
      draw_state(view, strains[next_]);
      ++next_;
    }
  }

  template <class Sim>
  void record_break(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
    movement_.record_break(view, event);
    paths_.record_break(view, event);
  }

  template <class Sim>
  void end_stage(const riprap::BiaxialView<Sim>& view) {
    if (shows_compaction() && view.stage == riprap::Stage::compaction) {
      paths_.record(view);
      const auto& particles = view.sim.particles();
      save(riprap::assembly_picture(particles, {}, "Assembly at the end of compaction"),
           "compaction_assembly");
      save(riprap::displacement_picture(particles, paths_, "Paths of the centroids in compaction"),
           "compaction_paths");
    }
    if constexpr (Sim::breakable)
      if (view.stage == riprap::Stage::shear && shows_rat_at_end())
        draw_rat(view, "rat_dots_end", "at the end of shear");
  }

 private:
  // Every second one ends a stretch of 6 % that Fig. 10 shows.
  static constexpr std::array strains{0.0, 0.03, 0.06, 0.09, 0.12, 0.15, 0.18};

  [[nodiscard]] bool shows_compaction() const { return plan_.is(Mode::wb, 2e6); }
  [[nodiscard]] bool shows_shear() const {
    return plan_.is(Mode::nb, 14e6) || plan_.is(Mode::wb, 14e6);
  }
  [[nodiscard]] bool shows_rat() const { return plan_.is(Mode::wb, 0.5e6); }
  [[nodiscard]] bool shows_rat_at_end() const {
    return plan_.is(Mode::wb, 0.5e6) || plan_.is(Mode::wb, 14e6);
  }
  [[nodiscard]] bool shows_microstructure() const {
    return plan_.is(Mode::nb, 2e6) || plan_.is(Mode::wb, 2e6);
  }

  void save(const riprap::Svg& svg, const std::string& name) const {
    svg.save((folder_ / (name + ".svg")).string());
  }
  // "wb, 2 MPa, 6 % strain"
  [[nodiscard]] std::string place(double strain) const {
    return (plan_.mode == Mode::nb ? "without breakage, " : "with breakage, ") +
           pressure_text(plan_.pressure) + ", " + riprap::to_text(std::round(100 * strain)) +
           " % strain";
  }

  template <class Sim>
  void draw_state(const riprap::BiaxialView<Sim>& view, double strain) {
    const auto& particles = view.sim.particles();
    const auto hundredths = static_cast<int>(std::lround(100 * strain));
    if (shows_shear() && hundredths == 18) {
      save(riprap::assembly_picture(particles, {}, "Assembly " + place(strain)),
           "sheared_assembly");
      save(riprap::displacement_picture(particles, paths_, "Paths " + place(strain)),
           "sheared_paths");
    }
    if (!shows_microstructure() || hundredths % 6 != 0) return;
    const std::string number = (hundredths < 10 ? "_0" : "_") + std::to_string(hundredths);
    if (hundredths > 0) {
      save(riprap::movement_picture(particles, movement_.moves(particles),
                                    "Movement in the last 6 %: " + place(strain)),
           "movement" + number);
      movement_.begin(particles);
    }
    if (hundredths == 12) return;
    save(riprap::force_chain_picture(particles, view.sim.contacts(),
                                     "Normal forces " + place(strain)),
         "forces" + number);
    draw_coordination(view, "coordination" + number, strain);
  }

  template <class Sim>
  void draw_coordination(const riprap::BiaxialView<Sim>& view, const std::string& name,
                         double strain) const {
    const auto& particles = view.sim.particles();
    const auto counts = riprap::contact_counts(view.sim.contacts(), particles);
    std::vector<double> values(counts.begin(), counts.end());
    for (riprap::BodyIndex i = 0; i < particles.size(); ++i)
      if (!particles.body(i).is_free()) values[i] = 0;
    save(riprap::dot_picture(
             particles, values,
             {.quantity = "contacts of a particle", .samples = {1, 2, 3, 4, 6, 8}, .full_value = 8},
             "Contacts " + place(strain)),
         name);
  }

  template <class Sim>
  void draw_rat(const riprap::BiaxialView<Sim>& view, const std::string& name,
                const std::string& when) const {
    const double critical = view.sim.model().breakage_model.trigger.critical;
    save(riprap::dot_picture(view.sim.particles(), view.sim.failed_ratios(),
                             {.quantity = "failed share Rat",
                              .samples = {0.05, 0.1, 0.2, 0.4, 0.6},
                              .full_value = 0.6,
                              .critical = critical},
                             "Rat " + when + ", " + pressure_text(plan_.pressure)),
         name);
  }

  RunPlan plan_;
  std::filesystem::path folder_;
  riprap::DisplacementPaths paths_;
  riprap::IncrementalDisplacement movement_;
  double next_point_ = 0.2;
  std::size_t next_ = 0;
};

}  // namespace study
