// SPDX-License-Identifier: BSL-1.0
#include "progress_line.hpp"

#include <unistd.h>

#include <cstdio>

#include "work_through.hpp"

namespace run_table {

ProgressLine::ProgressLine(double work) : work_(work), in_place_(isatty(fileno(stderr)) != 0) {}

void ProgressLine::begin(const std::string& name, double work) {
  ended_ += present_;
  present_ = work;
  name_ = name;
  print(0);
}

void ProgressLine::at(double share) {
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < (in_place_ ? 0.25 : 20)) return;
  last_ = now;
  print(share);
}

void ProgressLine::end() {
  print(1);
  if (in_place_) std::fputc('\n', stderr);
}

void ProgressLine::print(double share) const {
  const double done = (ended_ + share * present_) / work_;
  const double elapsed = std::chrono::duration<double>(Clock::now() - begun_).count();
  std::string line = std::to_string(static_cast<int>(100 * done)) + " %  " + duration_text(elapsed);
  // An estimate from the first per cent is worth nothing.
  if (done > 0.01 && done < 1)
    line += ", about " + duration_text(elapsed * (1 - done) / done) + " left";
  line += "  " + name_;
  if (in_place_)
    std::fprintf(stderr, "\r%-78.78s", line.c_str());
  else
    std::fprintf(stderr, "%s\n", line.c_str());
  std::fflush(stderr);
}

}  // namespace run_table
