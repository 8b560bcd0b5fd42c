// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The program of a biaxial test, stage by stage.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/scope_exit.hpp>
#include <riprap/experiment/biaxial_result.hpp>
#include <riprap/experiment/pressure_servo.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/dimensionless.hpp>
#include <riprap/measurement/energy.hpp>

namespace riprap::internal {

/// The stages of one biaxial test.
template <class Test, class Sim, class... Observers>
class BiaxialRun {
 public:
  BiaxialRun(const Test& test, Sim& sim, std::remove_reference_t<Observers>&... observers)
      : test_(test), sim_(sim), observers_(observers...),
        step_observers_(std::tuple_cat(if_of_step(observers)...)),
        view_{.sim = sim, .confining_pressure = test.confining_pressure} {
    view_.mean_diameter = equivalent_diameter(sim.mean_area());
  }

  BiaxialResult run() {
    {
      const ScopeExit breakage([this, wanted = sim_.breakage()] { sim_.set_breakage(wanted); });
      sim_.set_breakage(false);
      stage(Stage::compaction, [&] { return compact(); });
      stage(Stage::relaxation, [&] { return relax(); });
    }
    stage(Stage::hydrostatic, [&] { return pressurise(); });
    stage(Stage::shear, [&] { return shear(); });
    // Not if the stop came with the last step.
    result_.interrupted = view_.interrupted && !outcome(Stage::shear).reached_target;
    return result_;
  }

 private:
  static constexpr unsigned check_interval = 128;  // steps
  static constexpr unsigned quiet_checks = 8;      // in a row that end the hydrostatic stage

  [[nodiscard]] double rate_at(double inertia, double pressure) const {
    return inertia / inertial_number(1, view_.mean_diameter, sim_.rock().density, pressure);
  }
  [[nodiscard]] double sample_stiffness() const {
    return 0.5 * sim_.contact_law().peak_stiffness() / sim_.particles().thickness();
  }
  // The time that a pressure wave takes from the boundary to the centre.
  [[nodiscard]] double servo_response() const {
    return Vec2(region().semi_axes()).maxCoeff() *
           std::sqrt(sim_.rock().density / sample_stiffness());
  }
  [[nodiscard]] auto region() const { return sim_.boundary().region(sim_.particles()); }
  [[nodiscard]] Stress2 stress() const {
    try {
      return average_stress(sim_.contacts(), view_.area, sim_.particles().thickness(),
                            sim_.model().execution_policy);
    } catch (const InvalidInput& error) {
      throw SimulationError(error.what());
    }
  }

  // Throws SimulationError if energies are not finite or the sample has dispersed.
  void check_sample() const {
    const double energy = kinetic_energy(sim_.particles()) + stored_energy(sim_.contacts());
    if (!std::isfinite(energy))
      throw SimulationError("kinetic and stored energy are no longer finite");
    const auto sample = region();
    const Vec2 centre = centre_of(sample);
    const double far = 4 * Vec2(sample.semi_axes()).norm();
    if constexpr (!Sim::Domain::periodic)
      for (BodyIndex i = 0; i < sim_.particles().size(); ++i) {
        const double distance = (sim_.particles().body(i).position - centre).norm();
        if (sim_.particles().body(i).is_free() && !(distance <= far))
          throw SimulationError(particle_text(sim_.particles().ancestry(i).id) +
                                " has been thrown out of the sample: " + to_text(distance) +
                                " m from its centre");
      }
  }

  [[nodiscard]] double unbalanced_force() const {
    return state_averages(sim_.contacts(), sim_.particles(), sim_.body_force()).unbalanced_force;
  }

  template <class Program>
  void stage(Stage stage, Program&& program) {
    if (view_.interrupted) return;
    view_.stage = stage;
    view_.done = 0;
    view_.stretch = {1, 1};
    first_area_ = region().area();
    view_.area = first_area_;
    set_rate({0, 0});
    notify([&](auto& o) { hooks::begin_stage(o, view_); });
    const std::uint64_t first_step = sim_.steps();
    const auto begun = std::chrono::steady_clock::now();
    view_.reached_target = program();
    outcome(stage).reached_target = view_.reached_target;
    outcome(stage).steps = sim_.steps() - first_step;
    outcome(stage).wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (!view_.interrupted) view_.done = 1;
    notify([&](auto& o) { hooks::end_stage(o, view_); });
  }

