// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Boundary particles that follow a homogeneous strain-rate field: the default.

#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/dynamics/boundary/boundary_polygon.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// Moves every body of Motion::strain_field with v = -rate x about the centre of their ring,
/// without rotation (a freely turning ring acts as a roller bearing and lowers the peak strength).
/// The sample is what the polygon through their centroids encloses.
class StrainField {
 public:
  /// Shortening rates along axes 1 and 2 [1/s], positive in compression.
  void set_rate(double axis_1, double axis_2) {
    require_finite("StrainField: rate along axis 1", axis_1);
    require_finite("StrainField: rate along axis 2", axis_2);
    rate_ = {axis_1, axis_2};
  }
  [[nodiscard]] const Vec2& rate() const { return rate_; }

  void drive(std::vector<Body>& bodies, double /*time_step*/) const {
    for (Body& body : bodies)
      if (body.motion == Motion::strain_field) {
        body.velocity = -componentwise_product(rate_, body.position - centre_);
        body.angular_velocity = 0;
      }
  }

  /// Throws InvalidInput for platens.
  void enclose(const Assembly& /*assembly*/, const Particles& particles) {
    refuse_motion(particles, Motion::platen, "StrainField moves no platens; RigidPlatens does");
    centre_ = ring_centre(particles);
  }

  [[nodiscard]] BoundaryPolygon region(const Particles& particles) const {
    return {particles, centre_};
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("rate", self.rate_);
    visit("centre", self.centre_);
  }

 private:
  Vec2 rate_{0, 0};
  Vec2 centre_{0, 0};  // fixed point of the field
};

static_assert(SampleBoundary<StrainField>);

}  // namespace riprap
