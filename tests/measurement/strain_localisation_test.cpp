// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/strain_localisation.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Adds a grid of columns by rows of rectangles, two triangles each, over length by width about the
/// origin of axes turned by `angle` and shifted.
void add_strip(std::vector<StrainTriangle>& out, double length, double width, int columns, int rows,
               double angle, const Vec2& shift, double strain) {
  const Rotation turn = Rotation::from_angle(angle);
  // Ids of its own: strips have no more than twice as many corners as triangles.
  const std::size_t first = 2 * out.size();
  const auto at = [&](int i, int j) -> Vec2 {
    return shift + turn * Vec2{length * (i / static_cast<double>(columns) - 0.5),
                               width * (j / static_cast<double>(rows) - 0.5)};
  };
  using Node = std::array<int, 2>;
  const auto add = [&](const std::array<Node, 3>& nodes) {
    StrainTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] = nodes[k];
      t.ids[k] = static_cast<ParticleId>(first + static_cast<std::size_t>(i * (rows + 1) + j));
      t.corners[k] = at(i, j);
    }
    t.gradient.h12 = strain;  // simple shear
    out.push_back(t);
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      add({Node{i, j}, Node{i + 1, j}, Node{i + 1, j + 1}});
      add({Node{i, j}, Node{i + 1, j + 1}, Node{i, j + 1}});
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
    CHECK(band.band_share == near(1, 1e-12));
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
  CHECK(strain_localisation(field, 1).participation_ratio == near(16.0 / (2 * 10), 1e-14));
  // The same as one strip of two squares.
  field.clear();
  add_strip(field, 2, 1, 2, 1, 0, {0, 0}, 3);
  for (std::size_t n = 2; n < 4; ++n) field[n].gradient.h12 = 1;
  const StrainLocalisation whole = strain_localisation(field, 1);
  CHECK(whole.centre.x() == near(-0.25, 1e-14));
  // Along axis 1: 1/12 + (3 * 0.25^2 + 1 * 0.75^2) / 4; across it 1/12.
  CHECK(whole.elongation == near(std::sqrt((1.0 / 12 + 0.1875) * 12), 1e-12));
  CHECK(whole.direction == near(0, 1e-14));
}

TEST_CASE("of several parts of large strain the band is the one with most of it") {
  const double angle = 0.8;
  std::vector<StrainTriangle> field;
  add_strip(field, 1, 0.1, 10, 1, -0.3, {4, 4}, 0.5);
  add_strip(field, 1.5, 0.1, 15, 1, angle, {0, 0}, 0.4);
  add_strip(field, 1, 0.1, 10, 1, 0, {-4, 2}, 0.5);
  add_strip(field, 3.5, 0.9, 35, 9, 0, {9, 9}, 0);
  const StrainLocalisation band = strain_localisation(field);  // a tenth: all three strips
  CHECK(band.strain_share == near(1, 1e-12));
  CHECK(band.band_share == near(0.06 / (0.05 + 0.06 + 0.05), 1e-12));
  CHECK(band.direction == near(angle, 1e-12));
  CHECK(band.elongation == near(15, 1e-9));
  CHECK(band.thickness == near(0.1, 1e-11));
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
