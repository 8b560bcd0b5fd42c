// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/dynamics/damping/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::Damping {
  void operator()() const {}
};
struct NotConst : archetype::Damping {
  Wrench operator()(const Body&, const Wrench&) { return {}; }
};
struct ForceOnly : archetype::Damping {
  Vec2 operator()(const Body&, const Wrench&) const { return {0, 0}; }
};
struct ChangesTheBody : archetype::Damping {
  Wrench operator()(Body&, const Wrench&) const { return {}; }
};
struct ChangesTheWrench : archetype::Damping {
  Wrench operator()(const Body&, Wrench&) const { return {}; }
};

static_assert(Damping<archetype::Damping>);
static_assert(!Damping<NotCallable>);
static_assert(!Damping<NotConst>);
static_assert(!Damping<ForceOnly>);
static_assert(!Damping<ChangesTheBody>);
static_assert(!Damping<ChangesTheWrench>);

}  // namespace

TEST_CASE("a lambda is a damping") {
  const auto viscous = [rate = 3.0](const Body& body, const Wrench&) {
    return Wrench{-rate * body.velocity, -rate * body.angular_velocity};
  };
  CHECK(Damping<decltype(viscous)>);
}
