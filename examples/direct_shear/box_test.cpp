// SPDX-License-Identifier: BSL-1.0
#include "box_test.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/experiment/wall_servo.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>

namespace direct_shear {

using namespace riprap;

namespace {

constexpr double aspect = 2;              // width over height of the dense sample
constexpr double jam_pressure = 2e5;      // at which compaction ends [Pa]
constexpr double solid_when_dense = 0.8;  // expected share; the halves part at half the height
constexpr double closing_speed = 1;       // of the lid in compaction [m/s]
constexpr unsigned check_interval = 128;  // steps
constexpr unsigned most_checks = 10'000;  // of a stage
constexpr unsigned records_of_shear = 100;

auto model_of(const Options& o) {
  return Model{}.boundary(NoBoundary{}).contact_law(o.contact).criterion(o.criterion);
}

// Loose particles in a box of the size that they need when dense, under a lid that is high enough.
struct LooseBox {
  BoxSize size{};
  Assembly assembly{};
};

LooseBox loose_box(const Options& o, std::uint64_t seed) {
  RandomAssembly random = o.assembly;
  random.seed = seed;
  random.aspect_ratio = aspect * random.solid_fraction / random.dense_fraction;
  const Assembly loose = random_platen_assembly(random);
  // Its platens are replaced: right, left, top and bottom, around the origin.
  const double half_width = loose.particles[0].polygon.begin()->x();
  double half_height = 0;
  for (const Vec2& v : loose.particles[2].polygon)
    half_height = half_height == 0 ? v.y() : std::min(half_height, v.y());
  LooseBox box;
  box.size = {.width = 2 * half_width,
              .height = 2 * half_height,
              .parting = half_width / aspect * random.dense_fraction / solid_when_dense,
              .thickness = 2 * o.shear * half_width + 2 * random.mean_diameter};
  box.assembly = {.thickness = random.thickness,
                  .particles =
                      box_walls(box.size, o.sides == "rough" ? Motion::wall : Motion::platen)};
  for (std::size_t i = 4; i < loose.particles.size(); ++i) {
    const ConvexPolygon polygon = loose.particles[i].polygon.moved({}, {0, half_height});
    // The sample closes as a whole from the first step on.
    const double height = area_properties(polygon.ring()).centroid.y();
    box.assembly.particles.push_back(
        {polygon, Motion::free, Vec2{0, -closing_speed * height / box.size.height}});
  }
  return box;
}

double lid_height(const Particles& particles, const BoxSize& size) {
  return particles.body(lid).position.y() - 0.5 * size.thickness;
}

class BoxTest {
 public:
  BoxTest(const Options& o, double normal_stress, std::uint64_t seed,
          const std::function<void(double)>& progress)
      : options_(o), normal_stress_(normal_stress), seed_(seed), progress_(progress),
        box_(loose_box(o, seed)), sim_(model_of(o), box_.assembly, o.rock),
        servo_(lid, {0, -1}, area() * jam_pressure, 0.5 * aspect * stiffness(), response(),
               closing_speed) {
    result_.size = box_.size;
    result_.thickness = sim_.particles().thickness();
  }

  BoxResult run() {
    compact();
    consolidate();
    shear();
    result_.lost = lost();
    result_.picture = assembly_picture(
        sim_.particles(), {},
        "Shear box at " + shear_tests::stress_text(normal_stress_) + ", moved by " +
            to_text(std::round(1000 * options_.shear) / 10) + " % of its width");
    return std::move(result_);
  }

 private:
  [[nodiscard]] double area() const { return box_.size.width * sim_.particles().thickness(); }
  [[nodiscard]] double stiffness() const { return sim_.contacts().law().peak_stiffness(); }
  // The time that a pressure wave takes through the dense sample [s].
  [[nodiscard]] double response() const {
    const double modulus = 0.5 * stiffness() / sim_.particles().thickness();
    return box_.size.width / aspect * std::sqrt(options_.rock.density / modulus);
  }

