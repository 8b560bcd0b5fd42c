// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/read_marked_assembly.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <riprap/core/units.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/riprap.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/temporary_folder.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::string table(const Assembly& assembly) {
  std::string text = "id,motion,x,y\n";
  for (std::size_t i = 0; i < assembly.particles.size(); ++i)
    for (const Vec2& v : assembly.particles[i].polygon)
      text += std::to_string(i) + "," +
              (assembly.particles[i].motion == Motion::free ? "free" : "strain_field") + "," +
              to_text(v.x()) + "," + to_text(v.y()) + "\n";
  return text;
}

std::string error_of(const std::string& rows) {
  const TemporaryFolder folder;
  folder.write("p.csv", "id,motion,x,y\n" + rows);
  return message_of([&] { (void)read_marked_assembly(folder / "p.csv", 0.01, 1); });
}

}  // namespace

TEST_CASE("a sample with its ring goes through a file, and runs as before") {
  const Assembly made = random_assembly({.count = 60, .seed = 5});
  const TemporaryFolder folder;
  folder.write("sample.csv", table(made));
  const Assembly read = read_marked_assembly(folder / "sample.csv", made.thickness, 1);
  REQUIRE(read.particles.size() == made.particles.size());
  for (std::size_t i = 0; i < made.particles.size(); ++i) {
    CHECK(read.particles[i].motion == made.particles[i].motion);
    CHECK(std::equal(made.particles[i].polygon.begin(), made.particles[i].polygon.end(),
                     read.particles[i].polygon.begin(), read.particles[i].polygon.end()));
  }
  // Its ring is the boundary of the default model.
  Simulation first{Model{}.criterion(NeverFails{}), made, Rock{}};
  Simulation again{Model{}.criterion(NeverFails{}), read, Rock{}};
  for (int step = 0; step < 50; ++step) {
    first.step();
    again.step();
  }
  for (BodyIndex i = 0; i < first.particles().size(); ++i)
    CHECK(first.particles().body(i).position == again.particles().body(i).position);
}

TEST_CASE("every motion has its name, and coordinates their unit") {
  const TemporaryFolder folder;
  std::string text = "id,motion,x,y\n";
  for (const std::string motion : {"free", "prescribed", "strain_field", "platen", "wall"})
    for (const std::string vertex : {"0,0", "20,0", "0,10"})
      text += motion + "," + motion + "," + vertex + "\n";
  folder.write("p.csv", text);
  const Assembly read = read_marked_assembly(folder / "p.csv", 0.01, 1_mm);
  const Motion motions[] = {Motion::free, Motion::prescribed, Motion::strain_field, Motion::platen,
                            Motion::wall};
  REQUIRE(read.particles.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) CHECK(read.particles[k].motion == motions[k]);
  CHECK(polygon_area(read.particles[0].polygon.ring()) == near_relative(1e-4, 1e-14));
}

TEST_CASE("what breaks a rule is refused with the file and the line") {
  CHECK(contains(error_of("a,fixed,0,0\n"),
                 "p.csv, line 2: motion = 'fixed': must be free, prescribed, strain_field, platen "
                 "or wall"));
  CHECK(contains(error_of("a,free,0,0\na,wall,1,0\na,free,0,1\n"),
                 "line 3: motion = 'wall': must be the same in all rows of an id"));
  CHECK(contains(error_of("a,free,0,0\na,free,1,0\n"), "lines 2 to 3, id 'a': polygon has 2"));
  CHECK(contains(error_of(""), "no polygons"));
  CHECK(contains(message_of([] { (void)read_marked_assembly("p.csv", 0.01, -1); }), "unit = -1"));
}
