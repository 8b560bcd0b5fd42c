// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <replay/binary.hpp>
#include <replay/pack.hpp>
#include <replay/page.hpp>
#include <replay/recorded_run.hpp>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>
#include <riprap/output/frame_records.hpp>
#include <support/near.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

Record particle(std::uint32_t id, std::uint32_t parent, std::uint32_t root) {
  Record r("PART");
  r.add("id", id);
  r.add("parent", parent);
  r.add("root", root);
  r.add("generation", std::uint32_t{parent == no_particle ? 0u : 1u});
  r.add("motion", std::uint32_t{0});
  r.add("area", 1e-4);
  r.add("vertices", std::vector<float>{0, 0, 0.01f, 0, 0, 0.01f});
  return r;
}

Record particle(std::uint32_t id, std::uint32_t parent) { return particle(id, parent, id); }

/// Particles `ids` in a row, turned by `angle`; the first two touch.
Record frame(std::uint32_t stage, std::uint64_t step, const std::vector<std::uint32_t>& ids,
             float angle = 0) {
  Record r("FRAM");
  const std::vector<float> zeros(ids.size(), 0);
  std::vector<float> x;
  for (const std::uint32_t id : ids) x.push_back(0.1f * static_cast<float>(id));
  r.add("step", step);
  r.add("time", 0.0);
  r.add("breaks", std::uint32_t{0});
  r.add("stage", stage);
  r.add("strains", std::vector<double>{0, 0});
  r.add("stress", std::vector<double>{1e6, 2e6, 0});
  r.add("id", ids);
  r.add("x", x);
  r.add("angle", std::vector<float>(ids.size(), angle));
  for (const char* name : {"y", "vx", "vy", "spin", "rat"}) r.add(name, zeros);
  r.add("a", std::vector<std::uint32_t>{ids[0]});
  r.add("b", std::vector<std::uint32_t>{ids[1]});
  for (const char* name : {"px", "py", "tangential"}) r.add(name, std::vector<float>{0});
  r.add("normal", std::vector<float>{100});
  return r;
}

Record a_break(std::uint32_t id, std::vector<std::uint32_t> pieces) {
  Record r("BREK");
  for (const char* name : {"pose", "nodes", "s11", "s22", "s12", "points", "forces", "line"})
    r.add(name, std::vector<float>(4, 0));
  for (const char* name : {"triangles", "failed"}) r.add(name, std::vector<std::uint32_t>{0});
  r.add("step", std::uint64_t{0});
  for (const char* name : {"time", "strain", "rat"}) r.add(name, 0.0);
  r.add("id", id);
  r.add("pieces", pieces);
  r.add("areas", std::vector<double>{1, 1});
  r.add("mode", std::uint32_t{1});
  r.add("stage", std::uint32_t{3});
  return r;
}

replay::RecordedRun read(const std::vector<Record>& records, unsigned every) {
  Record head("RUN ");
  head.add("pressure", 2e6);
  head.add("diameter", 0.016);
  head.add("thickness", 0.016);
  std::string text = std::string(frames_signature) + head.bytes();
  for (const Record& r : records) text += r.bytes();
  const test::TemporaryFile file;
  write_file(file.path(), text);
  return replay::read_run(file.path(), every);
}

}  // namespace

