#include <doctest/doctest.h>

#include <riprap/dynamics/damping/concepts.hpp>

using namespace riprap;

namespace {

struct WithoutRules {
  Wrench operator()(const Body&, const Wrench&) const { return {}; }
};

struct ForceOnly {
  Vec2 operator()(const Body&, const Wrench&) const { return {0, 0}; }
  void validate() const {}
};

struct ChangesTheBody {
  Wrench operator()(Body&, const Wrench&) const { return {}; }
  void validate() const {}
};

static_assert(!Damping<WithoutRules>);
static_assert(!Damping<ForceOnly>);
static_assert(!Damping<ChangesTheBody>);

}  // namespace

TEST_CASE("a viscous damping of one's own is a damping") {
  struct Viscous {
    double coefficient = 3;
    Wrench operator()(const Body& body, const Wrench&) const {
      return {-coefficient * body.velocity, -coefficient * body.angular_velocity};
    }
    void validate() const {}
  };
  CHECK(Damping<Viscous>);
}
