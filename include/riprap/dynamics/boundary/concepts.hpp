// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the boundary: what moves the bodies that do not obey Newton's law.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

namespace requirements {

/// `boundary.drive(bodies, time_step)` sets velocities at the start of a step [s]; it must leave
/// free bodies alone. It need not be const: a boundary may keep time or a servo's state.
template <class B>
concept BoundaryDrive = requires(B& boundary, std::vector<Body>& bodies, const double time_step) {
  boundary.drive(bodies, time_step);
};

/// `boundary.set_rate(axis_1, axis_2)`: shortening rates [1/s], positive in compression, from the
/// next step on. A servo sets them anew at every step.
template <class B>
concept SampleBoundaryRate = requires(B& boundary) { boundary.set_rate(0.0, 0.0); };

/// `boundary.region(particles)`: the sample as it stands, read at once: `.area()` [m^2], which
/// shrinks at the sum of the two rates, `.semi_axes()` along axes 1 and 2 [m], `.solid_area()` of
/// rock in it, dust included [m^2], `.lost()`, how many free particles have left it. Const:
/// observers call it, too. Optional: `.centre()` [m], the point that its strain leaves where it is;
/// without it, the origin.
template <class B>
concept SampleBoundaryRegion = requires(const B& boundary, const Particles& particles) {
  { boundary.region(particles).area() } -> std::convertible_to<double>;
  { boundary.region(particles).semi_axes() } -> std::convertible_to<Vec2>;
  { boundary.region(particles).solid_area() } -> std::convertible_to<double>;
  { boundary.region(particles).lost() } -> std::convertible_to<std::size_t>;
};

/// Optional: `boundary.enclose(assembly, particles)`, called once, before the first step; throws
/// InvalidInput for an assembly that it cannot bound. Another signature would be ignored
/// silently.
template <class B>
concept BoundaryEnclose = !requires {
  &B::enclose;
} || requires(B& boundary, const Assembly& assembly, const Particles& particles) {
  boundary.enclose(assembly, particles);
};

/// Optional: `boundary.remove(i)`, called before body i is removed between two steps: those behind
/// it move up by one. Throws InvalidInput for a body that the boundary needs. Another signature
/// would be ignored silently.
template <class B>
concept BoundaryRemove =
    !requires { &B::remove; } || requires(B& boundary, const BodyIndex i) { boundary.remove(i); };

/// Optional: `boundary.domain()` and `boundary.drift(time_step)`, which brings the domain to the
/// next poses, once a step: the simulation runs in a periodic cell.
template <class B>
concept BoundaryDomain = !requires(B& boundary) { boundary.domain(); } ||
                         requires(B& boundary, const B& still, const double time_step) {
                           { still.domain() } -> std::convertible_to<PeriodicDomain>;
                           boundary.drift(time_step);
                         };

}  // namespace requirements

/// A `Boundary` sets the velocities of driven bodies at the start of every step. The simulation
/// books the work of the contacts on them.
template <class B>
concept Boundary =
    Policy<B> && requirements::BoundaryDrive<B> && requirements::BoundaryEnclose<B> &&
    requirements::BoundaryRemove<B> && requirements::BoundaryDomain<B>;

template <class B>
consteval bool check_boundary() {
  check_policy<B>();
  static_assert(requirements::BoundaryDrive<B>,
                "riprap: a Boundary must have void drive(std::vector<Body>&, double)");
  static_assert(requirements::BoundaryEnclose<B>,
                "riprap: enclose of a Boundary must take (const Assembly&, const Particles&)");
  static_assert(requirements::BoundaryRemove<B>,
                "riprap: remove of a Boundary must take a BodyIndex");
  static_assert(
      requirements::BoundaryDomain<B>,
      "riprap: a Boundary with a domain() must have PeriodicDomain domain() const and void "
      "drift(double)");
  return Boundary<B>;
}

/// A `SampleBoundary` encloses a sample and strains it: what a biaxial test needs.
template <class B>
concept SampleBoundary =
    Boundary<B> && requirements::SampleBoundaryRate<B> && requirements::SampleBoundaryRegion<B>;

template <class B>
consteval bool check_sample_boundary() {
  static_assert(requirements::SampleBoundaryRate<B>,
                "riprap: the boundary of a BiaxialTest must have void set_rate(double, double), as "
                "StrainField, RigidPlatens and PeriodicCell do");
  static_assert(requirements::SampleBoundaryRegion<B>,
                "riprap: the boundary of a BiaxialTest must have region(const Particles&) const "
                "with area(), semi_axes(), solid_area() and lost()");
  return SampleBoundary<B>;
}

/// Where the strain of a sample moves nothing [m].
template <class Region>
[[nodiscard]] Vec2 centre_of(const Region& region) {
  if constexpr (requires { region.centre(); })
    return region.centre();
  else
    return {0, 0};
}

/// Throws InvalidInput, naming the first body of this motion and the rule.
inline void refuse_motion(const Particles& particles, Motion motion, std::string_view rule) {
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).motion == motion)
      throw InvalidInput(particle_text(particles.ancestry(i).id) + ": " + std::string(rule));
}

/// Area of the free particles and of dust, which stays in the pores [m^2].
[[nodiscard]] inline double rock_area(const Particles& particles) {
  ExactSum sum;
  sum.add(particles.dust_area());
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free()) sum.add(particles.shape(i).area);
  return sum.value();
}

}  // namespace riprap
