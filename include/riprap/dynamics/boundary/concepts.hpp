#pragma once
/// @file
/// The role of the boundary: what moves the bodies that do not obey Newton's law.

#include <vector>

#include <riprap/core/policy.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace clauses {

/// `boundary.drive(bodies, time_step)` sets velocities at the start of a step [s]; it must leave
/// free bodies alone. It need not be const: a boundary may keep time or a servo's state.
template <class B>
concept BoundaryDrive = requires(B& boundary, std::vector<Body>& bodies, const double time_step) {
  boundary.drive(bodies, time_step);
};

}  // namespace clauses

/// A `Boundary` sets the velocities of driven bodies at the start of every step. The simulation
/// books the work of the contacts on them.
template <class B>
concept Boundary = Policy<B> && clauses::BoundaryDrive<B>;

template <class B>
consteval bool check_boundary() {
  check_policy<B>();
  static_assert(clauses::BoundaryDrive<B>,
                "riprap: a Boundary must have void drive(std::vector<Body>&, double)");
  return Boundary<B>;
}

}  // namespace riprap
