// SPDX-License-Identifier: BSL-1.0
#pragma once
// What a program of the comparison measures and prints: its name, then key=value, tabs in between.

#include <cstddef>
#include <ctime>
#include <initializer_list>
#include <iostream>
#include <string>
#include <utility>

namespace peers {

// CPU time of this process [s].
[[nodiscard]] inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline void print_result(const std::string& name,
                         std::initializer_list<std::pair<const char*, double>> values) {
  std::cout << name;
  for (const auto& [key, value] : values) std::cout << '\t' << key << '=' << value;
  std::cout << std::endl;
}

// Contacts of the free grains: shows that a code has stepped a packing and not an explosion.
class ContactCount {
 public:
  void grain(bool free) { free_ += free; }
  // depth [m]
  void contact(bool free_a, bool free_b, double depth) {
    ends_ += static_cast<std::size_t>(free_a) + static_cast<std::size_t>(free_b);
    depth_ += depth;
    ++contacts_;
  }
  // Mean number of contacts of a free grain.
  [[nodiscard]] double coordination() const {
    return free_ == 0 ? 0 : static_cast<double>(ends_) / static_cast<double>(free_);
  }
  [[nodiscard]] double mean_depth() const {
    return contacts_ == 0 ? 0 : depth_ / static_cast<double>(contacts_);
  }

 private:
  std::size_t free_ = 0;
  std::size_t ends_ = 0;
  std::size_t contacts_ = 0;
  double depth_ = 0;
};

// Steps in timed blocks, with untimed steering between them. Returns ns per grain and step.
template <class Step, class Steer>
[[nodiscard]] double time_steps(int steps, std::size_t grains, Step&& step, Steer&& steer) {
  constexpr int block = 20;
  double seconds = 0;
  int done = 0;
  while (done < steps) {
    const double begun = cpu_seconds();
    for (int i = 0; i < block; ++i) step();
    seconds += cpu_seconds() - begun;
    done += block;
    steer();
  }
  return 1e9 * seconds / static_cast<double>(done) / static_cast<double>(grains);
}

}  // namespace peers
