// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/validity_check.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/archetypes.hpp>
#include <support/near.hpp>
#include <vector>

using namespace riprap;
using test::near_relative;

namespace {

// Small enough for a test: 120 particles, of which about a third are the boundary.
Assembly small_assembly() { return random_assembly({.count = 120, .seed = 3}); }

constexpr BiaxialTest small_test{.confining_pressure = 8e6, .axial_strain = 0.02};

// What the view says at the hooks, checked against independent measurements.
struct Witness {
  std::vector<Stage> begun;
  std::vector<Stage> ended;
  std::vector<double> recorded;
  double friction_in_compaction = -1;
  double friction_in_relaxation = -1;
  double area_error = 0;
  double hydrostatic_error = 1;
  double hydrostatic_unbalanced = 1;
  double rest_unbalanced = 1;
  double share_before = 0;
  bool share_fell = false;

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    begun.push_back(view.stage);
    share_before = 0;
    if (view.stage == Stage::relaxation)
      friction_in_relaxation = view.sim.contacts().law().friction;
  }
  template <class Sim>
  void progress(const BiaxialView<Sim>& view) {
    if (view.stage == Stage::compaction)
      friction_in_compaction = view.sim.contacts().law().friction;
    share_fell |= view.done < share_before || view.done > 1;
    share_before = view.done;
  }
  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    recorded.push_back(view.axial_strain());
    area_error =
        std::max(area_error,
                 std::abs(view.area / view.sim.boundary().region(view.sim.particles()).area() - 1));
  }
  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    ended.push_back(view.stage);
    const auto state = state_averages(view.sim.contacts(), view.sim.particles());
    if (view.stage == Stage::relaxation) rest_unbalanced = state.unbalanced_force;
    if (view.stage != Stage::hydrostatic) return;
    const Stress2 s =
        average_stress(view.sim.contacts(), view.area, view.sim.particles().thickness());
    hydrostatic_error = std::max(std::abs(s.s11 / 8e6 - 1), std::abs(s.s22 / 8e6 - 1));
    hydrostatic_unbalanced = state.unbalanced_force;
  }
};

// Sums stress times volume times strain over the records, by the trapezoid rule.
struct StressWork {
  double sum = 0;
  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    const Stress2 s =
        average_stress(view.sim.contacts(), view.area, view.sim.particles().thickness());
    const Vec2 strain = view.stretch.array().log();
    const double volume = view.area * view.sim.particles().thickness();
    if (have_last)
      sum -= 0.5 * (volume * s.s11 + last_11) * (strain.x() - last_strain.x()) +
             0.5 * (volume * s.s22 + last_22) * (strain.y() - last_strain.y());
    last_11 = volume * s.s11;
    last_22 = volume * s.s22;
    last_strain = strain;
    have_last = true;
  }
  double last_11 = 0;
  double last_22 = 0;
  Vec2 last_strain{0, 0};
  bool have_last = false;
};

template <class ModelType>
std::string curve_of(ModelType model, const BiaxialTest& test) {
  Simulation sim{model, small_assembly(), Rock{}};
  Curve curve;
  test.run(sim, curve);
  return curve_csv(curve);
}

}  // namespace

