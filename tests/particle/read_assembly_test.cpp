// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/read_assembly.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <riprap/simulation/simulation.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::contains;
using test::message_of;

namespace {

/// A file NAME.csv with rows of id,x,y that is gone after the test.
class CsvFile {
 public:
  explicit CsvFile(const std::string& rows)
      : path_(std::filesystem::temp_directory_path() /
              ("riprap_read_assembly_" + std::to_string(std::random_device{}()) + ".csv")) {
    std::ofstream(path_) << "id,x,y\n" << rows;
  }
  ~CsvFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const std::string square = "a,0,0\na,0.02,0\na,0.02,0.02\na,0,0.02\n";

}  // namespace

TEST_CASE("polygons of a file are free particles where they stand, in the file's order") {
  const CsvFile file(square + "b,0.03,0\nb,0.06,0\nb,0.03,0.06\n");
  const Assembly assembly = read_assembly(file.path(), 0.5);
  CHECK(assembly.thickness == 0.5);
  REQUIRE(assembly.particles.size() == 2);
  CHECK(assembly.particles[0].motion == Motion::free);
  const AreaProperties triangle = area_properties(assembly.particles[1].polygon.ring());
  CHECK(triangle.area == test::near_relative(0.5 * 0.03 * 0.06, 1e-15));
  CHECK(triangle.centroid.x() == test::near_relative(0.04, 1e-15));
  CHECK(triangle.centroid.y() == test::near_relative(0.02, 1e-15));
  const Simulation sim{Model{}, assembly, Rock{.density = 2500}};
  CHECK(sim.particles().body(0).mass == test::near_relative(2500 * 0.5 * 4e-4, 1e-15));
}

TEST_CASE("polygons that are fixed") {
  const CsvFile file(square);
  const Assembly assembly = placed_assembly(read_polygons(file.path()), 0.016, Motion::prescribed);
  CHECK(assembly.particles[0].motion == Motion::prescribed);
}

TEST_CASE("a thickness that is no length is refused") {
  const CsvFile file(square);
  CHECK(message_of([&] { (void)read_assembly(file.path(), 0); }) ==
        "Assembly.thickness = 0: must be a finite number above 0");
}

TEST_CASE("particles that lie in one another are refused by the simulation, with their ids") {
  const CsvFile file(square + "b,0.001,0\nb,0.021,0\nb,0.021,0.02\nb,0.001,0.02\n");
  const Assembly assembly = read_assembly(file.path(), 0.016);
  const std::string message = message_of([&] { const Simulation sim{Model{}, assembly, Rock{}}; });
  CHECK_MESSAGE(contains(message, "particle 0"), message);
  CHECK_MESSAGE(contains(message, "particle 1"), message);
}
