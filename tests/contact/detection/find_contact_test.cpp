// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/detection/find_contact.hpp>

#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near;
using test::rectangle;

namespace {

Particles two_squares(double distance) {
  Particles particles(1, 2500);
  particles.add(rectangle({0, 0}, 1, 1), Motion::free);
  particles.add(rectangle({distance, 0}, 1, 0.5), Motion::free);
  return particles;
}

}  // namespace

TEST_CASE("a contact that begins has no history, one that lasts keeps it") {
  using Pair = Contact<int, OverlapChord::Cache>;
  Pair pair{.a = 0, .b = 1};
  pair.history = 3;
  CHECK(find_contact(pair, two_squares(0.99), OverlapChord{}, UnboundedDomain{}));
  CHECK(pair.history == 0);
  CHECK(pair.geometry.depth == near(0.01, 1e-12));
  pair.history = 3;
  CHECK(find_contact(pair, two_squares(0.98), OverlapChord{}, UnboundedDomain{}));
  CHECK(pair.history == 3);
  CHECK(pair.geometry.depth == near(0.02, 1e-12));
  CHECK_FALSE(find_contact(pair, two_squares(1.01), OverlapChord{}, UnboundedDomain{}));
  CHECK_FALSE(pair.touching);
}

TEST_CASE("across the border of a periodic cell the image of b is in contact") {
  using Pair = Contact<int, OverlapChord::Cache, PeriodicDomain::Image>;
  const PeriodicDomain domain{.period = {10, 10}};
  Pair pair{.a = 0, .b = 1, .image = {-1, 0}, .crosses_boundary = true};
  CHECK(find_contact(pair, two_squares(9.01), OverlapChord{}, domain));
  CHECK(pair.geometry.normal.x() == near(-1, 1e-12));
  CHECK(pair.geometry.point.x() == near(-0.5, 1e-12));  // on the edge of a
}
