// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/strain_localisation.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Simple shear of a size in a triangle.
StrainTriangle triangle(const Vec2& a, const Vec2& b, const Vec2& c, double strain) {
  StrainTriangle t;
  t.corners = {a, b, c};
  t.gradient.h12 = strain;
  return t;
}

/// Adds a grid of columns by rows of rectangles, two triangles each, over length by width about the
/// origin of axes turned by `angle` and shifted.
void add_strip(std::vector<StrainTriangle>& out, double length, double width, int columns, int rows,
               double angle, const Vec2& shift, double strain) {
  const Rotation turn = Rotation::from_angle(angle);
  const auto at = [&](int i, int j) -> Vec2 {
    return shift + turn * Vec2{length * (i / static_cast<double>(columns) - 0.5),
                               width * (j / static_cast<double>(rows) - 0.5)};
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      out.push_back(triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), strain));
      out.push_back(triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), strain));
    }
}

}  // namespace

TEST_CASE("a strip with all of the strain is the band, with its direction, length and thickness") {
  for (const double degrees : {0.0, 30.0, 62.0, 90.0, -45.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<StrainTriangle> field;
    add_strip(field, 1.2, 0.1, 12, 1, angle, {3, -2}, 0.4);
    // The rest, nine tenths of the area, without strain.
    add_strip(field, 1.2, 0.9, 12, 9, angle, Vec2{3, -2} + Vec2{10, 0}, 0);
    const StrainLocalisation band = strain_localisation(field);
    CHECK(band.strain_share == near(1, 1e-12));
    CHECK(band.participation_ratio == near(0.1, 1e-12));
    CHECK(std::abs(std::sin(band.direction - angle)) == near(0, 1e-12));
    CHECK(band.elongation == near(12, 1e-9));
    CHECK(band.thickness == near(0.1, 1e-11));
    CHECK(band.centre.x() == near(3, 1e-12));
    CHECK(band.centre.y() == near(-2, 1e-12));
  }
}

TEST_CASE("an even field has a participation ratio of one and no more strain in any part") {
  std::vector<StrainTriangle> field;
  add_strip(field, 1, 1, 10, 10, 0.2, {0, 0}, 0.03);
  for (const double share : {0.1, 0.37, 1.0}) {
    const StrainLocalisation all = strain_localisation(field, share);
    CHECK(all.participation_ratio == near(1, 1e-12));
    CHECK(all.strain_share == near(share, 1e-12));
  }
  CHECK(strain_localisation(field, 1).elongation == near(1, 1e-6));
}

TEST_CASE("the last triangle counts in part, and larger strains pull the band to themselves") {
  // Two squares of equal area with strains 3 and 1.
  std::vector<StrainTriangle> field;
  add_strip(field, 1, 1, 1, 1, 0, {0, 0}, 3);
  add_strip(field, 1, 1, 1, 1, 0, {4, 0}, 1);
  // The first square and a quarter of the area, half of the second one: 3 + 0.5 of 4.
  CHECK(strain_localisation(field, 0.75).strain_share == near(3.5 / 4, 1e-14));
  const StrainLocalisation whole = strain_localisation(field, 1);
  CHECK(whole.participation_ratio == near(16.0 / (2 * 10), 1e-14));
  CHECK(whole.centre.x() == near(1, 1e-14));
  // Along axis 1: 1/12 + (3 * 1^2 + 1 * 3^2) / 4; across it 1/12.
  CHECK(whole.elongation == near(std::sqrt((1.0 / 12 + 3) * 12), 1e-12));
  CHECK(whole.direction == near(0, 1e-14));
}

TEST_CASE("a band in a field with less strain around it is found to the width of a triangle") {
  // A square of 40 by 40 cells; those whose middle is within 0.05 of a line at 55 degrees.
  const double angle = 55 * std::numbers::pi / 180;
  const Vec2 normal{-std::sin(angle), std::cos(angle)};
  std::vector<StrainTriangle> field;
  add_strip(field, 1, 1, 40, 40, 0, {0, 0}, 0.05);
  double in_band = 0;
  for (StrainTriangle& t : field)
    if (std::abs(normal.dot(t.centroid())) < 0.05) {
      t.gradient.h12 = 0.5;
      in_band += t.area();
    }
  const StrainLocalisation band = strain_localisation(field, in_band);
  // The edges of the band are rough by a cell of 0.025: an angle of that over its length of 1.2.
  CHECK(band.direction == near(angle, 0.02));
  CHECK(band.thickness == near(0.1, 0.01));
  CHECK(band.strain_share == near(0.5 * in_band / (0.5 * in_band + 0.05 * (1 - in_band)), 1e-12));
  CHECK(band.elongation > 9);
}

TEST_CASE("without strain or triangles all is zero, and a share outside (0, 1] is refused") {
  CHECK(strain_localisation({}).participation_ratio == 0);
  std::vector<StrainTriangle> field;
  add_strip(field, 1, 1, 2, 2, 0, {0, 0}, 0);
  CHECK(strain_localisation(field).strain_share == 0);
  CHECK(contains(message_of([&] { (void)strain_localisation(field, 0); }), "area_share = 0"));
  CHECK(contains(message_of([&] { (void)strain_localisation(field, 1.5); }), "area_share = 1.5"));
}
