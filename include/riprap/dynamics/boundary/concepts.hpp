#pragma once
/// @file
/// The role of the boundary: what moves the bodies that do not obey Newton's law.

#include <concepts>
#include <cstddef>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/particle/body.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A `Boundary` sets the velocities of driven bodies at the start of every step. The simulation
/// books the work of the contacts on them.
///
/// - `boundary.drive(bodies, time_step)`: must leave free bodies alone.
///
/// Optional:
/// - `boundary.enclose(assembly, particles)`: called once, before the first step; throws
///   InvalidInput for an assembly that it cannot bound.
/// - `boundary.plane()` -> PeriodicPlane, and `boundary.drift(time_step)`, called once a step,
/// after
///   which the plane is that of the next poses: the simulation runs in a periodic cell.
template <class B>
concept Boundary = requires(B& boundary, std::vector<Body>& bodies, double time_step) {
  boundary.drive(bodies, time_step);
};

/// A `SampleBoundary` encloses a sample and strains it: what a biaxial test needs.
///
/// - `boundary.set_rate(axis_1, axis_2)`: shortening rates [1/s], positive in compression, from the
///   next step on.
/// - `boundary.region(particles)`: the sample as it stands, read at once: `.area()` [m^2],
///   `.semi_axes()` along axes 1 and 2 [m], `.solid_area()`, the rock in it [m^2], `.lost()`, how
///   many free particles have left it. The area shrinks at the sum of the two rates.
template <class B>
concept SampleBoundary =
    Boundary<B> && requires(B& boundary, const B& still, const Particles& particles) {
      boundary.set_rate(0.0, 0.0);
      { still.region(particles).area() } -> std::convertible_to<double>;
      { still.region(particles).semi_axes() } -> std::convertible_to<Vec2>;
      { still.region(particles).solid_area() } -> std::convertible_to<double>;
      { still.region(particles).lost() } -> std::convertible_to<std::size_t>;
    };

/// Area of the free particles [m^2].
[[nodiscard]] inline double free_area(const Particles& particles) {
  double sum = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_free()) sum += particles.shape(i).area;
  return sum;
}

}  // namespace riprap