  void step() {
    servo_(sim_);
    sim_.step();
  }
  // Steps until `reached()`, which is asked now and then.
  template <class Reached>
  void settle(const char* stage, Reached&& reached) {
    for (unsigned n = 0; n < most_checks; ++n) {
      for (unsigned k = 0; k < check_interval; ++k) step();
      progress_(0);
      if (reached()) return;
    }
    throw SimulationError(std::string(stage) + " did not come to an end");
  }
  [[nodiscard]] bool holds(double pressure, double tolerance) const {
    return std::abs(servo_.pushes_with(sim_) / (area() * pressure) - 1) < tolerance;
  }

  // Without friction, until the sample carries the lid.
  void compact() {
    sim_.set_breakage(false);
    sim_.contact_law() = frictionless(options_.contact);
    settle("compaction", [&] {
      return holds(jam_pressure, 0.1) &&
             state_averages(sim_.contacts(), sim_.particles()).kinetic_ratio() < 0.04;
    });
    sim_.contact_law() = options_.contact;
  }
  // Under the normal stress, until it is at rest.
  void consolidate() {
    sim_.set_breakage(options_.breakage == "on");
    servo_.set_force(area() * normal_stress_);
    settle("consolidation", [&] {
      return holds(normal_stress_, 0.01) &&
             state_averages(sim_.contacts(), sim_.particles()).unbalanced_force < 0.01;
    });
    result_.height = lid_height(sim_.particles(), box_.size);
    result_.solid_fraction = rock_area(sim_.particles()) / (box_.size.width * result_.height);
    result_.breakages_before_shear = sim_.breaks().size();
  }

  void shear() {
    // Local damping acts on velocities in the laboratory: it would brake the half that moves.
    sim_.damping() = options_.damping;
    std::map<ParticleId, Vec2> start;
    const Particles& particles = sim_.particles();
    for (BodyIndex i = walls; i < particles.size(); ++i)
      start[particles.ancestry(i).id] = particles.body(i).position;
    const double way = options_.shear * box_.size.width;
    const double speed = options_.rate(normal_stress_) * result_.height;
    const double begun = sim_.time();
    double moved = 0;
    for (unsigned n = 1; n <= records_of_shear; ++n) {
      BoxForces sum;
      unsigned steps = 0;
      for (; moved < way * n / records_of_shear; ++steps) {
        // From rest in the time of a few waves.
        const double velocity = speed * std::min(1.0, (sim_.time() - begun) / (4 * response()));
        move_lower_half(sim_, velocity);
        moved += velocity * sim_.time_step();
        step();
        sum += forces(sim_);
        if (steps % check_interval == 0) progress_(moved / way);
      }
      record(moved, 1.0 / steps * sum);
    }
    for (BodyIndex i = walls; i < particles.size(); ++i)
      if (const auto it = start.find(particles.ancestry(i).id); it != start.end())
        result_.profile.push_back({it->second.y() / result_.height,
                                   (particles.body(i).position.x() - it->second.x()) / moved});
  }
  void record(double moved, const BoxForces& mean) {
    result_.records.push_back({.normal_stress = normal_stress_,
                               .seed = seed_,
                               .displacement = moved,
                               .lift = lid_height(sim_.particles(), box_.size) - result_.height,
                               .forces = mean,
                               .breakages = sim_.breaks().size() - result_.breakages_before_shear,
                               .particles = sim_.particles().size() - walls});
  }

  // The box reaches as far as both halves do.
  [[nodiscard]] std::size_t lost() const {
    const Particles& particles = sim_.particles();
    const double half = 0.5 * box_.size.width;
    const double moved = particles.body(lower_plate).position.x();
    std::size_t count = 0;
    for (BodyIndex i = walls; i < particles.size(); ++i) {
      const Vec2 x = particles.body(i).position;
      const bool inside = x.x() > -half && x.x() < half + moved && x.y() > 0 &&
                          x.y() < lid_height(particles, box_.size);
      count += inside ? 0 : 1;
    }
    return count;
  }

  const Options& options_;
  double normal_stress_;
  std::uint64_t seed_;
  const std::function<void(double)>& progress_;
  LooseBox box_;
  Simulation<decltype(model_of(std::declval<const Options&>()))> sim_;
  WallServo servo_;
  BoxResult result_;
};

}  // namespace

BoxResult box_test(const Options& options, double normal_stress, std::uint64_t seed,
                   const std::function<void(double)>& progress) {
  return BoxTest(options, normal_stress, seed, progress).run();
}

}  // namespace direct_shear
