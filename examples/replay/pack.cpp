// SPDX-License-Identifier: BSL-1.0
#include "pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/version.hpp>
#include <riprap/experiment/stage.hpp>

#include "frame_measures.hpp"

namespace replay {

namespace {

using Json = nlohmann::ordered_json;
using riprap::ReadRecord;

// Turns are counted on; so many fit into the integers of a page.
constexpr double most_turn = 8 * std::numbers::pi;

// Where everything is, at all times.
struct Box {
  double x = std::numeric_limits<double>::max();
  double y = std::numeric_limits<double>::max();
  double right = std::numeric_limits<double>::lowest();
  double top = std::numeric_limits<double>::lowest();

  void include(double px, double py) {
    if (!std::isfinite(px) || !std::isfinite(py)) return;
    x = std::min(x, px);
    y = std::min(y, py);
    right = std::max(right, px);
    top = std::max(top, py);
  }
  [[nodiscard]] std::uint16_t packed_x(double px) const {
    return quantised<std::uint16_t>(px - x, right - x);
  }
  [[nodiscard]] std::uint16_t packed_y(double py) const {
    return quantised<std::uint16_t>(py - y, top - y);
  }
};

Box box_of(const RecordedRun& run) {
  Box box;
  for (const ReadRecord& f : run.frames) {
    const auto& x = f["x"];
    const auto& y = f["y"];
    for (std::size_t k = 0; k < x.size(); ++k) box.include(x[k], y[k]);
    for (std::size_t k = 0; k < f["px"].size(); ++k) box.include(f["px"][k], f["py"][k]);
  }
  return box;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

// Numbers of all frames one behind the other.
struct Columns {
  std::vector<std::uint16_t> x{}, y{};
  std::vector<std::int16_t> angle{}, vx{}, vy{}, spin{};
  std::vector<std::uint16_t> rat{}, strain{};
  std::vector<std::uint8_t> rattler{};
  std::vector<std::uint16_t> a{}, b{}, px{}, py{}, normal{};
  std::vector<std::int16_t> tangential{};
};

// Of one frame after the other, particles in the order of their ids.
class FramePacker {
 public:
  FramePacker(const Box& box, const RecordedRun& run)
      : box_(box), measures_(run), turn_(run.particles.size(), 0), angle_(run.particles.size(), 0),
        place_(run.particles.size(), 0) {}

  Json add(const ReadRecord& f) {
    const auto& id = f["id"];
    riprap::require(id.size() < 65536, "replay: particles of a frame",
                    static_cast<double>(id.size()), "must be below 65536");
    const double speed = std::max(largest(f["vx"]), largest(f["vy"]));
    const double spin = largest(f["spin"]);
    const double force = std::max(largest(f["normal"]), largest(f["tangential"]));
    const std::vector<double> strains = measures_.deviatoric_strains(f);
    const double deviatoric = largest(strains);
    Json j = {{"step", f.number("step")},
              {"time", f.number("time")},
              {"stage", f.number("stage")},
              {"strain", f["strains"].at(0)},
              {"volumetric", f["strains"].at(1)},
              {"stress", f["stress"]},
              {"breaks", f.number("breaks")},
              {"particles", id.size()},
              {"contacts", f["a"].size()},
              {"speed", speed},
              {"spin", spin},
              {"force", force},
              {"meanForce", mean_normal_force(f)},
              {"deviatoric", deviatoric}};
    if (f.has("cell")) j["cell"] = f["cell"];
    add_particles(f, speed, spin);
    add_measures(f, strains, deviatoric);
    add_contacts(f, force);
    return j;
  }
  [[nodiscard]] const Columns& columns() const { return c_; }

 private:
  // Places in a frame by rising id.
  static std::vector<std::size_t> order_of(const ReadRecord& f) {
    const auto& id = f["id"];
    std::vector<std::size_t> order(id.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t k, std::size_t l) { return id[k] < id[l]; });
    return order;
  }

  void add_particles(const ReadRecord& f, double speed, double spin) {
    const auto& id = f["id"];
    const std::vector<std::size_t> order = order_of(f);
    for (std::size_t n = 0; n < order.size(); ++n) {
      const std::size_t k = order[n];
      const auto particle = static_cast<std::size_t>(id[k]);
      place_[particle] = static_cast<std::uint16_t>(n);
      c_.x.push_back(box_.packed_x(f["x"][k]));
      c_.y.push_back(box_.packed_y(f["y"][k]));
      c_.angle.push_back(quantised<std::int16_t>(whole_turn(particle, f["angle"][k]), most_turn));
      c_.vx.push_back(quantised<std::int16_t>(f["vx"][k], speed));
      c_.vy.push_back(quantised<std::int16_t>(f["vy"][k], speed));
      c_.spin.push_back(quantised<std::int16_t>(f["spin"][k], spin));
      c_.rat.push_back(quantised<std::uint16_t>(f["rat"][k], 1));
    }
  }

  void add_measures(const ReadRecord& f, const std::vector<double>& strains, double range) {
    const std::vector<bool> is_rattler = measures_.rattlers(f);
    for (const std::size_t k : order_of(f)) {
      c_.strain.push_back(quantised<std::uint16_t>(strains[k], range));
      c_.rattler.push_back(is_rattler[k]);
    }
  }

  // The angle since the particle appeared, beyond half a turn. Frames are closer than that.
  double whole_turn(std::size_t particle, double angle) {
    constexpr double turn = 2 * std::numbers::pi;
    turn_[particle] += std::remainder(angle - angle_[particle], turn);
    angle_[particle] = angle;
    // Some whole turns less where there are too many.
    return std::remainder(turn_[particle], 2 * most_turn);
  }

  void add_contacts(const ReadRecord& f, double force) {
    for (std::size_t k = 0; k < f["a"].size(); ++k) {
      c_.a.push_back(place_[static_cast<std::size_t>(f["a"][k])]);
      c_.b.push_back(place_[static_cast<std::size_t>(f["b"][k])]);
      c_.px.push_back(box_.packed_x(f["px"][k]));
      c_.py.push_back(box_.packed_y(f["py"][k]));
      c_.normal.push_back(quantised<std::uint16_t>(f["normal"][k], force));
      c_.tangential.push_back(quantised<std::int16_t>(f["tangential"][k], force));
    }
  }

  const Box& box_;
  FrameMeasures measures_;
  std::vector<double> turn_;          // so far, by particle
  std::vector<double> angle_;         // in the frame before
  std::vector<std::uint16_t> place_;  // in this frame
  Columns c_{};
};

void add_columns(const Columns& c, Binary& arrays) {
  arrays.add("x", c.x);
  arrays.add("y", c.y);
  arrays.add("angle", c.angle);
  arrays.add("vx", c.vx);
  arrays.add("vy", c.vy);
  arrays.add("spin", c.spin);
  arrays.add("rat", c.rat);
  arrays.add("strain", c.strain);
  arrays.add("rattler", c.rattler);
  arrays.add("contactA", c.a);
  arrays.add("contactB", c.b);
  arrays.add("contactX", c.px);
  arrays.add("contactY", c.py);
  arrays.add("normal", c.normal);
  arrays.add("tangential", c.tangential);
}

template <class T>
std::vector<T> cast(const std::vector<double>& values) {
  std::vector<T> out;
  out.reserve(values.size());
  for (const double v : values) out.push_back(static_cast<T>(v));
  return out;
}

template <class T>
void append(std::vector<T>& to, const std::vector<double>& values) {
  for (const double v : values) to.push_back(static_cast<T>(v));
}

// One entry per particle, and the vertices of all.
void add_particles(const RecordedRun& run, Binary& arrays) {
  std::vector<std::int32_t> parent, root, first, last;
  std::vector<std::uint8_t> generation, motion, material;
  std::vector<float> area, vertices;
  std::vector<std::uint32_t> start{0};
  for (const RecordedParticle& p : run.particles) {
    const double from = p.record.number("parent");
    parent.push_back(from == riprap::no_particle ? -1 : static_cast<std::int32_t>(from));
    root.push_back(static_cast<std::int32_t>(p.record.number("root")));
    first.push_back(p.seen ? static_cast<std::int32_t>(p.first) : -1);
    last.push_back(p.seen ? static_cast<std::int32_t>(p.last) : -2);
    generation.push_back(static_cast<std::uint8_t>(std::min(255.0, p.record.number("generation"))));
    motion.push_back(static_cast<std::uint8_t>(p.record.number("motion")));
    // Frames of an earlier version know of one material.
    const double of = p.record.has("material") ? p.record.number("material") : 0;
    material.push_back(static_cast<std::uint8_t>(std::min(255.0, of)));
    area.push_back(static_cast<float>(p.record.number("area")));
    append(vertices, p.record["vertices"]);
    start.push_back(static_cast<std::uint32_t>(vertices.size() / 2));
  }
  arrays.add("parent", parent);
  arrays.add("root", root);
  arrays.add("first", first);
  arrays.add("last", last);
  arrays.add("generation", generation);
  arrays.add("motion", motion);
  if (std::ranges::any_of(material, [](std::uint8_t m) { return m > 0; }))
    arrays.add("material", material);
  arrays.add("area", area);
  arrays.add("vertexStart", start);
  arrays.add("vertices", vertices);
}

Json break_json(const RecordedBreak& b) {
  const ReadRecord& r = b.record;
  Json pieces = Json::array();
  for (const double id : r["pieces"])
    pieces.push_back(id == riprap::no_particle ? Json(nullptr) : Json(id));
  return {{"step", r.number("step")},   {"time", r.number("time")},
          {"stage", r.number("stage")}, {"strain", r.number("strain")},
          {"frame", b.frame},           {"id", r.number("id")},
          {"pieces", pieces},           {"areas", r["areas"]},
          {"line", r["line"]},          {"rat", r.number("rat")},
          {"mode", r.number("mode")},   {"pose", r["pose"]}};
}

// What is in the breaks, one behind the other; the entry says where it starts.
Json add_breaks(const RecordedRun& run, Binary& arrays) {
  std::vector<float> nodes, stress, loads;
  std::vector<std::uint16_t> triangles;
  std::vector<std::uint8_t> failed;
  Json breaks = Json::array();
  for (const RecordedBreak& b : run.breaks) {
    const ReadRecord& r = b.record;
    Json j = break_json(b);
    j["nodes"] = {nodes.size(), r["nodes"].size()};
    j["triangles"] = {triangles.size(), r["triangles"].size()};
    j["samples"] = {failed.size(), r["failed"].size()};
    j["loads"] = {loads.size(), 2 * r["points"].size()};
    append(nodes, r["nodes"]);
    append(triangles, r["triangles"]);
    append(failed, r["failed"]);
    for (std::size_t k = 0; k < r["s11"].size(); ++k)
      append(stress, {r["s11"][k], r["s22"][k], r["s12"][k]});
    for (std::size_t k = 0; k + 1 < r["points"].size(); k += 2)
      append(loads, {r["points"][k], r["points"][k + 1], r["forces"][k], r["forces"][k + 1]});
    breaks.push_back(std::move(j));
  }
  arrays.add("nodes", nodes);
  arrays.add("triangles", triangles);
  arrays.add("failed", failed);
  arrays.add("elementStress", stress);
  arrays.add("loads", loads);
  return breaks;
}

}  // namespace

PackedRun pack(const RecordedRun& run) {
  PackedRun packed;
  const Box box = box_of(run);
  Json stages = Json::array();
  for (const auto stage : {riprap::Stage::compaction, riprap::Stage::relaxation,
                           riprap::Stage::hydrostatic, riprap::Stage::shear})
    stages.push_back(riprap::to_text(stage));
  packed.head = {{"riprap", riprap::version},
                 {"pressure", run.head.number("pressure")},
                 {"diameter", run.head.number("diameter")},
                 {"thickness", run.head.number("thickness")},
                 {"ratf", run.head.has("ratf") ? Json(run.head.number("ratf")) : Json(nullptr)},
                 {"box", {box.x, box.y, box.right, box.top}},
                 {"mostTurn", most_turn},
                 {"stages", std::move(stages)}};
  add_particles(run, packed.arrays);
  FramePacker frames(box, run);
  Json list = Json::array();
  for (const ReadRecord& f : run.frames) list.push_back(frames.add(f));
  add_columns(frames.columns(), packed.arrays);
  packed.head["frames"] = std::move(list);
  packed.head["breaks"] = add_breaks(run, packed.arrays);
  packed.head["arrays"] = packed.arrays.index();
  return packed;
}

}  // namespace replay
