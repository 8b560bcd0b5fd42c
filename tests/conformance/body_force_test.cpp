// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <limits>
#include <support/violated.hpp>

#include <riprap/conformance/body_force.hpp>
#include <riprap/dynamics/body_force/no_body_force.hpp>
#include <riprap/dynamics/body_force/uniform_body_force.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct ConstantForce {
  Vec2 operator()(const Body& body) const { return Vec2{0, -1} / body.mass; }
};
struct Unbounded {
  Vec2 operator()(const Body&) const { return {std::numeric_limits<double>::infinity(), 0}; }
};
struct Alternating {
  mutable int calls = 0;
  Vec2 operator()(const Body&) const { return {++calls % 2 == 0 ? 1.0 : 0.0, 0}; }
};

}  // namespace

TEST_CASE("the body forces of riprap obey the axioms") {
  CHECK(to_text(body_force_violations(NoBodyForce{})) == "");
  CHECK(to_text(body_force_violations(UniformBodyForce{{0, -9.81}})) == "");
}

TEST_CASE("what breaks an axiom of body forces is reported") {
  check_violated(body_force_violations(ConstantForce{}),
                 "a body force is proportional to the mass: difference [m/s^2]");
  check_violated(body_force_violations(Unbounded{}), "the acceleration is finite");
  check_violated(body_force_violations(Alternating{}),
                 "the same body has the same acceleration: difference [m/s^2]");
}
