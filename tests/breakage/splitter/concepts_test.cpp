// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/breakage/splitter/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct NotCallable : archetype::Splitter {
  void operator()() const {}
};
struct NotConst : archetype::Splitter {
  CutRings operator()(Ring, const Line&, double) { return {}; }
};
struct OnePiece : archetype::Splitter {
  std::vector<Vec2> operator()(Ring, const Line&, double) const { return {}; }
};
struct ChangesTheLine : archetype::Splitter {
  CutRings operator()(Ring, Line&, double) const { return {}; }
};
struct ChangesTheRing : archetype::Splitter {
  CutRings operator()(Ring&, const Line&, double) const { return {}; }
};
struct ChangesTheArea : archetype::Splitter {
  CutRings operator()(Ring, const Line&, double&) const { return {}; }
};

struct MakesDust : archetype::Splitter {
  bool is_dust(Ring, double) const { return false; }
};
struct DustNotConst : archetype::Splitter {
  bool is_dust(Ring, double) { return false; }
};
struct DustWithoutAnswer : archetype::Splitter {
  void is_dust(Ring, double) const {}
};

static_assert(Splitter<archetype::Splitter>);
static_assert(Splitter<MakesDust>);
static_assert(!Splitter<DustNotConst>);
static_assert(!Splitter<DustWithoutAnswer>);
static_assert(!Splitter<NotCallable>);
static_assert(!Splitter<NotConst>);
static_assert(!Splitter<OnePiece>);
static_assert(!Splitter<ChangesTheLine>);
static_assert(!Splitter<ChangesTheRing>);
static_assert(!Splitter<ChangesTheArea>);

}  // namespace

TEST_CASE("a lambda is a splitter") {
  const auto always = [](Ring ring, const Line& line, double) { return cut(ring, line); };
  CHECK(Splitter<decltype(always)>);
}
