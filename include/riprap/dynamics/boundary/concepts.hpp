#pragma once
/// @file
/// The role of the boundary: what moves the bodies that do not obey Newton's law.

#include <vector>

#include <riprap/particle/body.hpp>

namespace riprap {

/// A `Boundary` sets the velocities of driven bodies at the start of every step. The simulation
/// books the work of the contacts on them.
///
/// - `boundary.drive(bodies, time_step)`: must leave free bodies alone.
template <class B>
concept Boundary = requires(B& boundary, std::vector<Body>& bodies, double time_step) {
  boundary.drive(bodies, time_step);
};

}  // namespace riprap
