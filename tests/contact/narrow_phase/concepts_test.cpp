// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

class WithoutCache : public archetype::NarrowPhase {
  using archetype::NarrowPhase::Cache;  // private
};
struct MemoryThatMustBeMade : archetype::NarrowPhase {
  struct Cache {
    explicit Cache(int) {}
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return {}; }
};
struct MemoryThatStays : archetype::NarrowPhase {
  struct Cache {
    Cache() = default;
    Cache(const Cache&) = default;
    Cache& operator=(const Cache&) = delete;
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return {}; }
};
struct NotConst : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) { return {}; }
};
struct BareDepth : archetype::NarrowPhase {
  double operator()(Ring, Ring, Cache&) const { return 0; }
};
struct ChangesTheRing : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring&, Ring, Cache&) const { return {}; }
};
struct ChangesTheOtherRing : archetype::NarrowPhase {
  std::optional<ContactGeometry> operator()(Ring, Ring&, Cache&) const { return {}; }
};
struct TellsClearance : archetype::NarrowPhase {
  archetype::Gives<double> clearance(archetype::Takes<Cache>) const {
    return archetype::Gives(0.0);
  }
};
struct ClearanceNotConst : archetype::NarrowPhase {
  double clearance(const Cache&) { return 0; }
};
struct ClearanceChangesTheMemory : archetype::NarrowPhase {
  double clearance(Cache&) const { return 0; }
};
struct ClearanceIsNoNumber : archetype::NarrowPhase {
  Vec2 clearance(const Cache&) const { return {0, 0}; }
};
// Another member of that name is none of ours.
struct ClearanceOfRings : archetype::NarrowPhase {
  double clearance(Ring, Ring) const { return 0; }
};

struct FindsSeveral : archetype::NarrowPhase {
  struct Batch {
    using Of = FindsSeveral;
    static constexpr std::size_t capacity = 3;
    [[nodiscard]] archetype::Gives<std::size_t> size() const {
      return archetype::Gives<std::size_t>(0);
    }
    void clear() {}
    archetype::Gives<bool> add(archetype::Takes<Ring>, archetype::Takes<Ring>,
                               archetype::Takes<Cache>, ContactGeometry&) {
      return archetype::Gives(false);
    }
  };
  [[nodiscard]] archetype::Gives<unsigned> find(archetype::Takes<Batch>) const {
    return archetype::Gives(0U);
  }
};
struct Inherits : FindsSeveral {};  // and may answer differently
struct BatchWithoutOf : archetype::NarrowPhase {
  struct Batch {};
};
struct FindNotConst : archetype::NarrowPhase {
  struct Batch : FindsSeveral::Batch {
    using Of = FindNotConst;
  };
  unsigned find(const Batch&) { return 0; }
};
struct BatchTooLarge : archetype::NarrowPhase {
  struct Batch : FindsSeveral::Batch {
    using Of = BatchTooLarge;
    static constexpr std::size_t capacity = 33;  // bits of an answer
  };
  unsigned find(const Batch&) const { return 0; }
};

static_assert(NarrowPhase<FindsSeveral>);
static_assert(BatchedNarrowPhase<FindsSeveral>);
static_assert(NarrowPhase<Inherits>);
static_assert(!BatchedNarrowPhase<Inherits>);
static_assert(!NarrowPhase<BatchWithoutOf>);
static_assert(!NarrowPhase<FindNotConst>);
static_assert(!NarrowPhase<BatchTooLarge>);
static_assert(NarrowPhase<archetype::NarrowPhase>);
static_assert(NarrowPhase<TellsClearance>);
static_assert(NarrowPhase<ClearanceOfRings>);
static_assert(!NarrowPhase<ClearanceNotConst>);
static_assert(!NarrowPhase<ClearanceChangesTheMemory>);
static_assert(!NarrowPhase<ClearanceIsNoNumber>);
static_assert(!NarrowPhase<WithoutCache>);
static_assert(!NarrowPhase<MemoryThatMustBeMade>);
static_assert(!NarrowPhase<MemoryThatStays>);
static_assert(!NarrowPhase<NotConst>);
static_assert(!NarrowPhase<BareDepth>);
static_assert(!NarrowPhase<ChangesTheRing>);
static_assert(!NarrowPhase<ChangesTheOtherRing>);

}  // namespace

TEST_CASE("a narrow phase that always answers with a contact is one too") {
  struct AlwaysTouching {
    struct Cache {};
    ContactGeometry operator()(Ring, Ring, Cache&) const { return {}; }
  };
  CHECK(NarrowPhase<AlwaysTouching>);
}