TEST_CASE("a biaxial test goes through its stages, and each ends within its tolerance") {
  Simulation sim{Model{}, small_assembly(), Rock{}};
  Curve curve;
  Witness witness;
  const BiaxialResult result = small_test.run(sim, curve, witness);

  const std::vector<Stage> all{Stage::compaction, Stage::relaxation, Stage::hydrostatic,
                               Stage::shear};
  CHECK(witness.begun == all);
  CHECK(witness.ended == all);
  CHECK_FALSE(witness.share_fell);
  for (const Stage stage : all) {
    CHECK(result.stage(stage).reached_target);
    CHECK(result.stage(stage).steps > 0);
  }

  // Friction is off while the sample compacts and back afterwards.
  CHECK(witness.friction_in_compaction == 0);
  CHECK(witness.friction_in_relaxation == 0.5);

  // Each stage ends within its tolerance.
  CHECK(witness.rest_unbalanced < small_test.rest_unbalanced_force);
  CHECK(witness.hydrostatic_error <= small_test.hydrostatic_tolerance);
  CHECK(witness.hydrostatic_unbalanced < small_test.hydrostatic_unbalanced_force);

  // A record at the start, one every 0.25 %, the last at the end; a step is far below 1e-5 of
  // strain.
  REQUIRE(witness.recorded.size() == 9);
  for (std::size_t k = 0; k < witness.recorded.size(); ++k) {
    CHECK(witness.recorded[k] >= 0.0025 * static_cast<double>(k));
    CHECK(witness.recorded[k] < 0.0025 * static_cast<double>(k) + 1e-5);
  }

  // Area by the stretches and by the boundary polygon: round-off over some ten thousand steps.
  CHECK(witness.area_error < 1e-10);

  // The rate is the one that the inertial number asks for.
  const double d = std::sqrt(4 * sim.mean_area() / std::numbers::pi);
  CHECK(inertial_number(result.axial_rate, d, 2500, 8e6) == near_relative(1e-3, 1e-12));
  CHECK(std::abs(result.mean_confinement_error) < 0.02);
  CHECK(result.rms_confinement_error < 0.08);

  const CurvePoint& end = curve.points().back();
  CHECK(end.lost_particles == 0);
  // The ledger's own errors are those of the trapezoid rule at the two ends of the sum.
  CHECK(std::abs(end.energy_error()) < 2e-3);
  CHECK(end.energy.boundary_work > 0);
  CHECK(end.stress.s22 > 1.5 * end.stress.s11);
}

TEST_CASE_TEMPLATE("every boundary carries the whole test", BoundaryT, RigidPlatens, PeriodicCell) {
  const RandomAssembly options{.count = 120, .seed = 3};
  const Assembly assembly = std::is_same_v<BoundaryT, RigidPlatens>
                                ? random_platen_assembly(options)
                                : random_periodic_assembly(options);
  Simulation sim{Model{}.boundary(BoundaryT{}), assembly, Rock{}};
  Curve curve;
  Witness witness;
  const BiaxialResult result = small_test.run(sim, curve, witness);
  for (const Stage stage : witness.ended) CHECK(result.stage(stage).reached_target);
  CHECK(witness.area_error < 1e-10);
  CHECK(witness.hydrostatic_error <= small_test.hydrostatic_tolerance);
  CHECK(std::abs(result.mean_confinement_error) < 0.02);
  CHECK(result.rms_confinement_error < 0.08);
  const CurvePoint& end = curve.points().back();
  CHECK(end.lost_particles == 0);
  CHECK(std::abs(end.energy_error()) < 2e-3);
  CHECK(end.stress.s22 > 1.5 * end.stress.s11);
  CHECK(end.breakages > 0);
}

TEST_CASE("the work of the boundary is stress times strain") {
  // W = integral of V sigma : d(strain), but for what damping and inertia take on the affine motion
  // of the particles: a few per cent of the whole.
  Simulation sim{Model{}.criterion(NeverFails{}), small_assembly(), Rock{}};
  Curve curve;
  StressWork work;
  BiaxialTest test = small_test;
  test.record_every = 1e-4;
  test.run(sim, curve, work);
  CHECK(curve.points().back().energy.boundary_work == near_relative(work.sum, 0.05));
}

TEST_CASE("a biaxial test needs of its boundary what SampleBoundary states and no more") {
  BiaxialTest test = small_test;
  test.axial_strain = 0.005;
  CHECK(curve_of(Model{}.boundary(riprap::test::archetype::SampleBoundary{0}), test) ==
        curve_of(Model{}, test));
}

TEST_CASE("two runs give the same curve, to the last byte") {
  CHECK(curve_of(Model{}, small_test) == curve_of(Model{}, small_test));
}

TEST_CASE("a trigger out of reach gives the curve of particles that cannot fail, byte for byte") {
  CHECK(curve_of(Model{}.trigger(FailedElementRatio{1.1}), small_test) ==
        curve_of(Model{}.criterion(NeverFails{}), small_test));
}

