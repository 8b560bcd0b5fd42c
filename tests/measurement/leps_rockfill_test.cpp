// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/leps_rockfill.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

// Normal stress, and shear stress of poor, average and good rockfill after Leps [kPa].
struct Row {
  double normal;
  std::array<double, 3> shear;
};
constexpr std::array table{Row{3.4, {4.4, 5.4, 6.5}},
                           Row{24.1, {25.2, 30.3, 36.4}},
                           Row{41.4, {40.9, 49.1, 58.9}},
                           Row{275.8, {224.1, 269.3, 321.1}},
                           Row{482.6, {369.6, 445.0, 530.5}},
                           Row{689.5, {508.3, 612.8, 730.6}},
                           Row{1103.2, {773.0, 933.8, 1114.1}},
                           Row{4826.3, {2863.4, 3494.9, 4189.7}},
                           Row{6894.8, {3921.7, 4802.8, 5763.8}}};

const std::array lines{LepsRockfill::low(), LepsRockfill::average(), LepsRockfill::high()};

}  // namespace

TEST_CASE("the lines are those of the table that practice uses") {
  for (const Row& row : table)
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(row.normal);
      CAPTURE(i);
      // At 3.4 kPa the rounding of the shear stress alone is worth 0.4 degrees; elsewhere the
      // coefficients are rounded to 0.1 degrees over three decades.
      CHECK(lines[i].friction_angle(row.normal * 1e3) ==
            near(std::atan(row.shear[i] / row.normal), row.normal < 10 ? 0.5_deg : 0.25_deg));
    }
}

TEST_CASE("the average line falls from 55 to 35 degrees, as the abstract has it") {
  // "About", from very low to high pressure: the ends of the tests.
  CHECK(lines[1].friction_angle(LepsRockfill::lowest_stress) == near(55.0_deg, 1.0_deg));
  CHECK(lines[1].friction_angle(LepsRockfill::highest_stress) == near(35.0_deg, 2.0_deg));
}

TEST_CASE("good rockfill is stronger than average, and this than poor") {
  for (double stress = 1e3; stress < 1e8; stress *= 3) {
    CHECK(lines[0].friction_angle(stress) < lines[1].friction_angle(stress));
    CHECK(lines[1].friction_angle(stress) < lines[2].friction_angle(stress));
  }
}

TEST_CASE("the tests end at 500 psi") {
  CHECK(LepsRockfill::covers(6.9e3));
  CHECK(LepsRockfill::covers(3.4e6));
  CHECK(!LepsRockfill::covers(6.8e3));
  CHECK(!LepsRockfill::covers(3.5e6));
}
