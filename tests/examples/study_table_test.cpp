// SPDX-License-Identifier: BSL-1.0
#include <study/runs.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

#include <biaxial/options.hpp>
#include <biaxial/policies.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace run_study;
using riprap::test::contains;
using riprap::test::message_of;

namespace {

Study study(const std::string& text) { return study_of(table_from_toml("t.toml", text)); }
std::string refusal(const std::string& text) {
  return message_of([&] { (void)study(text); });
}
std::vector<std::string> folders(const Study& s) {
  std::vector<std::string> names;
  for (const Run& run : s.runs) names.push_back(run.folder);
  return names;
}
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("lists make every combination, with every seed, in the order of the table") {
  const Study s = study("seeds = 2\n[base]\nparticles = 60\n"
                        "[axes]\npressure = [0.5e6, 2e6]\nbreakage = [\"off\", \"on\"]\n");
  CHECK(folders(s) == Names{"pressure=5e5_breakage=off_seed=1", "pressure=5e5_breakage=off_seed=2",
                            "pressure=5e5_breakage=on_seed=1", "pressure=5e5_breakage=on_seed=2",
                            "pressure=2e6_breakage=off_seed=1", "pressure=2e6_breakage=off_seed=2",
                            "pressure=2e6_breakage=on_seed=1", "pressure=2e6_breakage=on_seed=2"});
  CHECK(s.options == Names{"particles", "pressure", "breakage"});
  // The file of parameters is the one that the biaxial example leaves of such a run.
  const Options o =
      options_from({"--particles", "60", "--pressure", "2e6", "--breakage", "off", "--seed", "2"});
  CHECK(s.runs[5].toml == o.toml);
  CHECK(s.runs[5].parameters.at("particles") == "60");
  CHECK(s.runs[5].seed == 2);
}

TEST_CASE("rows have names, options over those of the base, and seeds of their own") {
  const Study s = study("seeds = [7]\n[base]\nfriction = 0.4\n[[rows]]\nname = \"one / two\"\n"
                        "friction = 0.3\n[[rows]]\nseeds = [2, 4]\nfriction = 0.2\n"
                        "[[rows]]\nname = 'x'\npressure = [1e6,\n  3e6]  # two lines\n");
  CHECK(folders(s) == Names{"one---two_seed=7", "friction=0.2_seed=2", "friction=0.2_seed=4",
                            "x_pressure=1e6_seed=7", "x_pressure=3e6_seed=7"});
  CHECK(s.runs[0].parameters.at("friction") == "0.3");
  CHECK(s.runs[4].parameters.at("friction") == "0.4");
  CHECK(s.runs[4].row == "x");
  CHECK(folders(study("")) == Names{"seed=1"});
}

TEST_CASE("folders have a name each: a hash where parameters do not tell them apart") {
  const Study s = study("[[rows]]\nname = \"a\"\nfriction = 0.3\n[[rows]]\nname = \"a\"\n"
                        "friction = 0.4\n[[rows]]\nname = \"b\"\n");
  const Names names = folders(s);
  CHECK(names[0].starts_with("a_seed=1_"));
  CHECK(names[0].size() == std::string("a_seed=1_01234567").size());
  CHECK(names[0] != names[1]);
  CHECK(names[2] == "b_seed=1");
  const Names long_name = folders(study("[[rows]]\nname = \"" + std::string(300, 'a') + "\"\n"));
  CHECK(long_name[0].size() == 129);
}

TEST_CASE("a line of a CSV file is a run") {
  const TableFile file =
      table_from_csv("t.csv", "name,seed,pressure,dust\n# two\n,3,2e6,true\r\nlast,,1e6,\n");
  const Study s = study_of(file);
  CHECK(folders(s) == Names{"pressure=2e6_dust=true_seed=3", "last_seed=1"});
  CHECK(s.runs[1].parameters.at("dust") == "false");
  const auto refusal_of = [](const char* text) {
    return message_of([&] { (void)study_of(table_from_csv("t.csv", text)); });
  };
  CHECK(refusal_of("pressure,pressure\n") == "t.csv, line 1: a name comes twice");
  CHECK(contains(refusal_of("pressure\n1e6,2\n"), "t.csv, line 2: 2 cells: must be as many"));
  CHECK(contains(refusal_of("pressure\n\"1e6\"\n"), "line 2: quotes have no meaning here"));
  CHECK(contains(refusal_of("seed\n-1\n"), "t.csv, line 2: seed: '-1' is not a whole number"));
  CHECK(contains(refusal_of("pressure\n-1\n"), "t.csv, line 2: --pressure = -1: must be"));
  CHECK(refusal_of("pressure\n") == "t.csv, line 1: no runs");
}

TEST_CASE("what is wrong is refused with file, line, name and rule") {
  CHECK(refusal("\n[base]\npresure = 1\n") ==
        "t.toml, line 3: 'presure' is not the name of an option, without its dashes");
  CHECK(refusal("[base]\nfriction = 0.5\nyoung = 0\n") ==
        "t.toml, line 3: --young = 0: must be a finite number above 0");
  CHECK(refusal("[axes]\nparticles = [60,\n 1.5]\n") ==
        "t.toml, line 2: --particles: '1.5' is not a whole number from 0 to 4294967295");
  CHECK(contains(refusal("[base]\ncontact = \"x\"\n"), "line 2: --contact: 'x' is none of"));
  CHECK(
      contains(refusal("[base]\n\ncohesion = 1e7\n"), "line 3: --cohesion: goes with --criterion"));
  CHECK(contains(refusal("[base]\npressure = [1]\n"), "line 2: pressure: a list belongs into"));
  CHECK(contains(refusal("[axes]\npressure = 1e6\n"), "line 2: pressure: must be a list here"));
  CHECK(contains(refusal("[axes]\npressure = []\n"), "pressure: the list must not be empty"));
  CHECK(contains(refusal("[axes]\nmesh-triangles = [\"\"]\n"), "must not be empty"));
  CHECK(contains(refusal("[base]\nout = \"x\"\n"), "line 2: 'out' is not set by a table"));
  CHECK(contains(refusal("[axes]\nseed = [1, 2]\n"), "whose seeds are 'seeds'"));
  CHECK(contains(refusal("seeds = 0\n"), "line 1: seeds: must be a list, or a count"));
  CHECK(contains(refusal("seeds = [-1]\n"), "line 1: seeds: '-1' is not a whole number"));
  CHECK(contains(refusal("seeds = 1\nseeds = 2\n"), "line 2: 'seeds' comes twice"));
  CHECK(contains(refusal("[base]\ndust = true\ndust = true\n"), "line 3: 'dust' comes twice"));
  CHECK(contains(refusal("dust = true\n"), "line 1: 'dust' stands before the first section"));
  CHECK(contains(refusal("[bases]\n"), "line 1: '[bases]' is none of"));
  CHECK(contains(refusal("[base]\n[base]\n"),
                 "line 2: '[base]' is none of [base], [axes], each once"));
  CHECK(contains(refusal("[base]\nfriction\n"), "line 2: 'friction' is not NAME = VALUE"));
  CHECK(contains(refusal("[axes]\npressure = [1e6\n"), "line 2: the list has no end"));
}

TEST_CASE("a run that comes twice is refused, however its values are written") {
  CHECK(contains(refusal("[axes]\npressure = [2e6, 2000000]\n"), "the same run as one of the row"));
  // 0.5 is the default.
  CHECK(contains(refusal("[[rows]]\nname = \"a\"\n[[rows]]\nname = \"b\"\nfriction = 0.5\n"),
                 "t.toml, line 3: b_seed=1: the same run as one of the row in line 1"));
  CHECK(contains(refusal("seeds = [1, 1]\n"), "the same run"));
}

TEST_CASE("in the table of the size effect strengths fall with size as d^(-3 / 4)") {
  const Study s = study_of(read_table(RIPRAP_STUDY_TABLES "/size_effect.toml"));
  CHECK(s.runs.size() == 5 * 3 * 8);
  std::set<double> diameters;
  for (const Run& run : s.runs) {
    std::vector<std::string> arguments;
    for (const auto& [name, value] : run.parameters) arguments.push_back("--" + name + "=" + value);
    const Options o = options_from(arguments);
    const double d = o.assembly.mean_diameter;
    diameters.insert(d);
    const riprap::WeibullStrength strength = chosen_element_trigger(o);
    const auto of = [&](double size) {
      return strength.strength_factor(3, 0.25 * std::numbers::pi * size * size);
    };
    CHECK(of(d) / of(0.016) == riprap::test::near_relative(std::pow(d / 0.016, -0.75), 1e-13));
    CHECK(strength.seed == run.seed);
  }
  CHECK(diameters == std::set<double>{0.004, 0.008, 0.016, 0.032, 0.064});
}

TEST_CASE("all shards together have every run once") {
  const Study s = study("seeds = 11\n");
  for (const std::size_t n : {1U, 2U, 3U, 11U, 20U}) {
    std::multiset<std::string> names;
    for (std::size_t i = 1; i <= n; ++i)
      for (const Run& run : runs_of_shard(s.runs, {i, n})) names.insert(run.folder);
    const Names all = folders(s);
    CHECK(names == std::multiset<std::string>(all.begin(), all.end()));
  }
  CHECK(runs_of_shard(s.runs, {2, 4})[1].folder == "seed=6");
  CHECK(shard_from("2/4").index == 2);
  CHECK(shard_from("2/4").count == 4);
  for (const char* wrong : {"", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "a/b"})
    CHECK(contains(message_of([&] { (void)shard_from(wrong); }), "is not I/N with 1 <= I <= N"));
}
