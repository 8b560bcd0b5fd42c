// SPDX-License-Identifier: BSL-1.0
#pragma once
// An observer that catches one break and draws how it came about (Fig. 9).

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/simulation/break_event.hpp>

#include "../../single_particle/analysis.hpp"
#include "plan.hpp"

namespace study {

// Draws a break that was taken from a run, after finding it anew: throws SimulationError if the
// analysis of the particle alone finds another crack than the run did.
void draw_process(const Case& particle, const riprap::BreakEvent& event,
                  const std::filesystem::path& file);

// Catches the first break in shear of a particle with three contacts or more at 2 MPa.
class BreakProcess {
 public:
  explicit BreakProcess(const RunPlan& plan) : wanted_(plan.pressure == 2e6) {}

  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) {
    watching_ = wanted_ && view.stage == riprap::Stage::shear;
  }

  // Contacts are still those of the particles that are about to break.
  template <class Sim>
  void before_splits(const Sim& sim) {
    if (!watching_) return;
    particles_ = sim.particles();
    loads_.assign(particles_->size(), {});
    sim.contacts().for_each_touching([&](const auto& c) {
      const riprap::Vec2 on_b = c.force_on_b();
      loads_[c.a].push_back({particles_->body(c.a).position + c.arm_a, -on_b, c.force.normal});
      loads_[c.b].push_back({particles_->body(c.b).position + c.arm_b, on_b, c.force.normal});
    });
    rock_ = sim.rock();
    mean_area_ = sim.mean_area();
  }

  template <class Sim>
  void on_break(const Sim& /*sim*/, const riprap::BreakEvent& event) {
    if (!watching_) return;
    for (riprap::BodyIndex i = 0; i < particles_->size(); ++i)
      if (particles_->ancestry(i).id == event.particle.id && loads_[i].size() >= 3) {
        const riprap::Ring ring = particles_->ring(i);
        caught_ = Case{.polygon = riprap::ConvexPolygon({ring.begin(), ring.end()}),
                       .forces = loads_[i],
                       .rock = rock_,
                       .thickness = particles_->thickness(),
                       .rotation = particles_->body(i).rotation,
                       .mean_area = mean_area_};
        event_ = event;
        watching_ = false;
        return;
      }
  }

  // Draws what was caught, if anything.
  void save(const std::filesystem::path& folder) const {
    if (caught_) draw_process(*caught_, event_, folder / "particle_process.svg");
  }

 private:
  bool wanted_;
  bool watching_ = false;
  std::optional<riprap::Particles> particles_;
  std::vector<std::vector<PointForce>> loads_;  // by body
  riprap::Rock rock_;
  double mean_area_ = 0;
  std::optional<Case> caught_;
  riprap::BreakEvent event_;
};

}  // namespace study
