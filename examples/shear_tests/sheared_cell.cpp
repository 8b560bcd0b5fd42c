// SPDX-License-Identifier: BSL-1.0
#include "sheared_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <riprap/experiment/preparation.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/riprap.hpp>

#include "broken_mass.hpp"

namespace shear_tests {

using namespace riprap;

namespace {

constexpr unsigned records_of_shear = 100;
constexpr unsigned sampled_steps = 16;  // stress and velocities are measured every so many steps
constexpr std::size_t bins = 20;        // of the velocity profile

auto model_of(const Options& o) {
  return Model{}.boundary(PeriodicCell{}).contact_law(o.contact).criterion(o.criterion);
}
Assembly sample_of(const Options& o, std::uint64_t seed) {
  RandomAssembly random = o.assembly;
  random.seed = seed;
  return random_periodic_assembly(random);
}

// The sum of sigma_12 - sigma_21 over contacts, times area and thickness [N m].
double moment_sum(const auto& contacts) {
  double sum = 0;
  contacts.for_each_touching([&](const auto& c) { sum += cross(c.force_on_b(), c.branch()); });
  return sum;
}

// Velocities along axis 1 at equal intervals of height, over the time of the test.
class VelocityProfile {
 public:
  void add(const Particles& particles, const PeriodicDomain& domain) {
    for (const Body& body : particles.bodies()) {
      // Of the copy that lies in the cell.
      const PeriodicDomain::Image image = -domain.cell_of(body.position);
      const double height =
          (body.position + domain.offset(image) - domain.centre).y() / domain.period.y();
      const auto k = static_cast<std::size_t>(
          std::clamp((height + 0.5) * bins, 0.0, static_cast<double>(bins - 1)));
      mass_[k] += body.mass;
      momentum_[k] += body.mass * (body.velocity + domain.velocity(image)).x() /
                      (domain.shear_rate * domain.period.y());
    }
  }
  [[nodiscard]] std::vector<Vec2> points() const {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < bins; ++k)
      if (mass_[k] > 0)
        points.push_back({(static_cast<double>(k) + 0.5) / bins - 0.5, momentum_[k] / mass_[k]});
    return points;
  }

 private:
  std::array<double, bins> mass_{};
  std::array<double, bins> momentum_{};
};

// Sums over the steps that are sampled in an interval.
struct Sums {
  Stress2 stress;
  double asymmetry = 0;  // [Pa]
  double count = 0;

  void add(const auto& sim) {
    const double area = sim.boundary().region(sim.particles()).area();
    stress += average_stress(sim.interactions(), area, sim.particles().thickness());
    asymmetry += moment_sum(sim.contacts()) / (area * sim.particles().thickness());
    ++count;
  }
};

// All particles where their copies in the cell are: positions are never wrapped.
Particles in_cell(Particles particles, const PeriodicDomain& domain) {
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    Vec2& position = particles.body(i).position;
    position += domain.offset(-domain.cell_of(position));
    particles.update_ring(i);
  }
  return particles;
}

LoadingPath<> shear_path(const Options& o, const CellTest& test, std::uint64_t steps) {
  LoadingStage<> stage{.name = "shear", .end = StepsMade{.steps = steps}};
  if (!test.constant_volume)
    stage.axis_2 =
        ControlledStress{.stress = test.normal_stress,
                         .control = {.expected_rate = {.inertial_number = test.inertial_number}}};
  stage.breakage = o.breakage == "on";
  stage.records = false;
  stage.most_steps = steps + 1;
  return {.confining_pressure = test.normal_stress, .stages = {stage}};
}

template <class Sim>
void set_shear_rate(Sim& sim, double rate) {
  sim.boundary().set_shear_rate(rate);
  // Particles move with the cell from the first step on.
  const PeriodicDomain& domain = sim.boundary().domain();
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const Body& body = sim.particles().body(i);
    const Vec2 field{rate * (body.position - domain.centre).y(), 0};
    sim.set_velocity(i, body.velocity + field, body.angular_velocity);
  }
}

}  // namespace

CellResult sheared_cell(const Options& o, const CellTest& test,
                        const std::function<void(double)>& progress) {
  Simulation sim{model_of(o), sample_of(o, test.seed), o.rock};
  sim.set_breakage(o.breakage == "on");
  LoadingPath<> preparation{.confining_pressure = test.normal_stress,
                            .stages = Preparation{}.stages(test.normal_stress)};
  auto preparing = preparation.start(sim);
  while (preparing.advance())
    if (preparing.view().at_check) progress(0);

  Options at_this_rate = o;
  at_this_rate.inertial_number = test.inertial_number;
  CellResult result{.test = test, .rate = at_this_rate.rate(test.normal_stress)};
  const PeriodicDomain& domain = sim.boundary().domain();
  const double volume_at_start = domain.period.prod() * sim.particles().thickness();
  result.solid_fraction = rock_area(sim.particles()) / domain.period.prod();
  const double mass = rock_area(sim.particles()) * sim.particles().thickness() * o.rock.density;
  result.breakages_before_shear = sim.breaks().size();
  set_shear_rate(sim, result.rate);
  sim.damping() = o.damping;

  const auto per_record = std::max<std::uint64_t>(
      sampled_steps, static_cast<std::uint64_t>(std::llround(
                         o.shear / (result.rate * sim.time_step() * records_of_shear))));
  auto run = shear_path(o, test, per_record * records_of_shear).start(sim);
  VelocityProfile profile;
  Sums sums;
  double height = domain.period.y();
  const double height_at_start = height;
  const double work_at_start = sim.work().boundary;
  double stress_work = 0;
  for (std::uint64_t n = 1; n <= per_record * records_of_shear; ++n) {
    run.advance();
    if (n % sampled_steps == 0) {
      sums.add(sim);
      profile.add(sim.particles(), domain);
      progress(static_cast<double>(n) / static_cast<double>(per_record * records_of_shear));
    }
    if (n % per_record != 0) continue;
    const Stress2 mean = 1 / sums.count * sums.stress;
    const double strain = result.rate * sim.time_step() * static_cast<double>(per_record);
    const double shortening = std::log(height / domain.period.y());
    const double volume = volume_at_start * 0.5 * (height + domain.period.y()) / height_at_start;
    stress_work += volume * (-mean.s12 * strain + mean.s22 * shortening);
    const BrokenMass broken = broken_mass(sim.particles());
    result.records.push_back({.strain = strain * static_cast<double>(n / per_record),
                              .stress = mean,
                              .asymmetry = sums.asymmetry / sums.count / mean.s12,
                              .contraction = shortening / strain,
                              .rise = domain.period.y() / height_at_start - 1,
                              .work = (sim.work().boundary - work_at_start) / mass,
                              .stress_work = stress_work / mass,
                              .breakages = sim.breaks().size() - result.breakages_before_shear,
                              .particles = sim.particles().size(),
                              .broken = broken.broken,
                              .detached = broken.detached});
    height = domain.period.y();
    sums = {};
  }
  result.profile = profile.points();
  result.picture =
      assembly_picture(in_cell(sim.particles(), domain), {},
                       "Sheared cell at " + stress_text(test.normal_stress) +
                           " after a shear strain of " + to_text(std::round(100 * o.shear) / 100));
  return result;
}

}  // namespace shear_tests
