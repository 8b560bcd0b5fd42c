// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <riprap/breakage/criterion/criterion_of_rock.hpp>
#include <riprap/checkpoint/checkpoint_folder.hpp>
#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/contact_law/incremental_spring.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <riprap/contact/mixing_rule/friction_of_pairs.hpp>
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>
#include <riprap/contact/narrow_phase/narrow_phase_choice.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/dynamics/integrator/integrator_choice.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/message_of.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

// Weak rock, so that particles break soon after they touch.
[[nodiscard]] auto weak_model() {
  return Model{}.criterion(HoekBrown{.compressive_strength = 3e6});
}

using AnyLaw = ContactLawChoice<EnergyConservingSpring, LinearSpringCoulomb, OverlapAreaSpring,
                                IncrementalSpring, SpringDashpot>;

using AnyNarrow = NarrowPhaseChoice<OverlapMoments, OverlapChord>;
using AnyIntegrator = IntegratorChoice<SymplecticEuler, VelocityVerlet>;

[[nodiscard]] auto model_of(const AnyLaw& law, const AnyNarrow& narrow,
                            const AnyIntegrator& integrator) {
  return weak_model().narrow_phase(narrow).contact_law(law).integrator(integrator);
}

[[nodiscard]] Assembly sample_for(const StrainField&, unsigned seed) {
  return random_assembly({.count = 40, .seed = seed});
}
[[nodiscard]] Assembly sample_for(const RigidPlatens&, unsigned seed) {
  return random_platen_assembly({.count = 40, .seed = seed});
}
[[nodiscard]] Assembly sample_for(const PeriodicCell&, unsigned seed) {
  return random_periodic_assembly({.count = 40, .seed = seed});
}

// A sample that is compressed along axis 2, faster and faster: the loop of a user with a state of
// its own.
template <class ModelType>
struct Compression {
  static constexpr double acceleration = 3000;  // of the rate [1/s^2]
  double rate = 5;                              // [1/s]
  EnergyLedger ledger{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("rate", self.rate);
    visit("ledger", self.ledger);
  }

  void step(Simulation<ModelType>& sim) {
    rate += acceleration * sim.time_step();
    sim.boundary().set_rate(0.3 * rate, rate);
    sim.step(ledger);
  }
};

template <class ModelType>
[[nodiscard]] Simulation<ModelType> simulation_of(const ModelType& model, unsigned seed) {
  return Simulation<ModelType>{model, sample_for(model.motion_model.boundary, seed), Rock{}};
}

template <class ModelType>
[[nodiscard]] std::uint64_t state_of(const Simulation<ModelType>& sim,
                                     const Compression<ModelType>& experiment) {
  return digest(internal::checkpoint_fields(sim, experiment));
}

// Steps at which runs are stopped: around a break, and where contacts slip.
struct Stops {
  std::vector<std::uint64_t> steps{};
  std::uint64_t last = 0;
  std::uint64_t state = 0;
};

template <class ModelType>
[[nodiscard]] Stops stops_of(const ModelType& model) {
  constexpr std::size_t breaks = 6;
  constexpr std::uint64_t most_steps = 200'000;
  auto sim = simulation_of(model, 1);
  Compression<ModelType> experiment;
  experiment.ledger.open(sim);
  Stops stops;
  while (sim.breaks().size() < breaks && sim.steps() < most_steps) {
    const double slip = sim.contacts().friction_loss();
    experiment.step(sim);
    if (stops.steps.empty() && slip > 0 && sim.contacts().friction_loss() > slip)
      stops.steps.push_back(sim.steps());
  }
  REQUIRE(sim.breaks().size() >= breaks);
  REQUIRE(!stops.steps.empty());  // a step in mid-slip
  const std::uint64_t third = sim.breaks()[2].step;
  for (const std::uint64_t step : {third - 1, third, third + 1}) stops.steps.push_back(step);
  for (int k = 0; k < 100; ++k) experiment.step(sim);
  stops.last = sim.steps();
  stops.state = state_of(sim, experiment);
  return stops;
}

