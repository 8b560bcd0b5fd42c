// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/curve_files.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <riprap/breakage/trigger/any_element.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

struct Folder {
  test::TemporaryFile name;
  std::filesystem::path path{name.path() + "_folder"};
  Folder() { make_folder(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }

  [[nodiscard]] std::string text(const char* file) const {
    std::ifstream in(path / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

/// At every record and break: are the files what the whole tables would be?
struct Witness {
  const Curve& curve;
  const Folder& folder;
  int records = 0;
  int breaks = 0;

  void compare() const {
    CHECK(folder.text("curve.csv") == curve_csv(curve));
    CHECK(folder.text("energy.csv") == energy_csv(curve));
    CHECK(folder.text("breakages.csv") == breakages_csv(curve));
  }
  void record(const auto& /*view*/) {
    ++records;
    compare();
  }
  void record_break(const auto& /*view*/, const auto& /*event*/) {
    ++breaks;
    compare();
  }
};

template <class... Observers>
void crush(Observers&&... observers) {
  Simulation sim{Model{}.trigger(AnyElement{}), random_assembly({.count = 60, .seed = 2}), Rock{}};
  BiaxialTest{.confining_pressure = 14e6, .axial_strain = 0.01}.run(sim, observers...);
}

}  // namespace

TEST_CASE("rows are in their files as soon as they are recorded, with the bytes of whole tables") {
  const Folder folder;
  Curve curve;
  CurveFiles files(curve, folder.path);
  Witness witness{curve, folder};
  witness.compare();
  crush(curve, files, witness);
  witness.compare();
  CHECK(witness.records == 5);
  CHECK(witness.breaks >= 3);
}

TEST_CASE("files that come before their curve have all its rows in the end") {
  const Folder folder;
  Curve curve;
  CurveFiles files(curve, folder.path);
  crush(files, curve);
  Witness{curve, folder}.compare();
}

TEST_CASE("tables of a new test replace those of an earlier one at once") {
  const Folder folder;
  write_file((folder.path / "breakages.csv").string(), "of an earlier test\n");
  const Curve curve;
  const CurveFiles files(curve, folder.path);
  Witness{curve, folder}.compare();
}

TEST_CASE("a folder that is missing is an error that names the file and the reason") {
  const Curve curve;
  CHECK_THROWS_WITH_AS(CurveFiles(curve, "/no/such"),
                       "cannot write /no/such/curve.csv: No such file or directory",
                       SimulationError);
}

TEST_CASE("a disk that becomes full names the table, and its rows so far are there") {
  if (!std::filesystem::exists("/dev/full")) return;
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.path / "energy.csv");
  const Curve curve;
  CHECK_THROWS_WITH_AS(
      CurveFiles(curve, folder.path),
      ("cannot write " + (folder.path / "energy.csv").string() + ": No space left on device")
          .c_str(),
      SimulationError);
  CHECK(folder.text("curve.csv") == curve_csv(curve));
}
