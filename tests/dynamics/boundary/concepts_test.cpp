// SPDX-License-Identifier: BSL-1.0
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

struct WithoutRate : archetype::SampleBoundary {
  void set_rate() {}
};
struct RateOfOneAxis : archetype::SampleBoundary {
  void set_rate(double) {}
};
struct WithoutRegion : archetype::SampleBoundary {
  void region() const {}
};
struct RegionNotConst : archetype::SampleBoundary {
  archetype::Region region(const Particles& particles) {
    return archetype::SampleBoundary::region(particles);
  }
};

struct EnclosesTheAssemblyOnly : archetype::Boundary {
  void enclose(const Assembly&) {}
};
struct PlaneWithoutDrift : archetype::Boundary {
  PeriodicDomain domain() const { return {}; }
};
struct PlaneNotConst : archetype::Boundary {
  PeriodicDomain domain() { return {}; }
  void drift(double) {}
};

static_assert(!Boundary<EnclosesTheAssemblyOnly>);
static_assert(!Boundary<PlaneWithoutDrift>);
static_assert(!Boundary<PlaneNotConst>);
static_assert(SampleBoundary<archetype::SampleBoundary>);
static_assert(!SampleBoundary<archetype::Boundary>);
static_assert(!SampleBoundary<WithoutRate>);
static_assert(!SampleBoundary<RateOfOneAxis>);
static_assert(!SampleBoundary<WithoutRegion>);
static_assert(!SampleBoundary<RegionNotConst>);
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