TEST_CASE("units of length, mass and time scale the whole test") {
  // Lengths times 2, times as they are, masses times 4 (density times 1/2, stiffness times 4):
  // powers of two are exact in binary, so nothing but the exponents changes. Stress is
  // mass / (length time^2): times 2.
  const auto run = [](double length, double mass) {
    RandomAssembly options{.count = 60, .mean_diameter = 0.016 * length, .seed = 2};
    options.thickness = 0.016 * length;
    const double stress = mass / length;
    Simulation sim{
        Model{}
            .contact_law(LinearSpringCoulomb{.normal_stiffness = 2e7 * mass,
                                             .tangential_stiffness = 2e7 * mass})
            .criterion(HoekBrown{.compressive_strength = 300e6 * stress}),
        random_assembly(options),
        Rock{.young = 70e9 * stress, .density = 2500 * mass / (length * length * length)}};
    Curve curve;
    BiaxialTest{
        .confining_pressure = 8e6 * stress, .axial_strain = 0.01, .jam_pressure = 2e5 * stress}
        .run(sim, curve);
    return curve.points().back();
  };
  const CurvePoint one = run(1, 1);
  const CurvePoint other = run(2, 4);
  CHECK(other.sin_phi() == one.sin_phi());
  CHECK(other.stress.s22 == 2 * one.stress.s22);
  CHECK(other.porosity == one.porosity);
  CHECK(other.coordination.coordination_number == one.coordination.coordination_number);
}

TEST_CASE("bad parameters are named, and so is a missing boundary") {
  Simulation sim{Model{}, small_assembly(), Rock{}};
  CHECK_THROWS_WITH_AS((BiaxialTest{.confining_pressure = -1}.run(sim)),
                       "BiaxialTest.confining_pressure = -1: must be a finite number above 0",
                       InvalidInput);
  CHECK_THROWS_WITH_AS((BiaxialTest{.axial_strain = 1}.run(sim)),
                       "BiaxialTest.axial_strain = 1: must lie in [0, 0.9)", InvalidInput);
  Assembly loose{.thickness = 0.016, .particles = {}};
  loose.particles.push_back({ConvexPolygon{{0.0, 0.0}, {0.01, 0.0}, {0.0, 0.01}}});
  Simulation free{Model{}, loose, Rock{}};
  CHECK_THROWS_WITH_AS(small_test.run(free),
                       "a sample needs at least 3 boundary particles of Motion::strain_field; the "
                       "assembly has 0",
                       InvalidInput);
}

TEST_CASE("a sample that does not jam is an error, not an endless run") {
  Simulation sim{Model{}, small_assembly(), Rock{}};
  BiaxialTest test = small_test;
  test.most_steps = 1000;
  CHECK_THROWS_AS(test.run(sim), SimulationError);
}

namespace {

// Asks for a stop at a step of a stage, counted from its begin.
struct StopAt {
  Stage stage;
  int step;
  int steps_of_stage = 0;
  int steps_after_stop = 0;
  std::vector<Stage> begun{};
  std::vector<Stage> ended{};
  bool interrupted_at_end = false;

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    begun.push_back(view.stage);
    steps_of_stage = 0;
  }
  template <class Sim>
  void after_step(const Sim& /*sim*/) {
    ++steps_of_stage;
  }
  template <class Sim>
  bool stop_requested(const BiaxialView<Sim>& view) {
    if (view.interrupted) ++steps_after_stop;
    return view.stage == stage && steps_of_stage >= step;
  }
  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    ended.push_back(view.stage);
    interrupted_at_end = view.interrupted && !view.reached_target;
  }
};

struct StopAtEnd {
  template <class Sim>
  bool stop_requested(const BiaxialView<Sim>& view) const {
    return view.stage == Stage::shear && view.axial_strain() >= 0.001;
  }
};

}  // namespace

TEST_CASE("a stop that an observer requests ends the test at the end of the step") {
  for (const Stage stage :
       {Stage::compaction, Stage::relaxation, Stage::hydrostatic, Stage::shear}) {
    CAPTURE(to_text(stage));
    Simulation sim{Model{}, small_assembly(), Rock{}};
    StopAt stop{.stage = stage, .step = 77};
    Curve curve;
    ValidityCheck check;
    const BiaxialResult result = small_test.run(sim, curve, stop, check);
    CHECK(result.interrupted);
    CHECK(stop.steps_of_stage == 77);
    CHECK(stop.steps_after_stop == 0);
    CHECK(stop.begun.back() == stage);
    CHECK(stop.ended == stop.begun);
    CHECK(stop.interrupted_at_end);
    CHECK(sim.breakage());
    // The stages before have their results, the later ones have none.
    for (const Stage s : {Stage::compaction, Stage::relaxation, Stage::hydrostatic, Stage::shear}) {
      CHECK(result.stage(s).reached_target == (s < stage));
      CHECK((result.stage(s).steps > 0) == (s <= stage));
    }
    CHECK(result.stage(stage).steps == 77);
    // In shear the first state and that of the stop are recorded.
    REQUIRE(curve.points().size() == (stage == Stage::shear ? 2 : 0));
    if (stage == Stage::shear) CHECK(curve.points().back().axial_strain > 0);
    for (const std::string& warning : check.warnings())
      CHECK(warning.find("cap of steps") == std::string::npos);
  }
}

