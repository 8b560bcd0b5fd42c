// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/read_grading.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;
using test::message_of;
using test::near_relative;

namespace {

// Round-off of a few logarithms.
constexpr double round_off = 1e-14;

Grading read(const std::string& rows) {
  std::istringstream in("size,passing\n" + rows);
  return read_grading(in, "g.csv");
}
std::string refusal(const std::string& rows) {
  return message_of([&] { (void)read(rows); });
}

/// The grading of particles of these diameters: their masses are proportional to the squares.
Grading sample(const std::vector<double>& diameters) {
  std::vector<SizeFraction> fractions;
  for (const double d : diameters) fractions.push_back({d, d * d});
  return Grading::of_fractions(fractions);
}

}  // namespace

TEST_CASE("a table of sieves is a grading") {
  const Grading g = read("0.001,0.1\n0.01,0.6\n0.1,1\n");
  CHECK(g.points().size() == 3);
  CHECK(g.passing(0.01) == near_relative(0.6, round_off));
  CHECK(g.size_at(0.35) == near_relative(std::sqrt(10) * 1e-3, round_off));
}

TEST_CASE("a table that breaks a rule is refused with file, line, value and rule") {
  CHECK(refusal("") == "g.csv: no sieves: must have one or more");
  CHECK(refusal("0.001,0.1\n") == "g.csv, line 2: passing = '0.1': must be 1 in the last row");
  CHECK(refusal("0,1\n") == "g.csv, line 2: size = '0': must be above 0");
  CHECK(refusal("0.002,0.1\n0.001,1\n") == "g.csv, line 3: size = '0.001': must not descend");
  CHECK(refusal("0.001,0.5\n0.002,0.4\n") == "g.csv, line 3: passing = '0.4': must not descend");
  CHECK(refusal("0.001,60\n0.002,100\n") == "g.csv, line 2: passing = '60': must lie in [0, 1]");
  CHECK(refusal("0.001,-0.1\n") == "g.csv, line 2: passing = '-0.1': must lie in [0, 1]");
  CHECK(refusal("0.001,half\n") == "g.csv, line 2: passing = 'half': must be a finite number");
  std::istringstream in("size;passing\n0.001;1\n");
  CHECK(message_of([&] { (void)read_grading(in, "g.csv"); }) ==
        "g.csv, line 1: header 'size;passing': must be size,passing");
}

TEST_CASE("a table is read from a file") {
  const test::TemporaryFile file;
  CHECK(message_of([&] { (void)read_grading(std::filesystem::path(file.path())); }) ==
        "cannot read " + file.path() + ": No such file or directory");
  std::ofstream(file.path()) << "size,passing\n0.016,1\n";
  CHECK(read_grading(std::filesystem::path(file.path())).largest() == 0.016);
}

TEST_CASE("particles of one size") {
  CHECK(graded_diameters(read("0.016,1\n"), 3) == std::vector<double>{0.016, 0.016, 0.016});
  CHECK(graded_diameters(read("0.016,1\n"), 0).empty());
}

TEST_CASE("two sizes of equal mass: four small particles to one of twice the diameter") {
  const auto d = graded_diameters(Grading::of_fractions({{0.01, 1}, {0.02, 1}}), 10);
  CHECK(std::count(d.begin(), d.end(), 0.01) == 8);
  CHECK(std::count(d.begin(), d.end(), 0.02) == 2);
}

TEST_CASE("the median by number of a grading that is straight over the logarithm of size") {
  // n(s) is proportional to 1 / s0^2 - 1 / s^2: half of it at s^-2 = (s0^-2 + s1^-2) / 2.
  const auto d = graded_diameters(read("0.01,0\n0.04,1\n"), 1);
  REQUIRE(d.size() == 1);
  CHECK(d[0] == near_relative(0.04 / std::sqrt(0.5 * (1 + 16)), round_off));
}

TEST_CASE("the sample follows the grading to the mass of its largest particle") {
  const Grading wanted = read("0.005,0.05\n0.01,0.3\n0.02,0.3\n0.04,0.9\n0.06,1\n0.06,1\n");
  for (const std::size_t count : {50u, 500u, 5000u}) {
    CAPTURE(count);
    const std::vector<double> diameters = graded_diameters(wanted, count);
    REQUIRE(diameters.size() == count);
    CHECK(std::is_sorted(diameters.begin(), diameters.end()));
    CHECK(diameters.front() >= 0.005 * (1 - round_off));
    CHECK(diameters.back() <= 0.06 * (1 + round_off));
    double mass = 0;
    for (const double d : diameters) mass += d * d;
    // The mass of a share of the number is that of its middle to a part of the largest particle's;
    // the total, to which all shares refer, is off by as much.
    const double tolerance = 2 * 0.06 * 0.06 / mass;
    const Grading made = sample(diameters);
    for (const double size : {0.006, 0.0099, 0.015, 0.021, 0.03, 0.039, 0.05})
      CHECK(made.passing(size) == test::near(wanted.passing(size), tolerance));
  }
}