// 2 N steps = N steps, restart, N steps, to the last byte of the state.
template <class ModelType>
void check_restarts(const ModelType& model) {
  const Stops stops = stops_of(model);
  const test::TemporaryFile file;
  for (const std::uint64_t stop : stops.steps) {
    CAPTURE(stop);
    auto first = simulation_of(model, 1);
    Compression<ModelType> experiment;
    experiment.ledger.open(first);
    while (first.steps() < stop) experiment.step(first);
    write_checkpoint(file.path(), first, experiment);

    auto second = simulation_of(model, 2);  // nothing of it stays
    Compression<ModelType> other;
    for (int k = 0; k < 10; ++k) other.step(second);
    read_checkpoint(file.path(), second, other);
    CHECK(state_of(second, other) == state_of(first, experiment));
    while (second.steps() < stops.last) other.step(second);
    CHECK(state_of(second, other) == stops.state);
  }
}

// An observer that appends to a file.
struct Log {
  std::string path{};
  [[nodiscard]] std::string appended_file() const { return path; }
  static void for_each_field(auto& /*self*/, auto&& /*visit*/) {}
  static constexpr bool names_all_members = false;
};

}  // namespace

TEST_CASE("A restarted run gives the same bytes, with each contact law and integrator") {
  for (const AnyLaw& law :
       {AnyLaw{EnergyConservingSpring{}}, AnyLaw{LinearSpringCoulomb{}},
        AnyLaw{OverlapAreaSpring{}}, AnyLaw{IncrementalSpring{}}, AnyLaw{SpringDashpot{}}})
    check_restarts(model_of(law, AnyNarrow{OverlapChord{}}, AnyIntegrator{SymplecticEuler{}}));
  for (const AnyLaw& law : {AnyLaw{EnergyConservingSpring{}}, AnyLaw{SpringDashpot{}}})
    check_restarts(model_of(law, AnyNarrow{OverlapMoments{}}, AnyIntegrator{VelocityVerlet{}}));
}

TEST_CASE("A restarted run gives the same bytes, with each boundary") {
  for (const AnyLaw& law : {AnyLaw{EnergyConservingSpring{}}, AnyLaw{SpringDashpot{}}}) {
    const auto model = model_of(law, AnyNarrow{OverlapMoments{}}, AnyIntegrator{VelocityVerlet{}});
    check_restarts(model.boundary(RigidPlatens{}));
    check_restarts(model.boundary(PeriodicCell{}));
  }
}

TEST_CASE("A restarted run gives the same bytes, with bodies of several tasks") {
  const auto model = weak_model().boundary(PeriodicCell{});
  const Assembly sample = random_periodic_assembly({.count = 600, .seed = 1});
  const auto simulation = [&] { return Simulation{model, sample, Rock{}}; };
  using Experiment = Compression<std::remove_const_t<decltype(model)>>;
  auto sim = simulation();
  Experiment experiment;
  experiment.ledger.open(sim);
  while (sim.breaks().size() < 2) experiment.step(sim);
  REQUIRE(task_count(sim.particles().size()) >= 3);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim, experiment);
  auto other = simulation();
  Experiment goes_on;
  read_checkpoint(file.path(), other, goes_on);
  while (sim.breaks().size() < 5) {
    experiment.step(sim);
    goes_on.step(other);
  }
  CHECK(sim.contacts().friction_loss() > 0);
  CHECK(state_of(other, goes_on) == state_of(sim, experiment));
}

TEST_CASE("Acceleration may be another one after the restart") {
  const auto model = weak_model();
  const auto plain = model.without_acceleration();
  auto sim = simulation_of(model, 1);
  sim.boundary().set_rate(10, 30);
  for (int k = 0; k < 3000; ++k) sim.step();
  const test::TemporaryFile file;
  const BiaxialTest test{.confining_pressure = 14e6};
  auto run = test.start(sim);
  write_checkpoint(file.path(), sim, run, Compression<std::remove_const_t<decltype(model)>>{3});
  auto other = simulation_of(plain, 2);
  auto other_run = test.start(other);
  Compression<decltype(model.without_acceleration())> experiment;
  read_checkpoint(file.path(), other, other_run, experiment);
  CHECK(experiment.rate == 3);
  for (int k = 0; k < 500; ++k) {
    sim.step();
    other.step();
  }
  CHECK(digest(internal::checkpoint_fields(sim)) == digest(internal::checkpoint_fields(other)));
}

