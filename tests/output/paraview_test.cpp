// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/paraview.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/temporary_file.hpp>
#include <support/vtp_document.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::read_vtp;

namespace {

/// A crushed sample with pieces, pieces of pieces and sliding contacts.
auto crushed() {
  Simulation sim{Model{}, random_assembly({.count = 60, .seed = 2}), Rock{}};
  sim.boundary().set_rate(30, 60);
  while (sim.breaks().size() < 6) sim.step();
  return sim;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

/// A folder that is gone after the test.
struct TemporaryFolder {
  test::TemporaryFile name;
  std::filesystem::path path{name.path() + "_folder"};
  TemporaryFolder() = default;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

TEST_CASE("particles are polygons with name, descent, motion, stress and Rat") {
  const auto sim = crushed();
  const Particles& particles = sim.particles();
  const auto read = read_vtp(particles_vtp(sim).document());
  REQUIRE(read.polygons == particles.size());
  const auto stresses = contact_stresses(sim.contacts(), particles);
  const auto ratios = sim.failed_ratios();
  const auto is_rattler = rattlers(sim.contacts(), particles);
  std::size_t pieces = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Ring ring = particles.ring(i);
    CHECK(read.cells[i] == std::vector<Vec2>(ring.begin(), ring.end()));
    const Ancestry& ancestry = particles.ancestry(i);
    pieces += ancestry.generation > 0;
    CHECK(read.values("id")[i] == ancestry.id);
    CHECK(read.values("parent")[i] == (ancestry.generation > 0 ? ancestry.parent : -1.0));
    CHECK(read.values("root")[i] == ancestry.root);
    CHECK(read.values("generation")[i] == ancestry.generation);
    const Body& body = particles.body(i);
    CHECK(read.values("material")[i] == 0);
    CHECK(read.values("motion")[i] == (body.is_free() ? 0 : 2));
    CHECK(read.values("velocity")[3 * i] == body.velocity.x());
    CHECK(read.values("velocity")[3 * i + 1] == body.velocity.y());
    CHECK(read.values("spin")[i] == body.angular_velocity);
    CHECK(read.values("s11")[i] == stresses[i].s11);
    CHECK(read.values("s22")[i] == stresses[i].s22);
    CHECK(read.values("s12")[i] == stresses[i].s12);
    CHECK(read.values("rattler")[i] == (is_rattler[i] ? 1 : 0));
    CHECK(read.values("rat")[i] == ratios[i]);
  }
  CHECK(pieces >= 7);
  CHECK(read.arrays.size() == 13);
}

TEST_CASE("on request particles have strains since a state, by their roots, and a smooth stress") {
  auto sim = crushed();
  const Particles& particles = sim.particles();
  auto reference = root_centroids(particles);
  // As if the sample had been stretched by 1.25 and 0.8 and turned by 0.1 since then.
  const Rotation turn = Rotation::from_angle(0.1);
  for (MaterialPoint& p : reference) {
    const Vec2 x = turn.inverse_times(p.position);
    p.position = {x.x() / 1.25, x.y() / 0.8};
  }
  reference.erase(reference.begin() + 7);  // one that is not known
  const ParticleId unknown = root_centroids(particles)[7].id;
  const double radius = 0.05;
  const auto read =
      read_vtp(particles_vtp(sim, {.reference = reference, .kernel_radius = radius}).document());
  CHECK(read.arrays.size() == 19);
  const auto stresses = coarse_grained_stresses(sim.contacts(), particles, LucyKernel{radius});
  std::size_t pieces = 0;
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const bool known = particles.ancestry(i).root != unknown;
    pieces += known && particles.ancestry(i).generation > 0;
    // Round-off of positions of 0.1 m over heights of triangles of 1 mm or more.
    CHECK(read.values("deviatoric_strain")[i] == near(known ? 0.45 : 0, 1e-12));
    CHECK(read.values("volumetric_strain")[i] == near(0, 1e-12));
    CHECK(read.values("rotation")[i] == near(known ? 0.1 : 0, 1e-12));
    CHECK(read.values("cg_s11")[i] == stresses[i].s11);
    CHECK(read.values("cg_s22")[i] == stresses[i].s22);
    CHECK(read.values("cg_s12")[i] == stresses[i].s12);
  }
  CHECK(pieces >= 7);
}

TEST_CASE("a series measures strain since its first state") {
  auto sim = crushed();
  const TemporaryFolder folder;
  ParaViewSeries series(folder.path);
  series.write(sim, 0);
  const auto first = read_vtp(text_of(folder.path / "particles_0000.vtp"));
  CHECK(first.values("deviatoric_strain")[60] == 0);
  const auto reference = root_centroids(sim.particles());
  const double radius = 3 * equivalent_diameter(sim.mean_area());
  for (int i = 0; i < 50; ++i) sim.step();
  series.write(sim, 1);
  const std::string expected =
      particles_vtp(sim, {.reference = reference, .kernel_radius = radius}).document();
  CHECK(text_of(folder.path / "particles_0001.vtp") == expected);
  CHECK(expected != particles_vtp(sim, {.kernel_radius = radius}).document());

  ParaViewSeries plain(folder.path);
  plain.local_strain = false;
  plain.kernel_diameters = 0;
  plain.write(sim, 0);
  CHECK(text_of(folder.path / "particles_0000.vtp") == particles_vtp(sim).document());
}

TEST_CASE("contacts are lines from centroid to centroid with their forces and depths") {
  const auto sim = crushed();
  const Particles& particles = sim.particles();
  const auto read = read_vtp(contacts_vtp(sim).document());
  REQUIRE(read.lines > 60);
  CHECK(read.arrays.size() == 5);
  std::size_t k = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    const auto& line = read.cells.at(k);
    REQUIRE(line.size() == 3);
    // Round-off of arms, which are differences of positions.
    CHECK((line[0] - particles.body(c.a).position).norm() <= 1e-15);
    CHECK(line[1] == c.geometry.point);
    CHECK((line[2] - particles.body(c.b).position).norm() <= 1e-15);
    CHECK(read.values("a")[k] == particles.ancestry(c.a).id);
    CHECK(read.values("b")[k] == particles.ancestry(c.b).id);
    CHECK(read.values("normal_force")[k] == c.force.normal);
    CHECK(read.values("tangential_force")[k] == c.force.tangential);
    CHECK(read.values("depth")[k] == c.geometry.depth);
    ++k;
  });
  CHECK(k == read.lines);
}

