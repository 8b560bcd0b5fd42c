#pragma once
// What the two impulse engines share: units, time step and how the ring is driven.

#include <algorithm>

#include "packing.hpp"

namespace peers {

inline constexpr double frame = 1.0 / 60;        // time step [s], the customary one
inline constexpr double strain_per_step = 1e-5;  // along axis 2
inline constexpr int settling_steps = 200;       // from riprap's packing to the engine's own
inline constexpr int timed_steps = 200;

// Engines want bodies of about a metre: lengths are divided by the mean diameter.
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

}  // namespace peers
