// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle under its contact loads, as triggers and line fits see it.

#include <span>

#include <riprap/breakage/failure/criterion_view.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/mean_stress_of_loads.hpp>

namespace riprap {

/// Read-only view, valid during one call of a policy. Nothing is computed before it is asked for.
class LoadedParticle {
 public:
  /// Of particle i. @param loads on it, over its strength factor
  LoadedParticle(const Particles& particles, BodyIndex i, std::span<const ContactLoad> loads,
                 const Rock& rock, const CriterionView& criterion)
      : particles_(particles), index_(i), loads_(loads), rock_(rock), criterion_(criterion) {}

  [[nodiscard]] ParticleId id() const { return particles_.ancestry(index_).id; }
  [[nodiscard]] const Body& body() const { return particles_.body(index_); }
  /// Vertices, counter-clockwise, and centroid, in laboratory coordinates [m].
  [[nodiscard]] Ring ring() const { return particles_.ring(index_); }
  [[nodiscard]] const Vec2& centroid() const { return body().position; }
  [[nodiscard]] double area() const { return particles_.shape(index_).area; }  ///< [m^2]
  [[nodiscard]] double thickness() const { return particles_.thickness(); }    ///< [m]
  /// Of which it consists, and the place of it in the list of rocks.
  [[nodiscard]] const Rock& rock() const { return rock_; }
  [[nodiscard]] MaterialIndex material() const { return particles_.material(index_); }
  /// The criterion of the model; that of the rock where it has one for each.
  [[nodiscard]] const CriterionView& criterion() const { return criterion_; }

  /// Contact loads in the order of the contacts: `force_lab` on the particle [N], `arm_lab` from
  /// the centroid to the point of contact [m], in laboratory axes. Forces are divided by the
  /// strength factors of the rock and, where the trigger has one, of the particle.
  [[nodiscard]] std::span<const ContactLoad> loads() const { return loads_; }
  /// Point of contact of a load, in laboratory coordinates [m].
  [[nodiscard]] Vec2 point(const ContactLoad& load) const { return centroid() + load.arm_lab; }
  /// Mean stress under the loads, with inertia relief [Pa], compression positive, laboratory axes.
  [[nodiscard]] Stress2 mean_stress() const {
    return riprap::mean_stress(loads_, ring(), centroid(), area(), thickness());
  }

 private:
  const Particles& particles_;
  BodyIndex index_;
  std::span<const ContactLoad> loads_;
  const Rock& rock_;
  const CriterionView& criterion_;
};

}  // namespace riprap
