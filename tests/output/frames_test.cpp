// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/frames.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

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

std::vector<ReadRecord> records_in(const std::filesystem::path& folder) {
  std::vector<ReadRecord> records;
  read_records(FrameWriter::file_in(folder).string(), frames_signature,
               [&](const ReadRecord& r) { records.push_back(r); });
  return records;
}

std::string bytes_in(const std::filesystem::path& folder) {
  std::ifstream file(FrameWriter::file_in(folder), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Simulation<Model<>> small_sample() {
  return {Model{}, random_assembly({.count = 60, .seed = 2}), Rock{}};
}

constexpr BiaxialTest small_test{.confining_pressure = 14e6, .axial_strain = 0.05};

std::vector<double> of_kind(const std::vector<ReadRecord>& records, const std::string& kind,
                            const std::string& array) {
  std::vector<double> values;
  for (const ReadRecord& r : records)
    if (r.kind == kind) values.push_back(r.number(array));
  return values;
}

/// Mean of the element stresses by area, in laboratory axes.
Stress2 mean_stress_of(const ReadRecord& broken) {
  const auto& nodes = broken["nodes"];
  const auto& corners = broken["triangles"];
  const auto node = [&](std::size_t corner) {
    const auto n = static_cast<std::size_t>(corners[corner]);
    return Vec2{nodes[2 * n], nodes[2 * n + 1]};
  };
  Stress2 sum;
  double area = 0;
  for (std::size_t e = 0; e < corners.size() / 3; ++e) {
    const double share = 0.5 * cross(node(3 * e + 1) - node(3 * e), node(3 * e + 2) - node(3 * e));
    sum += share * Stress2{broken["s11"][e], broken["s22"][e], broken["s12"][e]};
    area += share;
  }
  CHECK(area == test::near_relative(broken["areas"][0] + broken["areas"][1], 1e-5));
  return (1 / area * sum).rotated(Rotation::from_angle(broken["pose"][2]));
}

/// Second moments of the area about the centroid, in laboratory axes [m^4].
Stress2 second_moments_of(const ReadRecord& broken) {
  const auto& nodes = broken["nodes"];
  const auto& corners = broken["triangles"];
  Stress2 sum;
  for (std::size_t e = 0; e < corners.size() / 3; ++e) {
    std::array<Vec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<std::size_t>(corners[3 * e + k]);
      p[k] = {nodes[2 * n], nodes[2 * n + 1]};
    }
    const double twelfth = cross(p[1] - p[0], p[2] - p[0]) / 24;
    for (const Vec2& v : {p[0], p[1], p[2], Vec2(p[0] + p[1] + p[2])})
      sum += twelfth * symmetric_product(v, v);
  }
  return sum.rotated(Rotation::from_angle(broken["pose"][2]));
}

/// Forwards to a writer what happens after a step: the writer joins a run there.
struct JoinsLater {
  FrameWriter& writer;
  std::uint64_t after;
  template <class View>
  void progress(const View& view) {
    if (view.sim.steps() > after) writer.progress(view);
  }
  template <class View>
  void begin_stage(const View& view) {
    if (view.sim.steps() > after) writer.begin_stage(view);
  }
  template <class View>
  void end_stage(const View& view) {
    if (view.sim.steps() > after) writer.end_stage(view);
  }
  template <class View>
  void record_break(const View& view, const BreakEvent& event) {
    if (view.sim.steps() > after) writer.record_break(view, event);
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    if (sim.steps() > after) writer.before_splits(sim);
  }
};

/// Copies the fields of a writer when so many frames are in its file.
struct CopiesState {
  const FrameWriter& writer;
  std::uint64_t frames;
  FrameWriter& copy;
  std::uint64_t step = 0;
  template <class View>
  bool stop_requested(const View& view) {
    if (step == 0 && writer.frames() == frames) {
      step = view.sim.steps();
      FieldNode fields = fields_of(writer, "writer");
      read_fields(fields, copy);
    }
    // Goes on for a while, as a run does that is killed after its last checkpoint.
    return writer.frames() == frames + 5;
  }
};

}  // namespace

