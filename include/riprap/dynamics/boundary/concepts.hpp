#pragma once
/// @file
/// The role of the boundary: what moves the bodies that do not obey Newton's law.

#include <concepts>
#include <cstddef>
#include <vector>

#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

namespace clauses {

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
/// rock in it [m^2], `.lost()`, how many free particles have left it. Const: observers ask, too.
template <class B>
concept SampleBoundaryRegion = requires(const B& boundary, const Particles& particles) {
  { boundary.region(particles).area() } -> std::convertible_to<double>;
  { boundary.region(particles).semi_axes() } -> std::convertible_to<Vec2>;
  { boundary.region(particles).solid_area() } -> std::convertible_to<double>;
  { boundary.region(particles).lost() } -> std::convertible_to<std::size_t>;
};

}  // namespace clauses

/// A `Boundary` sets the velocities of driven bodies at the start of every step. The simulation
/// books the work of the contacts on them.
///
/// Optional:
/// - `boundary.enclose(assembly, particles)`: called once, before the first step; throws
///   InvalidInput for an assembly that it cannot bound.
/// - `boundary.plane()` -> PeriodicPlane, and `boundary.drift(time_step)`, called once a step,
/// which
///   brings the plane to the next poses: the simulation runs in a periodic cell.
template <class B>
concept Boundary = Policy<B> && clauses::BoundaryDrive<B>;

template <class B>
consteval bool check_boundary() {
  check_policy<B>();
  static_assert(clauses::BoundaryDrive<B>,
                "riprap: a Boundary must have void drive(std::vector<Body>&, double)");
  return Boundary<B>;
}

/// A `SampleBoundary` encloses a sample and strains it: what a biaxial test needs.
template <class B>
concept SampleBoundary =
    Boundary<B> && clauses::SampleBoundaryRate<B> && clauses::SampleBoundaryRegion<B>;

template <class B>
consteval bool check_sample_boundary() {
  static_assert(clauses::SampleBoundaryRate<B>,
                "riprap: the boundary of a BiaxialTest must have void set_rate(double, double), as "
                "StrainField, RigidPlatens and PeriodicCell do");
  static_assert(clauses::SampleBoundaryRegion<B>,
                "riprap: the boundary of a BiaxialTest must have region(const Particles&) const "
                "with area(), semi_axes(), solid_area() and lost()");
  return SampleBoundary<B>;
}

/// Area of the free particles [m^2].
[[nodiscard]] inline double free_area(const Particles& particles) {
  double sum = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free()) sum += particles.shape(i).area;
  return sum;
}

}  // namespace riprap
