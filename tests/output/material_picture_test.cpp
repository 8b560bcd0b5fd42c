// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/material_picture.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include <riprap/output/assembly_picture.hpp>
#include <support/rectangle.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using riprap::test::rectangle;

TEST_CASE("particles have the colour of their material, pieces a darker one, and the legend both") {
  Particles particles(1, std::vector<double>{2500, 2200});
  for (MaterialIndex i = 0; i < 4; ++i)
    particles.add(rectangle({i, 0}, 0.9, 0.9), Motion::free, nullptr, i % 2);
  const Ancestry parent = particles.ancestry(3);
  particles.replace(3, rectangle({3, 0}, 0.4, 0.9), Motion::free, parent);
  const auto all =
      test::svg_elements(material_picture(particles, {"granite"}, "Two rocks").document());
  const auto polygons = test::named(all, "polygon");
  REQUIRE(polygons.size() == 4);
  const auto fill = [&](std::size_t i) { return polygons[i].attribute("fill"); };
  CHECK(fill(0) == fill(2));
  CHECK(std::set<std::string>{fill(0), fill(1), fill(3)}.size() == 3);
  // The legend: pale and dark of each.
  std::vector<std::string> patches;
  for (const auto& patch : test::named(all, "rect"))
    if (std::stod(patch.attribute("width")) == 18) patches.push_back(patch.attribute("fill"));
  REQUIRE(patches.size() == 4);
  CHECK(patches[0] == fill(0));
  CHECK(patches[2] == fill(1));
  CHECK(patches[3] == fill(3));
  const std::string text = material_picture(particles, {"granite"}, "Two rocks").document();
  for (const char* name : {"granite", "granite: pieces", "material 1", "material 1: pieces"})
    CHECK(text.find(name) != text.npos);
}

TEST_CASE("walls and platens are grey, as in other pictures, whatever their material") {
  Particles particles(1, std::vector<double>{2500, 2200});
  particles.add(rectangle({0, 0}, 1, 1), Motion::free);
  particles.add(rectangle({0, 1}, 3, 1), Motion::wall);
  particles.add(rectangle({0, -1}, 3, 1), Motion::platen, nullptr, 1);
  particles.add(rectangle({1, 0}, 1, 1), Motion::strain_field);
  const Svg svg = material_picture(particles, {"granite", "marl"}, "Between walls");
  const auto all = test::svg_elements(svg.document());
  const auto polygons = test::named(all, "polygon");
  const auto grey =
      test::named(test::svg_elements(assembly_picture(particles, {}, "").document()), "polygon")[0]
          .attribute("fill");
  REQUIRE(polygons.size() == 4);
  CHECK(polygons[0].attribute("fill") != grey);
  CHECK(polygons[1].attribute("fill") == grey);
  CHECK(polygons[2].attribute("fill") == grey);
  CHECK(polygons[3].attribute("fill") == polygons[0].attribute("fill"));  // of the sample
  CHECK(svg.document().find("boundary") != std::string::npos);
}