TEST_CASE("a biaxial test leaves frames of all stages, particles and breaks") {
  auto sim = small_sample();
  const TemporaryFolder folder;
  FrameWriter writer{folder.path};
  const BiaxialResult result = small_test.run(sim, writer);
  const auto records = records_in(folder.path);
  REQUIRE(!records.empty());
  CHECK(records[0].kind == "RUN ");
  CHECK(records[0].number("pressure") == 14e6);
  CHECK(records[0].number("ratf") == FailedElementRatio{}.critical);

  // Every particle once, with ids that grow.
  const auto ids = of_kind(records, "PART", "id");
  REQUIRE(sim.breaks().size() >= 5);
  CHECK(ids.size() == sim.particles().size() + sim.breaks().size());
  for (std::size_t k = 0; k < ids.size(); ++k) CHECK(ids[k] == static_cast<double>(k));

  // The first and the last state of each stage, and a frame per 0.1 % of strain of shear; a frame
  // is taken at the first call of `progress` after it is due, every 128 steps.
  const auto stages = of_kind(records, "FRAM", "stage");
  const auto steps = of_kind(records, "FRAM", "step");
  CHECK(stages.size() == writer.frames());
  CHECK(std::is_sorted(stages.begin(), stages.end()));
  double first = 0;
  for (std::size_t s = 0; s < 4; ++s) {
    const auto begin = std::find(stages.begin(), stages.end(), static_cast<double>(s));
    const auto end = std::upper_bound(begin, stages.end(), static_cast<double>(s));
    REQUIRE(end - begin >= 2);
    CHECK(steps[static_cast<std::size_t>(begin - stages.begin())] == first);
    first += static_cast<double>(result.stages[s].steps);
    CHECK(steps[static_cast<std::size_t>(end - stages.begin()) - 1] == first);
  }
  const auto in_shear = std::count(stages.begin(), stages.end(), 3.0);
  CHECK(in_shear >= 40);
  CHECK(in_shear <= 52);
  // What a frame names has been described before.
  std::set<double> known;
  for (const ReadRecord& r : records) {
    if (r.kind == "PART") known.insert(r.number("id"));
    if (r.kind == "FRAM")
      for (const double id : r["id"]) CHECK(known.count(id) == 1);
  }
  CHECK(std::filesystem::file_size(FrameWriter::file_in(folder.path)) == writer.bytes());
}

TEST_CASE("a break by the contact loads has corners, loads and a mode, and no elements") {
  Simulation sim{Model{}.trigger(TsounguiStrength{}).line_fit(MeanStressLine{}),
                 random_assembly({.count = 60, .seed = 2}), Rock{}};
  const TemporaryFolder folder;
  FrameWriter writer{folder.path};
  (void)small_test.run(sim, writer);
  REQUIRE(sim.breaks().size() >= 5);
  CHECK(sim.operator_bytes() == 0);
  std::size_t breaks = 0;
  for (const ReadRecord& r : records_in(folder.path)) {
    if (r.kind == "RUN ") CHECK(!r.has("ratf"));
    if (r.kind == "FRAM") CHECK(*std::max_element(r["rat"].begin(), r["rat"].end()) == 0);
    if (r.kind != "BREK") continue;
    ++breaks;
    CHECK(r["nodes"].size() >= 6);
    for (const char* empty : {"triangles", "s11", "s22", "s12", "failed"}) CHECK(r[empty].empty());
    CHECK(r["points"].size() >= 4);
    CHECK(r.number("rat") == 0);
    CHECK(r.number("mode") == 1);
  }
  CHECK(breaks == sim.breaks().size());
}

TEST_CASE("the last frame is the state at the end") {
  auto sim = small_sample();
  const TemporaryFolder folder;
  FrameWriter writer{folder.path};
  small_test.run(sim, writer);
  const auto records = records_in(folder.path);
  const ReadRecord& frame = records.back();
  REQUIRE(frame.kind == "FRAM");
  const Particles& particles = sim.particles();
  REQUIRE(frame["x"].size() == particles.size());
  const auto ratios = sim.failed_ratios();
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    CHECK(frame["id"][i] == particles.ancestry(i).id);
    // Single precision: 6e-8 of the number.
    CHECK(frame["x"][i] == test::near_relative(body.position.x(), 1e-7));
    CHECK(frame["y"][i] == test::near_relative(body.position.y(), 1e-7));
    CHECK(frame["angle"][i] == test::near_relative(body.rotation.angle(), 1e-7));
    CHECK(frame["spin"][i] == test::near_relative(body.angular_velocity, 1e-7));
    CHECK(frame["rat"][i] == test::near_relative(ratios[i], 1e-7));
  }
  std::size_t k = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    CHECK(frame["a"][k] == particles.ancestry(c.a).id);
    CHECK(frame["b"][k] == particles.ancestry(c.b).id);
    CHECK(frame["normal"][k] == test::near_relative(c.force.normal, 1e-7));
    CHECK(frame["tangential"][k] == test::near_relative(c.force.tangential, 1e-7));
    ++k;
  });
  CHECK(frame["a"].size() == k);
}

