// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Normal impact with cyclic tangential displacement: the axioms of a contact law are checked on
/// it.

#include <cmath>
#include <numbers>

#include <riprap/contact/contact_law/concepts.hpp>

namespace riprap {

/// The contacts for which a law is meant, and over which its axioms are checked.
struct ContactRange {
  double deepest = 1e-4;         ///< penetration [m]
  double longest_chord = 0.016;  ///< [m]
  double effective_mass = 4e-3;  ///< [kg]
};

namespace internal {

/// One instant of a collision.
struct CollisionInstant {
  ContactGeometry geometry;
  ContactMotion motion;
};

inline constexpr int collision_steps = 4000;

/// Two faces of the longest chord, or the right-angled corner of one body in a face of the other,
/// `way` into each other [m]; the depth of faces may grow faster than that.
[[nodiscard]] inline ContactGeometry contact_of(const ContactRange& range, bool corner, double way,
                                                double face_gradient = 1) {
  const double chord = corner ? 2 * way : range.longest_chord;
  const double gradient = corner ? 1 : face_gradient;
  return {.normal = {0.6, 0.8},
          .point = {range.longest_chord, -range.longest_chord},
          .depth = gradient * way,
          .area = corner ? way * way : chord * way,
          .chord = chord,
          .depth_gradient = gradient};
}

/// Loading and unloading along the normal, with cyclic tangential displacement large enough for
/// slip. Velocities are the differences of places, so that work is known exactly.
/// @param duration of the collision [s]
template <class Visit>
void visit_collision(const ContactRange& range, bool corner, double duration, Visit&& visit) {
  using std::numbers::pi;
  constexpr int n = collision_steps;
  const double time_step = duration / n;
  const double face_gradient = std::numbers::sqrt2;  // as OverlapMoments gives two faces
  const auto depth = [&](int i) { return range.deepest * std::pow(std::sin(pi * i / n), 2); };
  const auto slide = [&](int i) { return 3 * range.deepest * std::sin(7 * pi * i / n); };
  for (int i = 1; i <= n; ++i)
    visit(CollisionInstant{contact_of(range, corner, depth(i), face_gradient),
                           {.normal_velocity = (depth(i - 1) - depth(i)) / time_step,
                            .tangential_velocity = (slide(i) - slide(i - 1)) / time_step,
                            .time_step = time_step,
                            .effective_mass = range.effective_mass}});
}

/// As long as a free collision with the law's stiffest spring: dashpots matter as they do in use.
template <ContactLaw Law>
[[nodiscard]] double collision_time(const Law& law, const ContactRange& range) {
  return std::numbers::pi * std::sqrt(range.effective_mass / law.peak_stiffness());
}

}  // namespace internal
}  // namespace riprap
