// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A loading path on its way: step by step, stopped and continued.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/path_parameters.hpp>
#include <riprap/experiment/path_result.hpp>
#include <riprap/experiment/sample_check.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/experiment/stage_parts.hpp>
#include <riprap/measurement/mean_diameter.hpp>

namespace riprap {

/// The run of a loading path, one step at a time. All that the next step depends on is in its
/// fields and in the simulation: a run made on a restored simulation, with its fields overwritten
/// and `restored()` called, goes on to the same bytes. Refers to simulation and observers, which
/// must outlive it. At its end, also an early one, the simulation gets breakage and its contact
/// law back as they were.
template <class StageT, class Sim, class... Observers>
class PathRun {
 public:
  using View = LoadingView<Sim>;

  PathRun(double confining_pressure, std::vector<StageT> stages, Sim& sim, Observers&... observers)
      : stages_(std::move(stages)), sim_(sim), observers_(observers...),
        step_observers_(std::tuple_cat(if_of_step(observers)...)),
        view_{.sim = sim, .confining_pressure = confining_pressure}, law_(sim.contact_law()),
        breakage_(sim.breakage()) {
    view_.mean_diameter = mean_particle_diameter(sim);
    result_.stages.resize(stages_.size());
    describe_stage();
  }
  PathRun(const PathRun&) = delete;
  PathRun& operator=(const PathRun&) = delete;
  ~PathRun() {
    if (!finished() && result_.stages.front().begun) give_back();
  }

  /// Makes one step. False once the path is finished: no step is left.
  bool advance() {
    while (!finished() && !open_) open_stage();
    if (finished()) return false;
    make_step();
    return !finished();
  }
  /// All steps that are left.
  PathResult run() {
    while (advance()) {
    }
    return result_;
  }

  /// Ends the path after the step just made, as an observer's `stop_requested` would have.
  void stop() {
    if (finished()) return;
    view_.interrupted = true;
    if (open_) {
      if (stage().records && last_record_ != sim_.steps()) record();
      close_stage(false);
    } else {
      result_.interrupted = true;
      give_back();
    }
  }

  [[nodiscard]] bool finished() const { return index_ == stages_.size() || result_.interrupted; }
  [[nodiscard]] const PathResult& result() const { return result_; }
  [[nodiscard]] const View& view() const { return view_; }

