// SPDX-License-Identifier: BSL-1.0
#pragma once
// How far a number of runs is: on a terminal a line that is rewritten, elsewhere one now and then.

#include <chrono>
#include <string>

namespace run_table {

class ProgressLine {
 public:
  // `work` of all runs, in any unit.
  explicit ProgressLine(double work);

  // A run that is so much of the work.
  void begin(const std::string& name, double work);
  // The share of the run that is done.
  void at(double share);
  // All is done.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void print(double share) const;

  double work_;
  double ended_ = 0;
  double present_ = 0;
  std::string name_{};
  bool in_place_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_ = begun_;
};

}  // namespace run_table
