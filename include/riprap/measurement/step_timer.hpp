// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which part of a step takes how much of the time.

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>

#include <riprap/core/step_phase.hpp>

namespace riprap {

/// An observer that measures time. Reads a clock some ten times a step, which slows small samples
/// (0.3 us a step); a simulation without it reads none.
///
///     StepTimer timer;
///     for (int i = 0; i < 1000; ++i) sim.step(timer);
///     timer.print();
class StepTimer {
 public:
  /// What has passed since the last call was `part`.
  void on_phase_end(StepPhase part) {
    const Clock::time_point now = Clock::now();
    seconds_[index(part)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  template <class Sim>
  void after_step(const Sim& sim) {
    particle_steps_ += sim.particles().size();
  }

  [[nodiscard]] double seconds(StepPhase part) const { return seconds_[index(part)]; }
  [[nodiscard]] double seconds() const {
    double sum = 0;
    for (const double s : seconds_) sum += s;
    return sum;
  }
  /// Particles times steps since the start.
  [[nodiscard]] std::uint64_t particle_steps() const { return particle_steps_; }

  /// A line for every part: share of the time and nanoseconds a particle and step.
  void print(std::FILE* out = stdout) const {
    const double all = seconds();
    const double each = particle_steps_ == 0 ? 0 : 1e9 / static_cast<double>(particle_steps_);
    std::fprintf(out, "part of the step       share   ns/particle-step\n");
    for (std::size_t i = 0; i < step_phase_count; ++i)
      std::fprintf(out, "%-20s %6.1f %%  %12.1f\n", to_text(static_cast<StepPhase>(i)),
                   all > 0 ? 100 * seconds_[i] / all : 0.0, each * seconds_[i]);
    std::fprintf(out, "%-20s %6.1f %%  %12.1f\n", "all", 100.0, each * all);
  }

  /// No state of a simulation: time is measured anew after a restart.
  static void for_each_field(auto&, auto&&) {}

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] static std::size_t index(StepPhase part) { return static_cast<std::size_t>(part); }

  std::array<double, step_phase_count> seconds_{};
  Clock::time_point last_ = Clock::now();
  std::uint64_t particle_steps_ = 0;
};

}  // namespace riprap