TEST_CASE("a break is written with the stresses that caused it") {
  auto sim = small_sample();
  const TemporaryFolder folder;
  FrameWriter writer{folder.path};
  small_test.run(sim, writer);
  std::size_t k = 0;
  for (const ReadRecord& r : records_in(folder.path)) {
    if (r.kind != "BREK") continue;
    const BreakEvent& event = sim.breaks().at(k++);
    CAPTURE(k);
    CHECK(r.number("id") == event.particle.id);
    CHECK(r["pieces"][0] == event.pieces[0]);
    CHECK(r["pieces"][1] == event.pieces[1]);
    CHECK(r.number("step") == static_cast<double>(event.step));
    const auto& failed = r["failed"];
    CHECK(failed.size() == event.failures.elements);
    CHECK(std::accumulate(failed.begin(), failed.end(), 0.0) ==
          static_cast<double>(event.failures.failed));
    // The mean stress of a body is -1/(A t) sum of force times arm, symmetric part, and that of the
    // body force that balances the loads: of the angular acceleration M / J, for the other one has
    // no moments about the centroid. Loads act at the nearest point of the boundary, up to half an
    // overlap from the contact point: some per cent of the arm.
    Stress2 loads;
    double moment = 0;
    const double area = event.areas[0] + event.areas[1];
    for (std::size_t c = 0; c < r["points"].size() / 2; ++c) {
      const Vec2 arm{r["points"][2 * c] - r["pose"][0], r["points"][2 * c + 1] - r["pose"][1]};
      const Vec2 force{r["forces"][2 * c], r["forces"][2 * c + 1]};
      loads += (-1 / (area * 0.016)) * symmetric_product(force, arm);
      moment += cross(arm, force);
    }
    const Stress2 s = second_moments_of(r);
    loads +=
        (moment / (s.s11 + s.s22) / (area * 0.016)) * Stress2{-s.s12, s.s12, 0.5 * (s.s11 - s.s22)};
    const Stress2 mean = mean_stress_of(r);
    const double size = std::abs(loads.s11) + std::abs(loads.s22);
    CHECK(size > 1e6);
    CHECK(std::abs(mean.s11 - loads.s11) <= 0.05 * size);
    CHECK(std::abs(mean.s22 - loads.s22) <= 0.05 * size);
    CHECK(std::abs(mean.s12 - loads.s12) <= 0.05 * size);
  }
  CHECK(k == sim.breaks().size());
}

TEST_CASE("a run that goes on from a copy of the writer's state gives the same bytes") {
  const TemporaryFolder whole;
  const TemporaryFolder parts;
  {
    auto sim = small_sample();
    FrameWriter writer{whole.path};
    small_test.run(sim, writer);
  }
  std::uint64_t step = 0;
  FrameWriter resumed{parts.path};
  {
    auto sim = small_sample();
    FrameWriter writer{parts.path};
    CopiesState killed{writer, 60, resumed};
    const BiaxialResult result = small_test.run(sim, writer, killed);
    CHECK(result.interrupted);
    step = killed.step;
    REQUIRE(step > 0);
    CHECK(sim.breaks().size() > 1);
    CHECK(resumed.bytes() < writer.bytes());
  }
  resumed.restored();
  CHECK(bytes_in(parts.path).size() == resumed.bytes());
  auto sim = small_sample();
  JoinsLater rest{resumed, step};
  small_test.run(sim, rest);
  CHECK(bytes_in(parts.path) == bytes_in(whole.path));

  // A file that has lost what the checkpoint knows of is refused.
  std::filesystem::resize_file(FrameWriter::file_in(parts.path), 100);
  CHECK_THROWS_AS(resumed.restored(), SimulationError);
}

TEST_CASE("a writer replaces an earlier file, and leaves nothing behind when it is removed") {
  const test::Cross cross;
  const Simulation sim{Model{}.criterion(NeverFails{}), cross.assembly(), Rock{}};
  BiaxialView<std::remove_const_t<decltype(sim)>> view{.sim = sim, .area = 1};
  const TemporaryFolder folder;
  std::string first;
  for (int k = 0; k < 2; ++k) {
    FrameWriter writer{folder.path};
    CHECK((k == 1) == std::filesystem::exists(folder.path));
    writer.begin_stage(view);
    if (k == 0) first = bytes_in(folder.path);
    CHECK(bytes_in(folder.path) == first);
    // The same step again is no frame.
    writer.end_stage(view);
    CHECK(writer.frames() == 1);
  }
  FrameWriter::remove(folder.path);
  CHECK(!std::filesystem::exists(folder.path));
  CHECK_NOTHROW(FrameWriter::remove(folder.path));
  FrameWriter wrong{folder.path};
  wrong.strain_between = 0;
  CHECK_THROWS_WITH_AS(wrong.begin_stage(view),
                       "FrameWriter.strain_between = 0: must be a finite number above 0",
                       InvalidInput);
}
