// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Tells a person at a terminal how far a test is.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/experiment/validity_check.hpp>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace riprap {

/// An observer of a test that prints stage, share done, time left in the stage, breakages
/// of shear and warnings: on a terminal a line that is rewritten, elsewhere a line now and then.
class Progress {
 public:
  explicit Progress(std::FILE* out = stderr, const Limits& limits = {})
      : out_(out), in_place_(is_terminal(out)), check_(limits) {}

  /// Everything that left its range so far.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return check_.warnings(); }
  /// Every number that is checked, beside its limit.
  [[nodiscard]] ValidityCheck& check() { return check_; }

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    begun_ = last_ = Clock::now();
    breaks_before_ = view.sim.breaks().size();
    check_.begin_stage(view);
    print_warnings();
    print(view);
  }
  template <class Sim>
  void progress(const BiaxialView<Sim>& view) {
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < (in_place_ ? 0.25 : 10)) return;
    last_ = now;
    print(view);
  }
  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    check_.record(view);
    print_warnings();
  }
  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    print(view);
    if (in_place_) std::fputc('\n', out_);
    check_.end_stage(view);
    print_warnings();
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("breaks_before", self.breaks_before_);
    visit("check", self.check_);
    visit("warned", self.warned_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] static bool is_terminal([[maybe_unused]] std::FILE* out) {
#if __has_include(<unistd.h>)
    return isatty(fileno(out)) != 0;
#else
    return false;
#endif
  }

  template <class Sim>
  [[gnu::cold]] void print(const BiaxialView<Sim>& view) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begun_).count();
    std::string line(view.name());
    line.resize(std::max<std::size_t>(12, line.size() + 2), ' ');
    line += percent(view.done) + "  " + seconds(elapsed);
    // An estimate from the first per cent is worth nothing.
    if (view.done > 0.01 && view.done < 1)
      line += ", " + seconds(elapsed * (1 - view.done) / view.done) + " left";
    if (view.stage == Stage::shear) {
      line += "  strain " + percent(view.axial_strain());
      line += "  breakages " + std::to_string(view.sim.breaks().size() - breaks_before_);
    }
    if (in_place_)
      std::fprintf(out_, "\r%-78s", line.c_str());
    else
      std::fprintf(out_, "%s\n", line.c_str());
    std::fflush(out_);
  }

  [[gnu::cold]] void print_warnings() {
    for (; warned_ < check_.warnings().size(); ++warned_)
      std::fprintf(out_, "%swarning: %s\n", in_place_ ? "\n" : "",
                   check_.warnings()[warned_].c_str());
  }

  [[nodiscard]] static std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%5.1f %%", 100 * share);
    return text;
  }
  [[nodiscard]] static std::string seconds(double s) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f s", s);
    return text;
  }

  std::FILE* out_;
  bool in_place_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
  std::size_t breaks_before_ = 0;
  ValidityCheck check_;
  std::size_t warned_ = 0;
};

}  // namespace riprap
