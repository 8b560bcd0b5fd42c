#pragma once
/// @file
/// Tells a person at a terminal how far a biaxial test is.

#include <chrono>
#include <cstdio>
#include <string>

#include <riprap/experiment/range_check.hpp>
#include <riprap/experiment/stage.hpp>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace riprap {

/// An observer of BiaxialTest that prints stage, share done, time left in the stage, breakages and
/// warnings to standard error: on a terminal a line that is rewritten, elsewhere a line now and then.
class Progress {
 public:
  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    begun_ = last_ = Clock::now();
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
    if (in_place_) std::fputc('\n', stderr);
    check_.end_stage(view);
    print_warnings();
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] static bool is_terminal() {
#if __has_include(<unistd.h>)
    return isatty(STDERR_FILENO) != 0;
#else
    return false;
#endif
  }

  template <class Sim>
  void print(const BiaxialView<Sim>& view) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begun_).count();
    std::string line = to_text(view.stage);
    line.resize(12, ' ');
    line += percent(view.done) + "  " + seconds(elapsed);
    // An estimate from the first per cent is worth nothing.
    if (view.done > 0.01 && view.done < 1)
      line += ", " + seconds(elapsed * (1 - view.done) / view.done) + " left";
    if (view.stage == Stage::shear) {
      line += "  strain " + percent(view.axial_strain());
      line += "  breakages " + std::to_string(view.sim.breaks().size());
    }
    if (in_place_)
      std::fprintf(stderr, "\r%-78s", line.c_str());
    else
      std::fprintf(stderr, "%s\n", line.c_str());
    std::fflush(stderr);
  }

  void print_warnings() {
    for (; warned_ < check_.warnings().size(); ++warned_)
      std::fprintf(stderr, "%swarning: %s\n", in_place_ ? "\n" : "",
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

  bool in_place_ = is_terminal();
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
  RangeCheck check_;
  std::size_t warned_ = 0;
};

}  // namespace riprap