TEST_CASE("a stop with the last step finds the test finished") {
  Simulation sim{Model{}, small_assembly(), Rock{}};
  const BiaxialResult result =
      BiaxialTest{.confining_pressure = 8e6, .axial_strain = 0.001}.run(sim, StopAtEnd{});
  CHECK(!result.interrupted);
  CHECK(result.stage(Stage::shear).reached_target);
}

TEST_CASE("an observer that requests no stop changes nothing, byte for byte") {
  const auto curve_with = [](auto&&... observers) {
    Simulation sim{Model{}, small_assembly(), Rock{}};
    Curve curve;
    CHECK(!BiaxialTest{.confining_pressure = 8e6, .axial_strain = 0.005}
               .run(sim, curve, observers...)
               .interrupted);
    return curve_csv(curve);
  };
  CHECK(curve_with() == curve_with(StopAt{.stage = Stage::shear, .step = 1'000'000'000}));
}

TEST_CASE("a strength in the wrong unit is reported before the first step") {
  const auto warnings = [](double strength) {
    const Simulation sim{Model{}.criterion(HoekBrown{.compressive_strength = strength}),
                         random_assembly({.count = 30}), Rock{}};
    const BiaxialView<std::remove_cv_t<decltype(sim)>> view{
        .sim = sim, .confining_pressure = 8e6, .mean_diameter = 0.016};
    ValidityCheck check;
    check.begin_stage(view);
    return check.warnings();
  };
  CHECK(warnings(300e6).empty());
  REQUIRE(warnings(300).size() == 1);
  CHECK(warnings(300)[0].ends_with(": is the strength in Pa?"));
}

TEST_CASE("a ratio of failed elements above 1 is reported: nothing can break") {
  const Simulation sim{Model{}.trigger(FailedElementRatio{.critical = 1.5}),
                       random_assembly({.count = 30}), Rock{}};
  const BiaxialView<std::remove_cv_t<decltype(sim)>> view{
      .sim = sim, .confining_pressure = 8e6, .mean_diameter = 0.016};
  ValidityCheck check;
  check.begin_stage(view);
  REQUIRE(check.warnings().size() == 1);
  CHECK(check.warnings()[0].ends_with("= 1.5 above 1 at strain 0 of compaction: no particle can "
                                      "break"));
}

TEST_CASE("a servo that does not hold the lateral stress has missed the target of shear") {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 40, .seed = 2}),
                 Rock{}};
  ValidityCheck check({.confinement_error = 1e-9});
  const BiaxialResult result =
      BiaxialTest{.confining_pressure = 4e6, .axial_strain = 0.005, .confinement_tolerance = 1e-9}
          .run(sim, check);
  CHECK(result.stage(Stage::hydrostatic).reached_target);
  CHECK_FALSE(result.stage(Stage::shear).reached_target);
  const auto& rows = check.table().rows();
  for (const char* name : {"mean error of the lateral stress", "missed targets of stages"}) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const CheckedNumber& n) { return n.name == name; });
    REQUIRE(row != rows.end());
    CHECK_FALSE(row->holds());
  }
}

TEST_CASE("a test whose particles are thrown out ends with an error, and the records stay") {
  // A law that drives particles in contact apart.
  struct Explosion : LinearSpringCoulomb {
    ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                            History& history) const {
      ContactForce force = LinearSpringCoulomb::operator()(geometry, motion, history);
      force.normal *= 300;
      return force;
    }
  };
  Simulation sim{Model{}.criterion(NeverFails{}).contact_law(Explosion{}),
                 random_assembly({.count = 40, .seed = 2}), Rock{}};
  CHECK_THROWS_AS(BiaxialTest{}.run(sim), SimulationError);
}