  [[nodiscard]] BiaxialResult::StageResult& outcome(Stage stage) {
    return result_.stages[static_cast<std::size_t>(stage)];
  }

  void step() {
    const std::size_t breaks = sim_.breaks().size();
    std::apply([&](auto&... o) { sim_.step(o...); }, step_observers_);
    view_.stretch -= sim_.time_step() * componentwise_product(view_.rate, view_.stretch);
    view_.area = first_area_ * view_.stretch.x() * view_.stretch.y();
    for (std::size_t i = breaks; i < sim_.breaks().size(); ++i)
      notify([&](auto& o) { hooks::record_break(o, view_, sim_.breaks()[i]); });
    // Steps with breaks take long.
    if (breaks != sim_.breaks().size()) progress(view_.done);
    notify([&](auto& o) { view_.interrupted |= hooks::stop_requested(o, view_); });
  }
  void set_rate(const Vec2& rate) {
    view_.rate = rate;
    sim_.boundary().set_rate(rate.x(), rate.y());
  }
  // The share only ever grows, whatever estimate it comes from.
  void progress(double done) {
    view_.done = std::clamp(done, view_.done, 1.0);
    notify([&](auto& o) { hooks::progress(o, view_); });
  }
  template <class Call>
  void notify(Call&& call) {
    std::apply([&](auto&... o) { (call(o), ...); }, observers_);
  }

  // Steps, each after `steer()`, until `finished()`, called at intervals, returns true; false if
  // the cap on steps or a stop came first.
  template <class Steer, class Finished>
  bool step_until(Steer&& steer, Finished&& finished) {
    for (std::uint64_t n = 1; n <= test_.most_steps; ++n) {
      steer();
      step();
      if (view_.interrupted) return false;
      if (n % check_interval != 0) continue;
      check_sample();
      if (finished()) return true;
    }
    return false;
  }

  // Constant rate, without friction where the law has friction, until slow and under stress. All
  // particles start with the velocity of the field, so that the sample contracts as a whole.
  bool compact() {
    const double rate = rate_at(test_.compaction_inertial_number, test_.jam_pressure);
    auto& law = sim_.contact_law();
    constexpr bool exchangeable = std::is_copy_assignable_v<std::remove_reference_t<decltype(law)>>;
    const ScopeExit friction([&law, original = law] {
      if constexpr (exchangeable) law = original;
    });
    if constexpr (exchangeable) law = frictionless(law);
    const Vec2 centre = centre_of(region());
    for (BodyIndex i = 0; i < sim_.particles().size(); ++i)
      if (const Body& body = sim_.particles().body(i); body.is_free())
        sim_.set_velocity(i, -rate * (body.position - centre));
    set_rate({rate, rate});
    // A jammed sample of sharp polygons fills about 0.8 of its boundary polygon.
    const double solid = region().solid_area();
    const double distance = std::log(view_.area * 0.8 / solid);
    const bool jammed =
        step_until([] {},
                   [&] {
                     progress(-std::log(view_.stretch.x() * view_.stretch.y()) / distance);
                     return stress().mean() >= test_.jam_pressure &&
                            kinetic_energy(sim_.particles()) <=
                                test_.jam_kinetic_ratio * stored_energy(sim_.contacts());
                   });
    if (!jammed && !view_.interrupted)
      throw SimulationError("compaction did not jam within " + std::to_string(test_.most_steps) +
                            " steps: mean stress " + to_text(stress().mean()) + " Pa");
    return jammed;
  }

  bool relax() {
    const double first = unbalanced_force();
    return step_until([] {},
                      [&] {
                        const double now = unbalanced_force();
                        progress(std::log(now / first) /
                                 std::log(test_.rest_unbalanced_force / first));
                        return now < test_.rest_unbalanced_force;
                      });
  }

