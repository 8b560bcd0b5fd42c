// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/simulation/model_parts.hpp>

#include <doctest/doctest.h>

#include <concepts>

#include <riprap/contact/contact_law/no_contact_force.hpp>

using namespace riprap;

TEST_CASE("a part deduces the types of its policies, and whether the criterion never fails") {
  const ContactModel part{UniformGrid{}, OverlapChord{}, NoContactForce{}};
  CHECK(std::same_as<decltype(part.law), NoContactForce>);
  CHECK_FALSE(BreakageModel<>::never_fails);
  CHECK(BreakageModel<NeverFails>::never_fails);
}
