// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the boundary.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/dynamics/integrator/concepts.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {
namespace internal {

inline constexpr double boundary_step = 1e-5;  ///< [s]

template <class B>
concept StrainsPlane = requires(B& boundary) {
  boundary.domain();
  boundary.drift(boundary_step);
};

/// The bodies of `assembly`, enclosed by the boundary, all at rest.
template <Boundary B>
[[nodiscard]] Particles enclosed(B& boundary, const Assembly& assembly) {
  Particles particles(assembly.thickness, Rock{}.density);
  for (const PlacedParticle& p : assembly.particles) particles.add(p.polygon, p.motion);
  if constexpr (requires { boundary.enclose(assembly, particles); })
    boundary.enclose(assembly, particles);
  return particles;
}

/// Images move as their domain says, at set rates, and under simple shear if the boundary has it.
template <StrainsPlane B>
void check_images(B& boundary, AxiomCheck& check) {
  using Image = PeriodicDomain::Image;
  if constexpr (requires { boundary.set_shear_rate(0.0); }) boundary.set_shear_rate(7);
  const PeriodicDomain before = boundary.domain();
  boundary.drift(boundary_step);
  const PeriodicDomain after = boundary.domain();
  for (const Image& image : {Image{1, 0}, Image{0, 1}, Image{-2, 3}}) {
    const Vec2 way = boundary_step * before.velocity(image);
    const double off = (after.offset(image) - before.offset(image) - way).norm();
    // Terms of the second order, whatever the scheme, and round-off.
    const double gradient =
        std::abs(before.rate.x()) + std::abs(before.rate.y()) + std::abs(before.shear_rate);
    const double strain = boundary_step * gradient;
    check.at_most("an image moves at the velocity of its domain", off,
                  (4 * strain * strain + 1e-12) * before.offset(image).norm());
  }
  if constexpr (requires { boundary.set_shear_rate(0.0); })
    check.equal("simple shear has the rate that was set", after.shear_rate, 7, 0);
}

/// Velocities of driven bodies and nothing else, while free ones fly about. False if there are not
/// as many bodies as before: nothing else can be checked then.
template <Boundary B>
[[nodiscard]] bool check_drive(B& boundary, Particles particles, AxiomCheck& check) {
  Random random(1);
  for (Body& body : particles.bodies())
    if (body.is_free()) {
      body.velocity = Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
      body.angular_velocity = random.uniform(-1, 1);
    }
  const std::vector<Body> before = particles.bodies();
  boundary.drive(particles.bodies(), boundary_step);
  check.equal("drive neither adds bodies nor takes any away", static_cast<double>(particles.size()),
              static_cast<double>(before.size()), 0);
  for (std::size_t i = 0; i < before.size() && i < particles.size(); ++i) {
    const Body& body = particles.bodies()[i];
    const Body& was = before[i];
    check.holds("drive leaves free bodies alone",
                !was.is_free() || (body.velocity == was.velocity &&
                                   body.angular_velocity == was.angular_velocity));
    check.holds("drive moves no body itself", body.position == was.position &&
                                                  body.rotation.cosine == was.rotation.cosine &&
                                                  body.rotation.sine == was.rotation.sine);
    check.holds("a body stays what it is",
                body.motion == was.motion && body.mass == was.mass && body.inertia == was.inertia);
  }
  return particles.size() == before.size();
}

/// A step in which free bodies rest.
template <Boundary B>
void step_boundary(B& boundary, Particles& particles) {
  boundary.drive(particles.bodies(), boundary_step);
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    if (particles.body(i).is_free()) continue;
    drift(particles.body(i), boundary_step);
    particles.update_ring(i);
  }
  if constexpr (StrainsPlane<B>) boundary.drift(boundary_step);
}

/// Relative growth of the region along the axes and in area over a step at these rates [1/s].
template <SampleBoundary B>
void check_strain(B& boundary, Particles& particles, const Vec2& rate, AxiomCheck& check) {
  const double area = boundary.region(particles).area();
  const Vec2 axes = boundary.region(particles).semi_axes();
  boundary.set_rate(rate.x(), rate.y());
  step_boundary(boundary, particles);
  const double growth = double(boundary.region(particles).area()) / area - 1;
  const Vec2 stretch = Vec2(boundary.region(particles).semi_axes()).cwiseQuotient(axes);

  const Vec2 strain = boundary_step * rate;
  // Terms of the second order, whatever the scheme, and round-off.
  const double tolerance = 4 * strain.squaredNorm() + 1e-12;
  check.equal("the area shrinks at the sum of the rates", growth, -strain.sum(), tolerance);
  check.equal("axis 1 shortens at its rate", stretch.x() - 1, -strain.x(), tolerance);
  check.equal("axis 2 shortens at its rate", stretch.y() - 1, -strain.y(), tolerance);
}

template <SampleBoundary B>
void check_region(B& boundary, Particles& particles, AxiomCheck& check) {
  const double area = boundary.region(particles).area();
  const double solid = boundary.region(particles).solid_area();
  const auto lost = [&] {
    const std::size_t count = boundary.region(particles).lost();
    return static_cast<double>(count);
  };
  check.at_least("the solid area in the region is above 0", solid, 1e-12 * area);
  check.at_most("the solid area is no more than that of the region", solid, area);
  check.equal("what lies inside is not lost", lost(), 0, 0);
  if constexpr (!StrainsPlane<B>)
    for (Body& body : particles.bodies())
      if (body.is_free()) {
        body.position += 100 * Vec2(boundary.region(particles).semi_axes());
        check.equal("a free particle far away is lost", lost(), 1, 0);
        return;
      }
}

}  // namespace internal

/// Which axioms a boundary breaks about `assembly`, one that it can bound. A SampleBoundary is
/// to strain it, too: the assembly must be loose, its free particles within the region.
template <Boundary B>
[[nodiscard]] Violations boundary_violations(B boundary, const Assembly& assembly) {
  AxiomCheck check;
  Particles particles = internal::enclosed(boundary, assembly);
  if constexpr (SampleBoundary<B>) boundary.set_rate(10, 4);
  if (!internal::check_drive(boundary, particles, check)) return std::move(check).violations();
  if constexpr (SampleBoundary<B>) {
    for (const Vec2& rate : {Vec2{10, 4}, Vec2{0, 10}, Vec2{0, 0}, Vec2{-10, 0}, Vec2{-4, 10}}) {
      check.at("rate along axis 1", rate.x());
      internal::check_strain(boundary, particles, rate, check);
    }
    internal::check_region(boundary, particles, check);
  }
  if constexpr (internal::StrainsPlane<B>) internal::check_images(boundary, check);
  return std::move(check).violations();
}

}  // namespace riprap
