#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutDrive : archetype::Boundary {
  void drive() {}
};
struct DrivesOneBody : archetype::Boundary {
  void drive(Body&, double) {}
};
struct ChangesTheStep : archetype::Boundary {
  void drive(std::vector<Body>&, double&) {}
};

static_assert(Boundary<archetype::Boundary>);
static_assert(!Boundary<WithoutDrive>);
static_assert(!Boundary<DrivesOneBody>);
static_assert(!Boundary<ChangesTheStep>);

}  // namespace

TEST_CASE("a boundary may keep a state of its own") {
  struct Shaking {
    double time = 0;
    void drive(std::vector<Body>&, double time_step) { time += time_step; }
  };
  CHECK(Boundary<Shaking>);
}
