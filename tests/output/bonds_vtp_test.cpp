// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/bonds_vtp.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <riprap/output/bond_picture.hpp>
#include <riprap/output/paraview.hpp>
#include <support/bonded_clusters.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>
#include <support/temporary_folder.hpp>
#include <support/vtp_document.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

auto half_broken() {
  auto sim = bonded_clusters();
  for (int n = 0; n < 50; ++n) sim.step();
  sim.break_bonds([](const auto& bond) { return bond.a < 5; });
  for (int n = 0; n < 50; ++n) sim.step();
  return sim;
}

}  // namespace

TEST_CASE("bonds are lines along their edges, broken ones where the edge is now") {
  const auto sim = half_broken();
  const auto read = read_vtp(bonds_vtp(sim).document());
  REQUIRE(read.lines == 8);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& bond = sim.bonds()[k];
    CHECK(read.values("live")[k] == 1);
    CHECK(read.values("a")[k] == bond.a);
    CHECK(read.values("b")[k] == bond.b);
    CHECK(read.values("normal")[k] ==
          near_relative(0.5 * (bond.tractions[0].normal + bond.tractions[1].normal), 1e-15));
    CHECK((read.cells[k][1] - read.cells[k][0]).norm() == near_relative(cell_side, 1e-6));
  }
  double energy = 0;
  for (std::size_t k = 4; k < 8; ++k) {
    CHECK(read.values("live")[k] == 0);
    CHECK(read.values("failure")[k] == 0);
    energy += read.values("energy")[k];
    // An edge of its particle: both ends are vertices of that.
    const Ring ring = sim.particles().ring(static_cast<BodyIndex>(read.values("a")[k]));
    for (const Vec2& end : read.cells[k]) {
      double nearest = 1;
      for (const Vec2& v : ring) nearest = std::min(nearest, (v - end).norm());
      CHECK(nearest <= 1e-12);
    }
  }
  CHECK(energy == near_relative(sim.bonds().loss(), 1e-9));
}

TEST_CASE("particles of a bonded sample have the number of their fragment, the series has bonds") {
  const auto sim = half_broken();
  const auto read = read_vtp(particles_vtp(sim).document());
  const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
  for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(read.values("fragment")[i] == numbers[i]);
  const TemporaryFolder folder;
  const std::filesystem::path path = std::filesystem::path(folder.path()) / "series";
  ParaViewSeries series(path);
  series.write(sim, 0);
  series.write(sim, 1);
  for (const char* name : {"bonds_0000.vtp", "bonds_0001.vtp", "bonds.pvd", "particles.pvd"})
    CHECK(std::filesystem::exists(path / name));
  ParaViewSeries::remove(path);
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("the picture has a line for each bond, live and broken, and a shape for each particle") {
  const auto sim = half_broken();
  const auto elements = svg_elements(bond_picture(sim, "bonds").document());
  CHECK(outside_canvas(elements).empty());
  CHECK(named(elements, "polygon").size() == 10);
  std::map<std::string, int> lines;  // by colour and width
  for (const SvgElement& line : named(elements, "line"))
    ++lines[line.attribute("stroke") + " " + line.attribute("stroke-width")];
  // Beside those of the legend.
  CHECK(lines["#222 0.8"] == 4 + 1);
  CHECK(lines["#d62728 1.6"] == 4 + 1);
  CHECK(lines["#1f4fd6 1.6"] == 1);
}
