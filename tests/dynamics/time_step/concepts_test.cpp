#include <doctest/doctest.h>

#include <riprap/dynamics/time_step/concepts.hpp>

using namespace riprap;

namespace {

struct WithoutScaling {
  double time_step(double, double) const { return 1; }
  void validate() const {}
};

struct WithoutStep {
  double mass_scaling(double, double) const { return 1; }
  void validate() const {}
};

static_assert(!TimeStepRule<WithoutScaling>);
static_assert(!TimeStepRule<WithoutStep>);

}  // namespace

TEST_CASE("a fixed time step without mass scaling is a rule") {
  struct Fixed {
    double time_step(double, double) const { return 1e-6; }
    double mass_scaling(double, double) const { return 1; }
    void validate() const {}
  };
  CHECK(TimeStepRule<Fixed>);
}
