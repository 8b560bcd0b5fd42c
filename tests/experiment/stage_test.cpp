// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <string>

#include <riprap/experiment/stage.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>

using namespace riprap;
using riprap::test::near;

TEST_CASE("the stages are compaction, relaxation, hydrostatic and shear, in this order") {
  CHECK(Stage::compaction < Stage::relaxation);
  CHECK(Stage::relaxation < Stage::hydrostatic);
  CHECK(Stage::hydrostatic < Stage::shear);
  CHECK(to_text(Stage::compaction) == std::string("compaction"));
  CHECK(to_text(Stage::relaxation) == std::string("relaxation"));
  CHECK(to_text(Stage::hydrostatic) == std::string("hydrostatic"));
  CHECK(to_text(Stage::shear) == std::string("shear"));
}

TEST_CASE("a sample that has not been deformed has no strain") {
  const test::StillSample sample;
  const BiaxialView<test::StillSample> view{.sim = sample};
  CHECK(view.axial_strain() == 0);
  CHECK(view.volumetric_strain() == 0);
}

TEST_CASE("axial strain is the share by which axis 2 has shortened") {
  const test::StillSample sample;
  BiaxialView<test::StillSample> view{.sim = sample};
  view.stretch = {1.5, 0.8};
  CHECK(view.axial_strain() == near(0.2, 1e-15));
  view.stretch = {0.5, 1.1};
  CHECK(view.axial_strain() == near(-0.1, 1e-15));
}

TEST_CASE("volumetric strain is the share of area that was lost, and positive in contraction") {
  test::StillSample sample;
  const double before = sample.boundary().region(sample.particles()).area();
  BiaxialView<test::StillSample> view{.sim = sample};
  for (const Vec2& stretch : {Vec2{0.97, 0.8}, Vec2{1.4, 0.75}, Vec2{0.8, 1.25}}) {
    view.stretch = stretch;
    test::StillSample deformed;
    for (BodyIndex i = 1; i < 5; ++i)
      deformed.body(i).position = stretch.cwiseProduct(sample.body(i).position);
    const double after = deformed.boundary().region(deformed.particles()).area();
    // Round-off of areas of order 1.
    CHECK(view.volumetric_strain() == near(1 - after / before, 1e-14));
  }
}
