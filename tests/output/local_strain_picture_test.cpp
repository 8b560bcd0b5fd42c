// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/local_strain_picture.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <support/message_of.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Four squares around a unit square, of which two triangles are sheared.
struct Scene {
  Particles particles{1, 1};
  std::vector<StrainTriangle> triangles;

  explicit Scene(double first, double second) {
    for (const Vec2& c : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
      particles.add(
          {c + Vec2{-0.2, -0.2}, c + Vec2{0.2, -0.2}, c + Vec2{0.2, 0.2}, c + Vec2{-0.2, 0.2}},
          Motion::free);
    triangles = local_strain(centroids(particles), centroids(particles));
    REQUIRE(triangles.size() == 2);
    triangles[0].gradient.h12 = first;
    triangles[1].gradient.h12 = second;
  }
  [[nodiscard]] std::vector<SvgElement> picture(double full_strain) const {
    return svg_elements(local_strain_picture(particles, triangles,
                                             strain_localisation(triangles, 0.5), full_strain, "T")
                            .document());
  }
};

std::size_t count_of(const std::vector<SvgElement>& elements, const std::string& fill) {
  std::size_t count = 0;
  for (const SvgElement& e : named(elements, "polygon")) count += e.attribute("fill") == fill;
  return count;
}

bool has_text(const std::vector<SvgElement>& elements, const std::string& part) {
  for (const SvgElement& e : named(elements, "text"))
    if (contains(e.text, part)) return true;
  return false;
}

}  // namespace

TEST_CASE("triangles have the colours of their strains, the darkest from full_strain on") {
  const auto elements = Scene(0, 0.4).picture(0.2);
  CHECK(count_of(elements, internal::strain_colour(0)) == 1);
  CHECK(count_of(elements, internal::strain_colour(9)) == 1);
  CHECK(count_of(elements, "none") == 5);  // particles and the band
  CHECK(internal::strain_class(0.05, 0.2) == 2);
  CHECK(internal::strain_class(0.2, 0.2) == 9);
  CHECK(internal::strain_class(0, 0.2) == 0);
}

TEST_CASE("the legend has the largest colour and the numbers of the band") {
  const auto elements = Scene(0, 0.4).picture(0.2);
  CHECK(has_text(elements, "20 % and more"));
  // A right-angled triangle with sides of 1: the major axis is along its longest side.
  CHECK((has_text(elements, "band: 45 degrees") || has_text(elements, "band: -45 degrees")));
  // Principal moments of 1/12 and 1/36 of the area.
  CHECK(has_text(elements, "1.7 times as long as thick"));
  CHECK(has_text(elements, "100 % of the strain in it"));
  CHECK(has_text(elements, "participation ratio 0.5"));
}

TEST_CASE("the outline of the band has its length and thickness about its centre") {
  StrainLocalisation band;
  band.centre = {3, 1};
  band.direction = std::atan2(3, 4);
  band.elongation = 5;
  band.thickness = 2;
  const auto ring = internal::band_outline(band);
  // Half of the length, 5, along (0.8, 0.6) and half of the thickness, 1, along (-0.6, 0.8).
  CHECK((ring[0] - Vec2{3 + 4 - 0.6, 1 + 3 + 0.8}).norm() < 1e-14);
  CHECK((ring[2] - Vec2{3 - 4 + 0.6, 1 - 3 - 0.8}).norm() < 1e-14);
}

TEST_CASE("a full strain of zero is refused") {
  const Scene scene(0, 0.1);
  CHECK(contains(
      message_of([&] { (void)local_strain_picture(scene.particles, scene.triangles, {}, 0, "T"); }),
      "full_strain = 0"));
}