  /// What must be the same where the path goes on: all but how far its last stage goes.
  static void for_each_parameter(auto& self, auto&& visit) {
    visit("confining_pressure", self.view_.confining_pressure);
    internal::name_path_parameters(self.stages_, visit);
  }
  static void for_each_field(auto& self, auto&& visit) {
    visit("stage", self.index_);
    visit("open", self.open_);
    visit("view", self.view_);
    visit("zero_area", self.zero_area_);
    visit("record_from", self.record_from_);
    visit("next_record", self.next_record_);
    visit("last_record", self.last_record_);
    visit("law", self.law_);
    visit("frictionless", self.frictionless_);
    visit("breakage", self.breakage_);
    visit("interrupted", self.result_.interrupted);
    for (std::size_t k = 0; k < self.stages_.size(); ++k) {
      visit(("result_" + std::to_string(k)).c_str(), self.result_.stages[k]);
      visit(("controls_" + std::to_string(k)).c_str(), self.stages_[k]);
    }
  }
  /// After the fields have been overwritten.
  void restored() {
    describe_stage();
    view_.known_stress.reset();
    clock_ = Clock::now();
    if (finished()) return;
    if (open_) sim_.set_breakage(stage().breakage && breakage_);
    if constexpr (exchangeable)
      if (frictionless_) sim_.contact_law() = riprap::frictionless(law_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Law = std::remove_cvref_t<decltype(std::declval<Sim&>().contact_law())>;
  static constexpr bool exchangeable = std::is_copy_assignable_v<Law>;
  static constexpr unsigned check_interval = 128;  // steps

  [[nodiscard]] StageT& stage() { return stages_[index_]; }
  [[nodiscard]] auto region() const { return sim_.boundary().region(sim_.particles()); }

  // What the view says of the stage as the path has it.
  void describe_stage() {
    if (index_ == stages_.size()) return;
    view_.stage = stage().part;
    view_.stage_name = stage().name;
    view_.stage_index = index_;
    view_.loading_stage = static_cast<std::size_t>(
        std::ranges::count(stages_.begin(), stages_.begin() + static_cast<std::ptrdiff_t>(index_),
                           Stage::loading, &StageT::part));
  }

  void open_stage() {
    describe_stage();
    open_ = true;
    sim_.set_breakage(stage().breakage && breakage_);
    view_.done = 0;
    view_.reached_target = false;
    view_.mean_confinement_error = 0;
    view_.saturated_share = 0;
    view_.stage_steps = 0;
    view_.stage_begun = sim_.time();
    view_.at_check = false;
    view_.known_stress.reset();
    if (stage().zero_strain || view_.loading_stage == 0) {
      view_.stretch = {1, 1};
      zero_area_ = region().area();
      view_.area = zero_area_;
    }
    set_rate({0, 0});
    notify([&](auto& o) { hooks::begin_stage(o, view_); });
    result_.stages[index_].begun = true;
    clock_ = Clock::now();
    begin_parts();
    record_from_ = view_.strain(stage().record_axis);
    next_record_ = stage().record_every;
    if (stage().records && last_record_ != sim_.steps()) record();
    const bool reached = internal::ask_variant(stage().end, view_);
    if (reached || view_.interrupted) close_stage(reached);
  }

  void begin_parts() {
    if constexpr (exchangeable)
      if (!stage().friction) {
        law_ = sim_.contact_law();
        frictionless_ = true;
        sim_.contact_law() = riprap::frictionless(law_);
      }
    internal::begin_parts(stage(), view_);
  }

  void make_step() {
    set_rate(internal::wanted_rates(stage(), view_));
    if (stage().affine_start && view_.stage_steps == 0)
      internal::set_affine_velocities(sim_, view_.rate, centre_of(region()));
    step();
    internal::account(stage(), view_, result_.stages[index_]);
    if (view_.at_check) {
      internal::check_sample(sim_);
      tick();
      progress(internal::share_done_of(stage().end, view_));
    }
    const bool reached = internal::ask_variant(stage().end, view_);
    const bool capped = !reached && view_.stage_steps >= stage().most_steps;
    const bool last = reached || capped || view_.interrupted;
    if (stage().records && (last || record_is_due())) {
      record();
      next_record_ += stage().record_every;
    }
    if (capped && !view_.interrupted && stage().at_cap == AtCap::error)
      throw SimulationError(stage().name + " did not reach its end within " +
                            std::to_string(stage().most_steps) + " steps: mean stress " +
                            to_text(view_.stress().mean()) + " Pa");
    if (last) close_stage(reached);
  }

  void step() {
    const std::size_t breaks = sim_.breaks().size();
    internal::naming_stage(
        stage().name, [&] { std::apply([&](auto&... o) { sim_.step(o...); }, step_observers_); });
    view_.stretch -= sim_.time_step() * componentwise_product(view_.rate, view_.stretch);
    view_.area = zero_area_ * view_.stretch.x() * view_.stretch.y();
    view_.known_stress.reset();
    ++view_.stage_steps;
    view_.at_check = view_.stage_steps % check_interval == 0;
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

  [[nodiscard]] bool record_is_due() {
    const StageT& s = stage();
    return (s.record_every > 0 &&
            std::abs(view_.strain(s.record_axis) - record_from_) >= next_record_) ||
           (s.record_every_steps > 0 && view_.stage_steps % s.record_every_steps == 0);
  }
  void record() {
    internal::check_sample(sim_);
    last_record_ = sim_.steps();
    notify([&](auto& o) { hooks::record(o, view_); });
  }

  void close_stage(bool reached) {
    give_back_friction();
    tick();
    view_.reached_target = reached && internal::are_held(stage());
    result_.stages[index_].reached_target = view_.reached_target;
    if (!view_.interrupted) view_.done = 1;
    notify([&](auto& o) { hooks::end_stage(o, view_); });
    open_ = false;
    ++index_;
    // Not if the stop came with the last step.
    result_.interrupted = view_.interrupted && (index_ < stages_.size() || !view_.reached_target);
    if (finished()) give_back();
  }

  void give_back_friction() {
    if constexpr (exchangeable)
      if (std::exchange(frictionless_, false)) sim_.contact_law() = law_;
  }
  void give_back() {
    give_back_friction();
    sim_.set_breakage(breakage_);
  }

  void tick() {
    const auto last = std::exchange(clock_, Clock::now());
    result_.stages[index_].wall_seconds += std::chrono::duration<double>(clock_ - last).count();
  }
  // The share only ever grows, whatever estimate it comes from.
  void progress(double done) {
    if (done > view_.done) view_.done = std::min(done, 1.0);
    notify([&](auto& o) { hooks::progress(o, view_); });
  }
  template <class Call>
  void notify(Call&& call) {
    std::apply([&](auto&... o) { (call(o), ...); }, observers_);
  }

  // A tuple of an observer that has hooks of a step, or of none.
  template <class O>
  [[nodiscard]] static auto if_of_step(O& observer) {
    if constexpr (hooks::HasStepHook<std::remove_cv_t<O>, Sim>)
      return std::tie(observer);
    else
      return std::tuple<>{};
  }

  std::vector<StageT> stages_;
  Sim& sim_;
  std::tuple<Observers&...> observers_;
  decltype(std::tuple_cat(if_of_step(std::declval<Observers&>())...)) step_observers_;
  View view_;
  Law law_;        // before friction was taken away
  bool breakage_;  // of the simulation, where a stage does not forbid it
  bool open_ = false;
  bool frictionless_ = false;
  std::size_t index_ = 0;  // of the stage
  double zero_area_ = 0;   // [m^2]
  double record_from_ = 0;
  double next_record_ = 0;
  std::uint64_t last_record_ = std::numeric_limits<std::uint64_t>::max();  // sim.steps()
  PathResult result_;
  Clock::time_point clock_ = Clock::now();  // of the last tick; not state
};

}  // namespace riprap