  bool pressurise() {
    const double p = test_.confining_pressure;
    const double limit = 2 * rate_at(test_.inertial_number, p);
    PressureServo servo_1(sample_stiffness(), servo_response(), limit);
    PressureServo servo_2(sample_stiffness(), servo_response(), limit);
    const double first = std::abs(p - stress().mean());
    unsigned quiet = 0;
    const auto steer = [&] {
      const Stress2 s = stress();
      set_rate(
          {servo_1.rate(p - s.s11, sim_.time_step()), servo_2.rate(p - s.s22, sim_.time_step())});
    };
    const bool reached = step_until(steer, [&] {
      const Stress2 s = stress();
      const double miss = std::max(std::abs(s.s11 - p), std::abs(s.s22 - p)) / p;
      progress(0.9 * (1 - std::abs(p - s.mean()) / first));
      const bool good = miss <= test_.hydrostatic_tolerance &&
                        unbalanced_force() < test_.hydrostatic_unbalanced_force;
      quiet = good ? quiet + 1 : 0;
      return quiet >= quiet_checks;
    });
    outcome(Stage::hydrostatic).saturated_steps = servo_1.saturated() + servo_2.saturated();
    return reached;
  }

  // Constant rate of engineering strain along axis 2, reached smoothly; the servo holds axis 1.
  bool shear() {
    const double p = test_.confining_pressure;
    const double rate = rate_at(test_.inertial_number, p);
    const double ramp = servo_response();
    const double begun = sim_.time();
    PressureServo servo(sample_stiffness(), ramp, 10 * rate);
    double error_sum = 0;
    double error_squares = 0;
    std::uint64_t steps = 0;
    double next_record = test_.record_every;
    result_.axial_rate = rate;
    record();
    while (view_.axial_strain() < test_.axial_strain && !view_.interrupted) {
      const double error = stress().s11 / p - 1;
      error_sum += error;
      error_squares += error * error;
      const double reached = std::min(1.0, (sim_.time() - begun + sim_.time_step()) / ramp);
      set_rate({servo.rate(-error * p, sim_.time_step()), reached * rate / view_.stretch.y()});
      step();
      ++steps;
      view_.mean_confinement_error = error_sum / static_cast<double>(steps);
      view_.saturated_share = static_cast<double>(servo.saturated()) / static_cast<double>(steps);
      if (steps % check_interval == 0) {
        check_sample();
        progress(view_.axial_strain() / test_.axial_strain);
      }
      if (view_.axial_strain() >= next_record || view_.axial_strain() >= test_.axial_strain ||
          view_.interrupted) {
        record();
        next_record += test_.record_every;
      }
    }
    outcome(Stage::shear).saturated_steps = servo.saturated();
    if (steps > 0) {
      result_.mean_confinement_error = view_.mean_confinement_error;
      result_.rms_confinement_error = std::sqrt(error_squares / static_cast<double>(steps));
    }
    return view_.axial_strain() >= test_.axial_strain &&
           std::abs(result_.mean_confinement_error) <= test_.confinement_tolerance;
  }

  void record() {
    check_sample();
    notify([&](auto& o) { hooks::record(o, view_); });
  }

  // A tuple of an observer that has hooks of a step, or of none.
  template <class O>
  [[nodiscard]] static auto if_of_step(O& observer) {
    if constexpr (hooks::StepHooks<std::remove_cv_t<O>, Sim>::any)
      return std::tie(observer);
    else
      return std::tuple<>{};
  }

  const Test& test_;
  Sim& sim_;
  std::tuple<std::remove_reference_t<Observers>&...> observers_;
  decltype(std::tuple_cat(
      if_of_step(std::declval<std::remove_reference_t<Observers>&>())...)) step_observers_;
  BiaxialView<Sim> view_;
  double first_area_ = 0;
  BiaxialResult result_;
};

}  // namespace riprap::internal
