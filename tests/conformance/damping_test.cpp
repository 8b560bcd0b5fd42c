// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/damping.hpp>
#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/dynamics/damping/viscous_damping.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct QuadraticDrag {
  double coefficient = 10;
  Wrench operator()(const Body& body, const Wrench& /*applied*/) const {
    return {-(coefficient * body.velocity.norm()) * body.velocity, 0};
  }
  void validate() const {}
};

/// Damping of the load alone, whichever way the body moves.
struct WeakerLoad {
  Wrench operator()(const Body&, const Wrench& applied) const { return {-0.1 * applied.force, 0}; }
  void validate() const {}
};

struct WrongSpin {
  Wrench operator()(const Body& body, const Wrench&) const {
    return {{0, 0}, 1e-9 * body.angular_velocity};
  }
  void validate() const {}
};

struct Draught {
  Wrench operator()(const Body&, const Wrench&) const { return {{1e-9, 0}, 0}; }
  void validate() const {}
};

}  // namespace

TEST_CASE("the dampings of riprap obey the axioms") {
  CHECK(to_text(damping_violations(LocalDamping{})) == "");
  CHECK(to_text(damping_violations(ViscousDamping{})) == "");
  CHECK(to_text(damping_violations(NoDamping{})) == "");
}

TEST_CASE("a user's damping obeys the axioms") {
  CHECK(to_text(damping_violations(QuadraticDrag{})) == "");
}

TEST_CASE("a damping that drives bodies is reported") {
  const std::string_view power = "damping never puts energy into a body: its power [W]";
  check_violated(damping_violations(QuadraticDrag{.coefficient = -1e-9}), power);
  check_violated(damping_violations(WeakerLoad{}), power);
  check_violated(damping_violations(WrongSpin{}), power);
  check_violated(damping_violations(Draught{}), "no load and no motion, no damping");
}
