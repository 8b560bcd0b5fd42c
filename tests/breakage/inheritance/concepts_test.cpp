// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/breakage/inheritance/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::Inheritance {
  void operator()() const {}
};
struct NotConst : archetype::Inheritance {
  void operator()(const Body&, Body&) {}
};
struct ChangesTheParent : archetype::Inheritance {
  void operator()(Body&, Body&) const {}
};

static_assert(Inheritance<archetype::Inheritance>);
static_assert(!Inheritance<NotCallable>);
static_assert(!Inheritance<NotConst>);
static_assert(!Inheritance<ChangesTheParent>);

}  // namespace

TEST_CASE("a lambda is an inheritance") {
  const auto with_parent = [](const Body& parent, Body& piece) {
    piece.velocity = parent.velocity;
  };
  CHECK(Inheritance<decltype(with_parent)>);
}
