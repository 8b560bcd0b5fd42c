#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/concepts.hpp>

using namespace riprap;

namespace {

// The least a narrow phase may be.
struct Minimal {
  struct Memory {};
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return {}; }
};

struct WithoutMemory {
  std::optional<ContactGeometry> operator()(Ring, Ring, int&) const { return {}; }
};

struct MemoryThatMustBeMade {
  struct Memory {
    explicit Memory(int) {}
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return {}; }
};

struct BareDepth {
  struct Memory {};
  double operator()(Ring, Ring, Memory&) const { return 0; }
};

static_assert(NarrowPhase<Minimal>);
static_assert(!NarrowPhase<WithoutMemory>);
static_assert(!NarrowPhase<MemoryThatMustBeMade>);
static_assert(!NarrowPhase<BareDepth>);

}  // namespace

TEST_CASE("a narrow phase that always answers with a contact is one too") {
  struct AlwaysTouching {
    struct Memory {};
    ContactGeometry operator()(Ring, Ring, Memory&) const { return {}; }
  };
  CHECK(NarrowPhase<AlwaysTouching>);
}
