// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/integrator/integrator_choice.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/integrator/frozen.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <support/same_run.hpp>

using namespace riprap;

namespace {

using Choice = IntegratorChoice<SymplecticEuler, VelocityVerlet, Frozen>;
static_assert(Integrator<Choice>);
static_assert(Choice::order == 0 && Choice::has_second_kick);
static_assert(IntegratorChoice<VelocityVerlet>::order == 2);
static_assert(!IntegratorChoice<SymplecticEuler, Frozen>::has_second_kick);

// has_second_kick is false, and the second kick must not be called.
struct NoSecondKick : SymplecticEuler {
  void second_kick(Body&, const Wrench&, double) const { FAIL("second kick of a one-kick scheme"); }
};

}  // namespace

TEST_CASE("a chosen integrator runs to the same bytes as the integrator itself, its work too") {
  const auto check_same = [](const auto& integrator) {
    const Choice choice{integrator};
    CHECK(test::same_bytes(test::run_of(Model{}.integrator(choice), 1500),
                           test::run_of(Model{}.integrator(integrator), 1500)));
  };
  check_same(SymplecticEuler{});
  check_same(VelocityVerlet{});
  check_same(Frozen{});
}

TEST_CASE("integrators that are chosen differ") {
  CHECK(!test::same_bytes(test::run_of(Model{}.integrator(Choice{SymplecticEuler{}}), 10),
                          test::run_of(Model{}.integrator(Choice{VelocityVerlet{}}), 10)));
}

TEST_CASE("the second kick of a one-kick scheme is not called, and its first kick is whole") {
  const IntegratorChoice<NoSecondKick, VelocityVerlet> choice{NoSecondKick{}};
  Body body;
  choice.second_kick(body, {{1, 2}, 3}, 0.1);
  CHECK(choice.first_kick_fraction() == 1);
  CHECK(Choice{VelocityVerlet{}}.first_kick_fraction() == 0.5);
}