TEST_CASE("particles that never break have no Rat") {
  const test::Cross cross;
  const Simulation sim{Model{}.criterion(NeverFails{}), cross.assembly(), Rock{}};
  const auto read = read_vtp(particles_vtp(sim).document());
  CHECK(read.arrays.count("rat") == 0);
  CHECK(read.arrays.count("s11") == 1);
}

TEST_CASE("a state is two files, and a collection of each kind names them with their times") {
  const test::Cross cross;
  Simulation sim{Model{}, cross.assembly(), Rock{}};
  const TemporaryFolder folder;
  ParaViewSeries series(folder.path / "inner");
  CHECK(!std::filesystem::exists(folder.path));
  series.write(sim, 0);
  const std::string first = text_of(folder.path / "inner/particles_0000.vtp");
  CHECK(read_vtp(first).polygons == sim.particles().size());
  for (int i = 0; i < 10; ++i) sim.step();
  series.write(sim, 0.1);
  CHECK(names_in(folder.path / "inner") ==
        std::set<std::string>{"contacts.pvd", "contacts_0000.vtp", "contacts_0001.vtp",
                              "particles.pvd", "particles_0000.vtp", "particles_0001.vtp"});
  CHECK(text_of(folder.path / "inner/particles_0000.vtp") == first);
  CHECK(text_of(folder.path / "inner/contacts_0001.vtp") == contacts_vtp(sim).document());

  for (const std::string kind : {"particles", "contacts"}) {
    const auto elements = test::svg_elements(text_of(folder.path / "inner" / (kind + ".pvd")));
    REQUIRE(!elements.empty());
    CHECK(elements[0].name == "VTKFile");
    CHECK(elements[0].attribute("type") == "Collection");
    const auto sets = test::named(elements, "DataSet");
    REQUIRE(sets.size() == 2);
    CHECK(sets[0].number("timestep") == 0);
    CHECK(sets[1].number("timestep") == 0.1);
    CHECK(sets[0].attribute("file") == kind + "_0000.vtp");
    CHECK(sets[1].attribute("file") == kind + "_0001.vtp");
  }
}

TEST_CASE("in a biaxial test each record is a state, at the axial strain") {
  const test::Cross cross;
  const Simulation sim{Model{}, cross.assembly(), Rock{}};
  BiaxialView<std::remove_const_t<decltype(sim)>> view{.sim = sim};
  const TemporaryFolder folder;
  ParaViewSeries series(folder.path);
  hooks::record(series, view);
  view.stretch = {1.01, 0.875};
  hooks::record(series, view);
  const auto sets =
      test::named(test::svg_elements(text_of(folder.path / "contacts.pvd")), "DataSet");
  REQUIRE(sets.size() == 2);
  CHECK(sets[0].number("timestep") == 0);
  CHECK(sets[1].number("timestep") == 0.125);
}

TEST_CASE("a new series removes the files of the one before, and nothing else") {
  const test::Cross cross;
  const Simulation sim{Model{}, cross.assembly(), Rock{}};
  const TemporaryFolder folder;
  {
    ParaViewSeries longer(folder.path);
    for (int i = 0; i < 3; ++i) longer.write(sim, i);
  }
  const std::set<std::string> others{"particles_01.vtp",    "particles_00001.vtp.bak",
                                     "contacts_000x.vtp",   "my_particles_0000.vtp",
                                     "particles_0000.vtps", "view.pvsm"};
  for (const std::string& name : others) write_file((folder.path / name).string(), "mine");
  for (const char* name : {"contacts_12345.vtp", "particles_0003.vtp.part"})
    write_file((folder.path / name).string(), "of an earlier series");
  ParaViewSeries shorter(folder.path);
  CHECK(names_in(folder.path).size() == 10 + others.size());
  shorter.write(sim, 0);
  std::set<std::string> expected{"contacts.pvd", "contacts_0000.vtp", "particles.pvd",
                                 "particles_0000.vtp"};
  expected.insert(others.begin(), others.end());
  CHECK(names_in(folder.path) == expected);
}

TEST_CASE("a removed series leaves no empty folder, and no folder is no mistake") {
  const test::Cross cross;
  const Simulation sim{Model{}, cross.assembly(), Rock{}};
  const TemporaryFolder folder;
  CHECK_NOTHROW(ParaViewSeries::remove(folder.path));
  ParaViewSeries(folder.path).write(sim, 0);
  ParaViewSeries::remove(folder.path);
  CHECK(!std::filesystem::exists(folder.path));
}

TEST_CASE("a folder that cannot be made is an error that names the file") {
  const test::TemporaryFile file;
  write_file(file.path(), "no folder");
  const test::Cross cross;
  const Simulation sim{Model{}, cross.assembly(), Rock{}};
  ParaViewSeries series(file.path());
  CHECK_THROWS_AS(series.write(sim, 0), SimulationError);
}
