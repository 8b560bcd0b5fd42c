// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <optional>
#include <support/violated.hpp>

#include <riprap/conformance/narrow_phase.hpp>
#include <riprap/contact/narrow_phase/narrow_phase_choice.hpp>
#include <riprap/contact/narrow_phase/no_overlap.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/narrow_phase/overlap_moments.hpp>
#include <riprap/contact/narrow_phase/separating_axis.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct SoftSkin {
  double thickness = 1e-4;
  using Cache = OverlapChord::Cache;
  std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    std::optional<ContactGeometry> contact = OverlapChord{}(a, b, cache);
    if (!contact || contact->depth <= thickness) return std::nullopt;
    contact->depth -= thickness;
    return contact;
  }
};

/// The default with one thing wrong about its contact.
template <class Change>
struct Altered : OverlapChord {
  Change change;
  std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    std::optional<ContactGeometry> contact = OverlapChord::operator()(a, b, cache);
    if (contact) change(*contact, a, b);
    return contact;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return narrow_phase_violations(Altered<Change>{{}, change});
}

struct AlwaysTouching {
  struct Cache {};
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return ContactGeometry{}; }
};

/// Uses the cached separation without checking it.
struct TrustsCache {
  struct Cache {
    bool apart = false;
  };
  std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    OverlapChord::Cache fresh;
    if (!cache.apart)
      if (auto contact = OverlapChord{}(a, b, fresh)) return contact;
    cache.apart = true;
    return std::nullopt;
  }
};

/// Wrong about pairs in batches.
struct WrongBatch : OverlapChord {
  struct Batch : OverlapChord::Batch {
    using Of = WrongBatch;
    ContactGeometry* last = nullptr;
    bool add(Ring a, Ring b, const Cache& cache, ContactGeometry& contact) {
      last = &contact;
      return OverlapChord::Batch::add(a, b, cache, contact);
    }
  };
  unsigned find(const Batch& batch) const {
    const unsigned found = OverlapChord::find(batch);
    batch.last->depth *= 1 + 1e-15;
    return found;
  }
};

}  // namespace

TEST_CASE("the narrow phases of riprap obey the axioms") {
  CHECK(to_text(narrow_phase_violations(OverlapChord{})) == "");
  CHECK(to_text(narrow_phase_violations(OverlapChord{}, 10)) == "");
  CHECK(to_text(narrow_phase_unit_violations(OverlapChord{}, OverlapChord{})) == "");
  CHECK(to_text(narrow_phase_violations(SeparatingAxis{})) == "");
  CHECK(to_text(narrow_phase_violations(SeparatingAxis{}, 10)) == "");
  CHECK(to_text(narrow_phase_unit_violations(SeparatingAxis{}, SeparatingAxis{})) == "");
  CHECK(to_text(narrow_phase_violations(OverlapMoments{})) == "");
  CHECK(to_text(narrow_phase_violations(
            NarrowPhaseChoice<OverlapChord, OverlapMoments>{OverlapMoments{}})) == "");
  CHECK(to_text(narrow_phase_violations(OverlapMoments{}, 10)) == "");
  CHECK(to_text(narrow_phase_unit_violations(OverlapMoments{}, OverlapMoments{})) == "");
  CHECK(to_text(narrow_phase_violations(NoOverlap{})) == "");
}

TEST_CASE("a user's narrow phase obeys the axioms") {
  CHECK(to_text(narrow_phase_violations(SoftSkin{})) == "");
  CHECK(to_text(narrow_phase_unit_violations(SoftSkin{}, SoftSkin{.thickness = 0.1})) == "");
}

TEST_CASE("a narrow phase with contacts at a distance is reported") {
  check_violated(narrow_phase_violations(AlwaysTouching{}),
                 "rings that keep apart have no contact");
}

TEST_CASE("a narrow phase with impossible contacts is reported") {
  check_violated(violations_of([](auto& c, Ring, Ring) { c.normal *= 1 + 1e-9; }),
                 "the normal is a unit vector");
  check_violated(violations_of([](auto& c, Ring, Ring) { c.depth -= 1e-3; }),
                 "the depth is not negative");
  check_violated(violations_of([](auto& c, Ring, Ring) { c.area -= 1e-5; }),
                 "the area is not negative");
  check_violated(violations_of([](auto& c, Ring, Ring) { c.chord -= 2e-3; }),
                 "the chord is not negative");
  check_violated(violations_of([](auto& c, Ring, Ring) { c.depth_gradient = -1; }),
                 "the gradient of the depth is not negative");
  check_violated(violations_of([](auto& c, Ring, Ring) { c.normal = -c.normal; }),
                 "the normal points from a to b: overlap after a shift of b along it [m^2]");
}

TEST_CASE("a narrow phase that treats its bodies unlike is reported") {
  const std::string_view swapped = "swapped rings have the opposite normal, and all else the same";
  check_violated(violations_of([](auto& c, Ring a, Ring b) {
                   if (a.size() > b.size()) c.depth *= 1.001;
                 }),
                 swapped);
  check_violated(violations_of([](auto& c, Ring, Ring) { c.point += 1e-6 * c.normal; }), swapped);
  check_violated(
      violations_of([](auto& c, Ring, Ring) {
        c.normal = Rotation::from_angle(1e-6) * Vec2{std::abs(c.normal.x()), c.normal.y()};
      }),
      swapped);
}

TEST_CASE("a narrow phase that depends on axes or places is reported") {
  const std::string_view moved = "rings moved and turned have the contact moved and turned";
  check_violated(violations_of([](auto& c, Ring, Ring) { c.point *= 1 + 1e-6; }), moved);
  check_violated(
      violations_of([](auto& c, Ring, Ring) { c.area *= 1 + 1e-6 * std::abs(c.normal.x()); }),
      moved);
  check_violated(
      violations_of([](auto& c, Ring, Ring) { c.chord *= 1 + 1e-6 * std::abs(c.normal.x()); }),
      moved);
}

TEST_CASE("a narrow phase whose result depends on its cache is reported") {
  check_violated(narrow_phase_violations(TrustsCache{}), "memory never changes the answer");
}

TEST_CASE("a narrow phase with a length of its own is reported in other units") {
  check_violated(narrow_phase_unit_violations(SoftSkin{}, SoftSkin{}),
                 "a contact is the same in other units");
}

TEST_CASE("a narrow phase whose batches give other contacts is reported") {
  check_violated(narrow_phase_violations(WrongBatch{}), "a batch changes no contact");
}
