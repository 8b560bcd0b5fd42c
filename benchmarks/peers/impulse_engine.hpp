// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the two impulse engines share: units, time step, how the ring is driven, the program.

#include <algorithm>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "packing.hpp"
#include "result.hpp"

namespace peers {

inline constexpr double frame = 1.0 / 60;        // time step [s], the customary one
inline constexpr double strain_per_step = 1e-5;  // along axis 2
inline constexpr int settling_steps = 200;       // from riprap's packing to the engine's own
inline constexpr int timed_steps = 200;

// Tolerances of the engines are for bodies of about a metre: lengths are divided by the mean
// diameter.
[[nodiscard]] inline std::vector<Vec2> scaled(Ring ring, double unit) {
  std::vector<Vec2> out;
  for (const Vec2& v : ring) out.push_back(v / unit);
  return out;
}

// Rigid bodies have no stiffness and so no pressure to hold. In its place the sample widens faster
// or slower, so that its grains keep as many contacts as riprap's.
class Widening {
 public:
  explicit Widening(const Packing& packing)
      : wanted_(packing.coordination), mean_(-packing.lateral_rate / packing.axial_rate) {}

  // Velocity of the ring at x.
  [[nodiscard]] Vec2 field(const Vec2& x) const {
    constexpr double rate = strain_per_step / frame;
    return {rate * ratio_ * x.x(), -rate * x.y()};
  }
  void steer(double coordination) {
    ratio_ = std::clamp(mean_ + 2 * (coordination - wanted_), -3.0, 3.0);
  }

 private:
  double wanted_;
  double mean_;
  double ratio_ = mean_;
};

// The whole program of an engine: `program PACKING` prints a line of results under `name`.
template <class Engine>
int time_engine(const std::string& program, const std::string& name, int count,
                char** arguments) try {
  if (count != 2) throw std::runtime_error(program + " PACKING");
  const Packing packing = read(arguments[1]);
  Engine engine(packing);
  const auto step = [&] { engine.step(); };
  const auto steer = [&] { engine.steer(); };
  (void)time_steps(settling_steps, packing.assembly.particles.size(), step, steer);
  const double ns = time_steps(timed_steps, packing.assembly.particles.size(), step, steer);
  const ContactCount contacts = engine.contacts();
  print_result(name, {{"ns", ns},
                      {"coordination", contacts.coordination()},
                      {"overlap", contacts.mean_depth()},
                      {"time_step", frame}});
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}

}  // namespace peers
