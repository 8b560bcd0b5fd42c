// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A sample so small that everything measured on it has a closed form: one free square held between
/// four driven ones.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_list.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/body_force/uniform_body_force.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>

namespace riprap::test {

/// The squares and how they lie: the free one, of half side `half`, is body 0 at the origin; bodies
/// 1 to 4 have their centroids at `reach` to the east, north, west and south, and their sizes are
/// such that they overlap it by `depths` (negative: a gap).
struct Cross {
  std::array<double, 4> depths{1e-5, 1e-5, 1e-5, 1e-5};  ///< [m]
  double half = 0.008;                                   ///< [m]
  double reach = 0.012;                                  ///< [m]
  double thickness = 0.016;                              ///< [m]
  double slide = 0;  ///< counter-clockwise shift of the driven squares' centroids [m]
  double turn = 0;   ///< of the whole sample about the origin [rad]

  [[nodiscard]] double driven_half(std::size_t i) const { return depths[i] + reach - half; }

  [[nodiscard]] Assembly assembly() const {
    const auto square = [this](const Vec2& c, double h) {
      return ConvexPolygon{c + Vec2{-h, -h}, c + Vec2{h, -h}, c + Vec2{h, h}, c + Vec2{-h, h}}
          .moved(Rotation::from_angle(turn), {0, 0});
    };
    Assembly out{.thickness = thickness, .particles = {{square({0, 0}, half)}}};
    const std::array<Vec2, 4> outward{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    for (std::size_t i = 0; i < 4; ++i)
      out.particles.push_back(
          {square(reach * outward[i] + slide * perpendicular(outward[i]), driven_half(i)),
           Motion::strain_field});
    return out;
  }
};

/// The default springs, beside which every motion of a contact loses energy by decree.
struct LossySprings : LinearSpringCoulomb {
  double loss = 0;  ///< booked as lost in dashpots [J]

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    ContactForce force = LinearSpringCoulomb::operator()(geometry, motion, history);
    if (motion.time_step > 0) force.viscous_loss = loss;
    return force;
  }
};
static_assert(ContactLaw<LossySprings>);

/// What an observer of a biaxial test reads of a simulation, in a state set by hand.
class StillSample {
 public:
  using Contacts = ContactList<UniformGrid, OverlapChord, LossySprings>;
  struct Work {
    double boundary = 0;
    double body_force = 0;
    double damping = 0;
    double load = 0;
    double added = 0;
  };

  explicit StillSample(const Cross& cross = {}, const LinearSpringCoulomb& law = {})
      : particles_(cross.thickness, 2500),
        contacts_(UniformGrid{}, OverlapChord{}, LossySprings{law}) {
    for (const PlacedParticle& p : cross.assembly().particles) particles_.add(p.polygon, p.motion);
    contacts_.update(particles_, 0);
  }

  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Contacts& contacts() const { return contacts_; }
  [[nodiscard]] const Contacts& interactions() const { return contacts_; }
  [[nodiscard]] const StrainField& boundary() const { return boundary_; }
  [[nodiscard]] const std::vector<BreakEvent>& breaks() const { return breaks_; }
  [[nodiscard]] const Work& work() const { return work_; }
  [[nodiscard]] double time_step() const { return time_step_; }
  [[nodiscard]] const UniformBodyForce& body_force() const { return body_force_; }

  [[nodiscard]] Body& body(BodyIndex i) { return particles_.body(i); }
  [[nodiscard]] std::vector<BreakEvent>& breaks() { return breaks_; }
  [[nodiscard]] Work& work() { return work_; }
  void set_time_step(double seconds) { time_step_ = seconds; }
  void set_loss(double joules) { contacts_.law().loss = joules; }
  void set_body_force(const Vec2& acceleration) { body_force_ = {acceleration}; }
  /// Loads the tangential springs: the driven squares have slid counter-clockwise by this much [m]
  /// on their way to where they are.
  void slide(double distance) {
    for (BodyIndex i = 1; i < 5; ++i)
      particles_.body(i).velocity = distance * perpendicular(particles_.body(i).position) /
                                    particles_.body(i).position.norm();
    contacts_.update(particles_, 1);
    for (BodyIndex i = 1; i < 5; ++i) particles_.body(i).velocity = Vec2{0, 0};
  }

 private:
  Particles particles_;
  Contacts contacts_;
  StrainField boundary_;
  std::vector<BreakEvent> breaks_;
  Work work_;
  UniformBodyForce body_force_{};
  double time_step_ = 1e-6;
};

/// The view that the run of a biaxial test would pass to its observers in shear.
[[nodiscard]] inline BiaxialView<StillSample> view_of(const StillSample& sample) {
  BiaxialView<StillSample> view{.sim = sample, .stage = Stage::shear};
  view.confining_pressure = 2e6;
  view.mean_diameter = 0.016;
  view.area = sample.boundary().region(sample.particles()).area();
  return view;
}

}  // namespace riprap::test
