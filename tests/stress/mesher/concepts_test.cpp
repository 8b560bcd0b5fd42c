// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/stress/mesher/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::Mesher {
  void operator()() const {}
};
struct NotConst : archetype::Mesher {
  Mesh operator()(Ring) { return {}; }
};
struct NodesOnly : archetype::Mesher {
  std::vector<Vec2> operator()(Ring) const { return {}; }
};
struct ChangesTheRing : archetype::Mesher {
  Mesh operator()(Ring&) const { return {}; }
};

static_assert(Mesher<archetype::Mesher>);
static_assert(!Mesher<NotCallable>);
static_assert(!Mesher<NotConst>);
static_assert(!Mesher<NodesOnly>);
static_assert(!Mesher<ChangesTheRing>);

}  // namespace

TEST_CASE("a lambda is a mesher") {
  const auto coarse = [](Ring ring) { return UniformMesher{.triangles = 10}(ring); };
  CHECK(Mesher<decltype(coarse)>);
}
