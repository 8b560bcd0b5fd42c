#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

class WithoutMemory : public archetype::NarrowPhase {
  using archetype::NarrowPhase::Memory;  // private
};
struct MemoryThatMustBeMade : archetype::NarrowPhase {
  struct Memory {
    explicit Memory(int) {}
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return {}; }
};
struct MemoryThatStays : archetype::NarrowPhase {
  struct Memory {
    Memory() = default;
    Memory(const Memory&) = default;
    Memory& operator=(const Memory&) = delete;
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return {}; }
};
struct NotConst : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) { return {}; }
};
struct BareDepth : archetype::NarrowPhase {
  double operator()(Ring, Ring, Memory&) const { return 0; }
};
struct ChangesTheRing : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring&, Ring, Memory&) const { return {}; }
};
struct ChangesTheOtherRing : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring, Ring&, Memory&) const { return {}; }
};

static_assert(NarrowPhase<archetype::NarrowPhase>);
static_assert(!NarrowPhase<WithoutMemory>);
static_assert(!NarrowPhase<MemoryThatMustBeMade>);
static_assert(!NarrowPhase<MemoryThatStays>);
static_assert(!NarrowPhase<NotConst>);
static_assert(!NarrowPhase<BareDepth>);
static_assert(!NarrowPhase<ChangesTheRing>);
static_assert(!NarrowPhase<ChangesTheOtherRing>);

}  // namespace

TEST_CASE("a narrow phase that always answers with a contact is one too") {
  struct AlwaysTouching {
    struct Memory {};
    ContactGeometry operator()(Ring, Ring, Memory&) const { return {}; }
  };
  CHECK(NarrowPhase<AlwaysTouching>);
}