TEST_CASE("The same state gives the same file") {
  auto sim = simulation_of(weak_model(), 1);
  for (int k = 0; k < 100; ++k) sim.step();
  const test::TemporaryFile one;
  const test::TemporaryFile two;
  write_checkpoint(one.path(), sim);
  write_checkpoint(two.path(), sim);
  CHECK(one.text().size() > 10'000);
  CHECK(one.text() == two.text());
}

TEST_CASE("What an experiment has changed in the policies is part of the state") {
  const auto model = weak_model();
  auto sim = simulation_of(model, 1);
  sim.contact_law().friction = 0.1;
  sim.damping().coefficient = 0.2;
  sim.set_body_force({0, -9.81});
  sim.set_time_step(1e-7);
  sim.set_breakage(false);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim);
  auto other = simulation_of(model, 2);
  read_checkpoint(file.path(), other);
  CHECK(other.contact_law().friction == 0.1);
  CHECK(other.damping().coefficient == 0.2);
  CHECK(other.body_force().acceleration == Vec2{0, -9.81});
  CHECK(other.time_step() == 1e-7);
  CHECK_FALSE(other.breakage());
}

TEST_CASE("A run of two rocks goes on to the same bytes, mixed laws and criteria included") {
  const EnergyConservingSpring law;
  const auto model =
      weak_model()
          .criterion(CriterionOfRock{
              {HoekBrown{.compressive_strength = 3e6}, HoekBrown{.compressive_strength = 6e6}}})
          .contact_law(MixedContactLaw{{law, EnergyConservingSpring{.friction = 0.2}},
                                       FrictionOfPairs<>{.table = {{0, 1, 0.4}}}});
  const Rocks rocks{Rock{}, Rock{.density = 2200}};
  const auto simulation = [&](unsigned seed) {
    Assembly assembly = sample_for(StrainField{}, seed);
    for (std::size_t i = 0; i < assembly.particles.size(); i += 2)
      assembly.particles[i].material = 1;
    return Simulation{model, assembly, rocks};
  };
  auto sim = simulation(1);
  Compression<std::remove_const_t<decltype(model)>> experiment;
  experiment.ledger.open(sim);
  const test::TemporaryFile file;
  while (sim.breaks().size() < 2) experiment.step(sim);
  sim.contact_law() = frictionless(sim.contact_law());
  write_checkpoint(file.path(), sim, experiment);
  const auto five_breaks = [&](auto& of, auto& by) {
    while (of.breaks().size() < 5) by.step(of);
    return state_of(of, by);
  };
  const std::uint64_t state = five_breaks(sim, experiment);
  auto other = simulation(2);
  Compression<std::remove_const_t<decltype(model)>> goes_on;
  read_checkpoint(file.path(), other, goes_on);
  CHECK(five_breaks(other, goes_on) == state);
  std::size_t of_one = 0;
  for (BodyIndex i = 0; i < other.particles().size(); ++i) of_one += other.particles().material(i);
  CHECK(of_one > 0);
  CHECK(of_one < other.particles().size());
}

TEST_CASE(
    "A checkpoint of another model, rock or experiment is refused with the first difference") {
  auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  EnergyLedger ledger;
  write_checkpoint(file.path(), sim, ledger);
  const auto message = [&](auto&& other, auto&... parts) {
    const std::uint64_t before = digest(internal::checkpoint_fields(other));
    std::string text = test::message_of([&] { read_checkpoint(file.path(), other, parts...); });
    CHECK(digest(internal::checkpoint_fields(other)) == before);
    return text.substr(text.find(" is of another model: ") == text.npos
                           ? file.path().size()
                           : text.find(" is of another model: "));
  };
  CHECK(message(simulation_of(weak_model().damping(LocalDamping{0.5}), 1), ledger) ==
        " is of another model: checkpoint/model/policies/motion/damping/coefficient is 0.7 in the "
        "file and 0.5 in the program");
  CHECK(
      message(simulation_of(Model{}, 1), ledger) ==
      " is of another model: checkpoint/model/policies/breakage/criterion/compressive_strength is "
      "3e+06 in the file and 3e+08 in the program");
  CHECK(test::contains(message(simulation_of(weak_model().integrator(VelocityVerlet{}), 1), ledger),
                       "SymplecticEuler in the file and "));
  CHECK(test::contains(
      message(Simulation{weak_model(), sample_for(StrainField{}, 1), Rock{.young = 1e9}}, ledger),
      "checkpoint/model/rock/young is 7e+10 in the file and 1e+09 in the program"));
  CHECK(test::contains(
      message(Simulation{weak_model(), sample_for(StrainField{}, 1), Rocks{Rock{}, Rock{}}},
              ledger),
      "checkpoint/model is of 2 fields in the file and of 3 in the program"));
  CHECK(message(simulation_of(weak_model(), 1)) ==
        " holds 1 experiments and observers, the program has 0");
  Compression<decltype(weak_model())> other_experiment;
  CHECK(test::contains(message(simulation_of(weak_model(), 1), other_experiment),
                       "EnergyLedger in the file and "));
}

