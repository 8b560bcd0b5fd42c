// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// No boundary at all: a cell that repeats itself and is strained as a whole.

#include <algorithm>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// One cell of a periodic assembly.
class PeriodicRegion {
 public:
  PeriodicRegion(const Particles& particles, const PeriodicDomain& domain)
      : particles_(particles), period_(domain.period), centre_(domain.centre) {}

  [[nodiscard]] double area() const { return period_.prod(); }               ///< [m^2]
  [[nodiscard]] const Vec2& centre() const { return centre_; }               ///< [m]
  [[nodiscard]] Vec2 semi_axes() const { return 0.5 * period_; }             ///< [m]
  [[nodiscard]] double solid_area() const { return rock_area(particles_); }  ///< [m^2]
  /// None can leave: what goes out on one side is what comes in on the other.
  [[nodiscard]] std::size_t lost() const { return 0; }

 private:
  const Particles& particles_;
  Vec2 period_;
  Vec2 centre_;
};

/// Takes the cell of the assembly and strains it about its centre at the rates that are set, by
/// shortening along both axes and by simple shear (Lees and Edwards 1972). Images move with the
/// cell; particles follow through their contacts. Positions are never wrapped, and the offset of
/// the rows of images is not reduced, so that no contact changes its images at any shear strain.
class PeriodicCell {
 public:
  /// Shortening rates along axes 1 and 2 [1/s], positive in compression.
  void set_rate(double axis_1, double axis_2) {
    require_finite("PeriodicCell: rate along axis 1", axis_1);
    require_finite("PeriodicCell: rate along axis 2", axis_2);
    domain_.rate = {axis_1, axis_2};
  }
  [[nodiscard]] const Vec2& rate() const { return domain_.rate; }

  /// Rate of simple shear dv_1/dx_2 [1/s], twice the tensor component: above 0, what lies higher on
  /// axis 2 moves towards +1, and the stress component s12 that resists is negative (compression
  /// is positive).
  void set_shear_rate(double rate) {
    require_finite("PeriodicCell: shear rate", rate);
    domain_.shear_rate = rate;
  }
  [[nodiscard]] double shear_rate() const { return domain_.shear_rate; }

  /// Throws InvalidInput if the assembly is not periodic, has a boundary of its own, or lies
  /// elsewhere than its cell.
  void enclose(const Assembly& assembly, const Particles& particles) {
    for (const Motion motion : {Motion::strain_field, Motion::platen})
      refuse_motion(particles, motion, "a PeriodicCell has no boundary bodies");
    require_positive("PeriodicCell: Assembly.period along axis 1", assembly.period.x());
    require_positive("PeriodicCell: Assembly.period along axis 2", assembly.period.y());
    domain_.period = assembly.period;
    domain_.centre = assembly.centre;
    domain_.shear_offset = assembly.shear_offset;
    const auto is_near = [&](const Body& body) {
      const Vec2 away = componentwise_abs(body.position - assembly.centre);
      return away.x() <= assembly.period.x() && away.y() <= assembly.period.y();
    };
    if (std::none_of(particles.bodies().begin(), particles.bodies().end(), is_near))
      throw InvalidInput("PeriodicCell: no particle lies within a period of Assembly.centre = (" +
                         to_text(assembly.centre.x()) + ", " + to_text(assembly.centre.y()) +
                         ") m");
  }

  void drive(std::vector<Body>&, double) const {}

  [[nodiscard]] const PeriodicDomain& domain() const { return domain_; }
  void drift(double time_step) { domain_.drift(time_step); }

  [[nodiscard]] PeriodicRegion region(const Particles& particles) const {
    return {particles, domain_};
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("domain", self.domain_); }

 private:
  PeriodicDomain domain_;
};

static_assert(SampleBoundary<PeriodicCell>);

}  // namespace riprap