TEST_CASE("replay: base64 is that of RFC 4648") {
  const std::vector<std::pair<std::string, std::string>> table{{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"}};
  for (const auto& [text, expected] : table) CHECK(replay::base64(text) == expected);
  CHECK(replay::base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("replay: numbers become integers, and what is outside the range its end") {
  CHECK(replay::quantised<std::int16_t>(1, 2) == 16384);  // 32767 / 2, rounded away from zero
  CHECK(replay::quantised<std::int16_t>(-2, 2) == -32767);
  CHECK(replay::quantised<std::int16_t>(5, 2) == 32767);
  CHECK(replay::quantised<std::uint16_t>(-5, 2) == 0);
  CHECK(replay::quantised<std::uint16_t>(2, 2) == 65535);
  CHECK(replay::quantised<std::uint16_t>(1, 0) == 0);
  CHECK(replay::quantised<std::int16_t>(std::numeric_limits<double>::quiet_NaN(), 1) == 0);
}

TEST_CASE("replay: of every few frames the first and the last of each stage are kept") {
  std::vector<Record> records{particle(0, no_particle), particle(1, no_particle),
                              particle(2, no_particle)};
  // Steps 0 to 6 in stage 0, 7 to 9 in stage 3; particle 0 breaks after step 4 into 3 and 4.
  for (std::uint64_t step = 0; step < 10; ++step) {
    const std::uint32_t stage = step < 7 ? 0 : 3;
    records.push_back(step < 5 ? frame(stage, step, {2, 0, 1}) : frame(stage, step, {3, 1, 2, 4}));
    if (step == 4) {
      records.push_back(particle(3, 0));
      records.push_back(particle(4, 0));
      records.push_back(a_break(0, {3, 4}));
    }
  }
  const auto steps = [](const replay::RecordedRun& run) {
    std::vector<double> out;
    for (const ReadRecord& f : run.frames) out.push_back(f.number("step"));
    return out;
  };
  const auto all = read(records, 1);
  CHECK(all.frames.size() == 10);
  CHECK(all.breaks.at(0).frame == 4);
  CHECK(all.particles[0].last == 4);
  CHECK(all.particles[3].first == 5);
  const auto some = read(records, 3);
  CHECK(steps(some) == std::vector<double>{0, 3, 6, 7, 9});
  CHECK(some.breaks.at(0).frame == 1);
  CHECK(some.particles[0].last == 1);
  CHECK(some.particles[3].first == 2);
  CHECK(steps(read(records, 100)) == std::vector<double>{0, 6, 7, 9});
}

TEST_CASE("replay: particles of a frame are packed by id, and turns are counted on") {
  std::vector<Record> records{particle(0, no_particle), particle(1, no_particle)};
  // A quarter of a turn from frame to frame, five times, as angles within half a turn.
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (int k = 0; k < 6; ++k)
    records.push_back(frame(3, static_cast<std::uint64_t>(k), {1, 0},
                            static_cast<float>(std::remainder(k * quarter, 4 * quarter))));
  const replay::PackedRun packed = replay::pack(read(records, 1));
  const auto number = [&](const char* array, std::size_t k) {
    const auto& index = packed.arrays.index()[array];
    std::int16_t value = 0;
    std::memcpy(&value, packed.arrays.bytes().data() + index["offset"].get<std::size_t>() + 2 * k,
                2);
    return value;
  };
  CHECK(packed.head["frames"].size() == 6);
  CHECK(packed.arrays.index()["angle"]["type"] == "Int16Array");
  CHECK(packed.arrays.index()["angle"]["count"] == 12);
  CHECK(static_cast<std::uint16_t>(number("x", 0)) == 0);  // particle 0, on the left
  CHECK(static_cast<std::uint16_t>(number("x", 1)) == 65535);
  CHECK(number("contactA", 0) == 1);
  CHECK(number("contactB", 0) == 0);
  const double unit = packed.head["mostTurn"].get<double>() / 32767;
  // Half a step of the integers.
  CHECK(std::abs(number("angle", 10) * unit - 5 * quarter) <= 0.51 * unit);
}

TEST_CASE("replay: materials are packed where there are several") {
  const auto packed = [](std::uint32_t material) {
    Record of_rock = particle(1, no_particle);
    of_rock.add("material", material);
    return replay::pack(read({particle(0, no_particle), of_rock, frame(3, 0, {0, 1})}, 1));
  };
  CHECK_FALSE(packed(0).arrays.index().contains("material"));
  const replay::PackedRun two = packed(2);
  REQUIRE(two.arrays.index().contains("material"));
  const std::size_t at = two.arrays.index()["material"]["offset"].get<std::size_t>();
  CHECK(two.arrays.bytes()[at] == 0);  // of an earlier version, without a material
  CHECK(two.arrays.bytes()[at + 1] == 2);
}

TEST_CASE("replay: rattlers, the mean force and the strain since the start of shear are packed") {
  // Four particles at the corners of a square, of which 0 breaks into 4 and 5, which stay together.
  std::vector<Record> records;
  for (std::uint32_t id = 0; id < 4; ++id) records.push_back(particle(id, no_particle));
  for (std::uint32_t id = 4; id < 6; ++id) {
    records.push_back(particle(id, 0, 0));
  }
  const auto add_frame = [&](std::uint32_t stage, std::uint64_t step,
                             const std::vector<std::uint32_t>& ids, const std::vector<float>& x,
                             const std::vector<float>& y) {
    Record r("FRAM");
    r.add("step", step);
    r.add("time", 0.0);
    r.add("breaks", std::uint32_t{0});
    r.add("stage", stage);
    r.add("strains", std::vector<double>{0, 0});
    r.add("stress", std::vector<double>{1e6, 2e6, 0});
    r.add("id", ids);
    r.add("x", x);
    r.add("y", y);
    for (const char* name : {"angle", "vx", "vy", "spin", "rat"})
      r.add(name, std::vector<float>(ids.size(), 0));
    // 1-2-3 hold each other; 1 touches another particle, without force.
    r.add("a", std::vector<std::uint32_t>{1, 2, 1, ids[0]});
    r.add("b", std::vector<std::uint32_t>{2, 3, 3, 1});
    r.add("normal", std::vector<float>{10, 20, 60, 0});
    for (const char* name : {"px", "py", "tangential"}) r.add(name, std::vector<float>(4, 0));
    records.push_back(r);
  };
  add_frame(2, 0, {0, 1, 2, 3}, {5, 1, 1, 0}, {0, 0, 1, 1});  // before shear: anywhere
  add_frame(3, 1, {0, 1, 2, 3}, {0, 1, 1, 0}, {0, 0, 1, 1});
  // Simple shear of 0.25; the two pieces of 0, of equal areas, lie on both sides of where it was.
  add_frame(3, 2, {4, 1, 2, 3, 5}, {-0.125f, 1, 1.25f, 0.25f, 0.125f}, {0, 0, 1, 1, 0});
  const replay::PackedRun packed = replay::pack(read(records, 1));
  const auto bytes = [&](const char* array) {
    return packed.arrays.bytes().data() + packed.arrays.index()[array]["offset"].get<std::size_t>();
  };
  const auto& last = packed.head["frames"][2];
  CHECK(last["meanForce"].get<double>() == 30);
  CHECK(last["deviatoric"].get<double>() == test::near(0.25, 1e-12));
  CHECK(packed.head["frames"][0]["deviatoric"].get<double>() == 0);
  CHECK(packed.head["frames"][1]["deviatoric"].get<double>() == 0);
  // Of ids 0 to 3, 0 to 3, and 1, 2, 3, 4, 5.
  const std::vector<int> rattlers{1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 1};
  for (std::size_t k = 0; k < rattlers.size(); ++k) CHECK(bytes("rattler")[k] == rattlers[k]);
  for (std::size_t k = 0; k < 5; ++k) {
    std::uint16_t strain = 0;
    std::memcpy(&strain, bytes("strain") + 2 * (8 + k), 2);
    // All have the largest strain, but for round-off of one step.
    CHECK(strain >= 65534);
  }
}

TEST_CASE("replay: the page has everything in it, and the title cannot end its data") {
  const auto run =
      read({particle(0, no_particle), particle(1, no_particle), frame(3, 0, {0, 1})}, 1);
  const std::string page = replay::page_of(run, "</script><b>&");
  CHECK(page.find("{{") == std::string::npos);
  CHECK(page.find("</script><b>") == std::string::npos);
  CHECK(page.find("&lt;/script>&lt;b>&amp;") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);
}

TEST_CASE("replay: a file without frames, and a particle that was never described, are refused") {
  CHECK_THROWS_AS(read({}, 1), InvalidInput);
  CHECK_THROWS_AS(read({particle(1, no_particle)}, 1), InvalidInput);
  CHECK_THROWS_AS(read({particle(0, no_particle), frame(0, 0, {0, 1})}, 1), InvalidInput);
}