namespace {

// An observer as it was when a checkpoint was written, and after a change of the program.
enum class Layout { whole, more, fewer, other_type };
Layout layout = Layout::whole;
struct Changing {
  double first = 1;
  double second = 2;
  int whole = 3;
  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("first", self.first);
    if (layout == Layout::other_type) visit("second", self.whole);
    if (layout == Layout::whole || layout == Layout::more) visit("second", self.second);
    if (layout == Layout::more) visit("third", self.second);
  }
};

}  // namespace

TEST_CASE("A checkpoint with other fields of an observer is refused, and nothing is changed") {
  auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim, Changing{10, 20, 30});
  for (int k = 0; k < 10; ++k) sim.step();
  const std::uint64_t before = digest(internal::checkpoint_fields(sim));
  const auto message = [&](Layout changed) {
    layout = changed;
    Changing observer;
    const std::string text = test::message_of([&] { read_checkpoint(file.path(), sim, observer); });
    layout = Layout::whole;
    CHECK(observer.first == 1);
    CHECK(observer.second == 2);
    CHECK(observer.whole == 3);
    CHECK(digest(internal::checkpoint_fields(sim)) == before);
    return text;
  };
  CHECK(message(Layout::more) == file.path() + ": checkpoint/parts/0 has no field 'third'");
  CHECK(message(Layout::fewer) ==
        file.path() + ": checkpoint/parts/0/second: no such field in the program");
  CHECK(message(Layout::other_type) ==
        file.path() + ": checkpoint/parts/0/second: numbers of another type or shape");
  Changing observer;
  read_checkpoint(file.path(), sim, observer);
  CHECK(observer.second == 20);

  // Of a path the state of every stage.
  const LoadingStage<> hold{.name = "hold", .end = StepsMade{.steps = 3}};
  const LoadingStage<> press{.name = "press",
                             .axis_2 = EngineeringRate{.rate_of_strain = {.per_second = 1}},
                             .end = StressReached{.stress = 1e9}};
  const LoadingPath<> path{.confining_pressure = 2e6, .stages = {hold, press}};
  {
    auto run = path.start(sim);
    for (int k = 0; k < 6; ++k) REQUIRE(run.advance());
    write_checkpoint(file.path(), sim, run, observer);
  }
  auto run = path.start(sim);
  const std::uint64_t at_start = digest(internal::checkpoint_fields(sim, run));
  layout = Layout::more;
  CHECK_THROWS_AS(read_checkpoint(file.path(), sim, run, observer), InvalidInput);
  layout = Layout::whole;
  CHECK(digest(internal::checkpoint_fields(sim, run)) == at_start);
}

