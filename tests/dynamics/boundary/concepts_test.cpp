#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/concepts.hpp>

using namespace riprap;

namespace {

struct DrivesNothing {};

struct DrivesOneBody {
  void drive(Body&, double) const {}
};

static_assert(!Boundary<DrivesNothing>);
static_assert(!Boundary<DrivesOneBody>);

}  // namespace

TEST_CASE("a boundary may keep a state of its own") {
  struct Shaking {
    double time = 0;
    void drive(std::vector<Body>&, double time_step) { time += time_step; }
  };
  CHECK(Boundary<Shaking>);
}