TEST_CASE("The file says which schema and versions wrote it, and its arrays have checksums") {
  const auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim);
  using internal::Hdf5Id;
  const Hdf5Id hdf5(H5Fopen(file.path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
  std::uint64_t schema = 0;
  const Hdf5Id of_schema(H5Aopen(hdf5, "schema", H5P_DEFAULT), H5Aclose, "open");
  REQUIRE(H5Aread(of_schema, H5T_NATIVE_UINT64, &schema) >= 0);
  CHECK(schema == checkpoint_schema);
  const std::string library = std::to_string(H5_VERS_MAJOR) + '.' + std::to_string(H5_VERS_MINOR) +
                              '.' + std::to_string(H5_VERS_RELEASE);
  for (const char* const name : {"riprap", "hdf5"}) {
    const Hdf5Id attribute(H5Aopen(hdf5, name, H5P_DEFAULT), H5Aclose, "open");
    const Hdf5Id type(H5Aget_type(attribute), H5Tclose, "open");
    std::string text(H5Tget_size(type), '\0');
    REQUIRE(H5Aread(attribute, type, text.data()) >= 0);
    CHECK(text == (name[0] == 'r' ? std::string(version) : library));
  }
  const Hdf5Id set(H5Dopen2(hdf5, "simulation/particles/local_vertices", H5P_DEFAULT), H5Dclose,
                   "open");
  const Hdf5Id properties(H5Dget_create_plist(set), H5Pclose, "open");
  REQUIRE(H5Pget_nfilters(properties) == 1);
  unsigned flags = 0;
  std::size_t values = 0;
  CHECK(H5Pget_filter2(properties, 0, &flags, &values, nullptr, 0, nullptr, nullptr) ==
        H5Z_FILTER_FLETCHER32);
}

TEST_CASE("A checkpoint of another path is refused, one of a path that ends elsewhere is not") {
  auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  const LoadingStage<> hold{.name = "hold",
                            .axis_1 = ControlledStress{.stress = 1e6},
                            .end = AnyOf<SingleEndOr<>>{{.parts = {StepsMade{.steps = 5}}}}};
  const LoadingStage<> press{.name = "press",
                             .axis_2 = EngineeringRate{.rate_of_strain = {.per_second = 1}},
                             .end = StrainReached{.strain = 0.1}};
  const LoadingPath<> path{.confining_pressure = 2e6, .stages = {hold, press}};
  {
    auto run = path.start(sim);
    for (int k = 0; k < 10; ++k) REQUIRE(run.advance());
    write_checkpoint(file.path(), sim, run);
  }
  const auto message = [&](auto&& change) {
    LoadingPath<> other = path;
    change(other);
    auto run = other.start(sim);
    const std::string text = test::message_of([&] { read_checkpoint(file.path(), sim, run); });
    const std::size_t end = text.rfind('/');
    return end == text.npos ? text : text.substr(end + 1);
  };
  const auto changed = [&](std::size_t k, auto&& change) {
    return message([&](LoadingPath<>& p) { change(p.stages[k]); });
  };
  CHECK(message([](LoadingPath<>&) {}).empty());
  CHECK(message([](LoadingPath<>& p) { p.confining_pressure = 3e6; }) ==
        "confining_pressure is 2e+06 in the file and 3e+06 in the program");
  CHECK(changed(0, [](auto& s) { s.axis_1 = ControlledStress{.stress = 2e6}; }) ==
        "stage_0_axis_1_stress is 1e+06 in the file and 2e+06 in the program");
  CHECK(changed(1, [](auto& s) { s.axis_1 = ConstantVolume{}; }) ==
        "stage_1_axis_1 is 'fixed' in the file and 'constant volume' in the program");
  CHECK(changed(0, [](auto& s) {
          s.end = AnyOf<SingleEndOr<>>{{.parts = {StepsMade{.steps = 6}}}};
        }) == "stage_0_end_0_steps is 5 in the file and 6 in the program");
  CHECK(changed(0, [](auto& s) { s.friction = false; }) ==
        "stage_0_friction is 1 in the file and 0 in the program");
  CHECK(changed(1, [](auto& s) { s.record_every = 0.1; }) ==
        "stage_1_record_every is 0.0025 in the file and 0.1 in the program");
  CHECK(changed(1, [](auto& s) { s.end = StressReached{.stress = 1e6}; }) ==
        "stage_1_end is 'strain' in the file and 'stress' in the program");
  CHECK(changed(1, [](auto& s) { s.end = StrainReached{.strain = 0.1, .of = StrainOf::axis_1}; }) ==
        "stage_1_end_of is 1 in the file and 0 in the program");
  CHECK_FALSE(changed(1, [](auto& s) { s.part = Stage::compaction; }).empty());
  CHECK(changed(1, [](auto& s) { s.end = StrainReached{.strain = 0.2}; }).empty());
  CHECK(changed(1, [](auto& s) { s.most_steps = 1000; }).empty());

  // On the other side of where the strain was when the stage began: one more step does not end it.
  LoadingPath<> back = path;
  back.stages[1].end = StrainReached{.strain = -0.1};
  // The sample from which rates by inertial number were computed is that of the file.
  auto other_sim = simulation_of(weak_model(), 2);
  auto run = back.start(other_sim);
  const double of_other = run.view().mean_diameter;
  read_checkpoint(file.path(), other_sim, run);
  CHECK(run.view().mean_diameter == path.start(sim).view().mean_diameter);
  CHECK(run.view().mean_diameter != of_other);
  REQUIRE(run.advance());
  CHECK_FALSE(run.view().reached_target);
}

TEST_CASE("A folder keeps the last two checkpoints, and the newest that is whole is read") {
  auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile place;
  const std::filesystem::path folder = std::filesystem::path(place.path()) / "of" / "checkpoints";
  const CheckpointFolder checkpoints{folder};
  std::vector<std::string> damaged;
  const auto read = [&] {
    return checkpoints.read_newest([&](const char* m) { damaged.emplace_back(m); }, sim).filename();
  };
  CHECK(test::message_of(read) == folder.string() + " has no checkpoint that can be read");
  const auto touch = [&](const char* name) { std::ofstream(folder / name) << "x"; };
  for (int k = 0; k < 12; ++k) {
    sim.step();
    checkpoints.write(sim);
    if (k == 3) touch("checkpoint_000000000002.h5.part");  // as a kill leaves it
  }
  touch("notes.txt");
  const auto left = std::distance(std::filesystem::directory_iterator(folder), {});
  CHECK(left == 3);
  REQUIRE(checkpoints.files().size() == 2);
  CHECK(checkpoints.files()[0].filename() == "checkpoint_000000000012.h5");
  CHECK(checkpoints.files()[1].filename() == "checkpoint_000000000011.h5");

  CHECK(read() == "checkpoint_000000000012.h5");
  CHECK(sim.steps() == 12);
  CHECK(damaged.empty());
  std::filesystem::resize_file(checkpoints.files()[0], 1000);
  CHECK(read() == "checkpoint_000000000011.h5");
  CHECK(sim.steps() == 11);
  REQUIRE(damaged.size() == 1);
  CHECK(test::contains(damaged[0], "checkpoint_000000000012.h5 is truncated: 1000 of "));

  touch("checkpoint_000000000013.h5.part");
  checkpoints.clear();
  CHECK(std::filesystem::exists(folder / "notes.txt"));
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
  std::filesystem::remove(folder / "notes.txt");
  checkpoints.clear();
  CHECK_FALSE(std::filesystem::exists(folder));
  std::filesystem::remove_all(place.path());
}

TEST_CASE("The file that a part appends to is brought to the disk first") {
  const auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim, Log{});
  CHECK_FALSE(read_whole_file(file.path()).empty());
  const test::TemporaryFile other;
  CHECK_THROWS_WITH_AS(write_checkpoint(other.path(), sim, Log{"/no/such/log"}),
                       "cannot write /no/such/log: No such file or directory", SimulationError);
  CHECK_FALSE(std::filesystem::exists(other.path()));
}

TEST_CASE("A damaged file is refused and nothing is changed") {
  auto sim = simulation_of(weak_model(), 1);
  const test::TemporaryFile file;
  write_checkpoint(file.path(), sim);
  const std::string whole = file.text();
  sim.step();
  const std::uint64_t before = digest(internal::checkpoint_fields(sim));
  const auto refused = [&](const std::string& text) {
    write_durable_file(file.path(), std::as_bytes(std::span(text)));
    try {
      read_checkpoint(file.path(), sim);
      return false;
    } catch (const DamagedCheckpoint&) {
      return digest(internal::checkpoint_fields(sim)) == before;
    }
  };
  for (std::size_t k = 0; k < 97; ++k) {
    const std::size_t place = k * whole.size() / 97;
    CAPTURE(place);
    CHECK(refused(whole.substr(0, place)));
    std::string flipped = whole;
    flipped[place] = static_cast<char>(flipped[place] ^ 1 << (k % 8));
    CHECK(refused(flipped));
  }
  CHECK(refused("POLYGON ((0 0, 1 0, 0 1))"));
}
