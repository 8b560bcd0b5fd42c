// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <riprap/experiment/validity_check.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/still_sample.hpp>

using namespace riprap;
using riprap::test::contains;
using riprap::test::near_relative;

namespace {

// The polygon through the centroids of the outer squares is smaller than the squares.
constexpr Limits roomy{.porosity = -1};

constexpr double force = 200;  // [N]: 2e7 N/m times a depth of 1e-5 m

/// A sample in which every number is far inside its range, one of which is then pushed out.
struct Scene {
  explicit Scene(const test::Cross& cross = {}) : sample(cross) {}

  test::StillSample sample;
  BiaxialView<test::StillSample> view = test::view_of(sample);

  /// Warnings of one record.
  [[nodiscard]] std::vector<std::string> warnings(Limits limits = {}) const {
    limits.porosity = roomy.porosity;
    ValidityCheck check(limits);
    check.record(view);
    return check.warnings();
  }
};

double number_at(const std::string& warning, std::size_t at) {
  double value = 0;
  std::from_chars(warning.data() + at, warning.data() + warning.size(), value);
  return value;
}

/// The only warning is about `name`, with this value and this limit.
void check_only(const std::vector<std::string>& warnings, const std::string& name, double value,
                double limit) {
  REQUIRE(warnings.size() == 1);
  CAPTURE(warnings[0]);
  CHECK(warnings[0].starts_with(name + " = "));
  CHECK(contains(warnings[0], " above " + to_text(limit) + " at strain "));
  // Depths of 1e-5 in coordinates of 1e-2 have lost four digits.
  CHECK(number_at(warnings[0], name.size() + 3) == near_relative(value, 1e-11));
}

}  // namespace

TEST_CASE("a slow, stiff and quiet sample gives no warning") {
  Scene scene;
  scene.view.stretch.y() = 0.9;
  CHECK(scene.warnings().empty());
}

TEST_CASE("a fast test is reported by its inertial number") {
  Scene scene;
  // Both normal stresses are f l / (A t) per contact, two contacts on an axis: A = 2 reach^2.
  const double pressure = force / (0.012 * 0.016);
  scene.view.rate = {123, 0.25};
  const double number = 0.25 * 0.016 * std::sqrt(2500 / pressure);
  check_only(scene.warnings({.inertial_number = 1e-5}), "inertial number", number, 1e-5);
  CHECK(scene.warnings({.inertial_number = 1.0001 * number}).empty());
}

TEST_CASE("soft particles are reported by their overlap") {
  Scene scene(test::Cross{.depths = {1e-5, 2e-5, 1e-5, 2e-5}});
  // The mean of the depths, not the largest.
  check_only(scene.warnings({.overlap_ratio = 9e-4}), "mean overlap over mean diameter",
             1.5e-5 / 0.016, 9e-4);
  CHECK(scene.warnings({.overlap_ratio = 9.4e-4}).empty());
}

TEST_CASE("a long time step is reported by its share of sqrt(m/k)") {
  Scene scene;
  const double mass = 2500 * 0.016 * 0.016 * 0.016;
  const double critical = std::sqrt(mass / 2e7);
  scene.sample.set_time_step(0.3 * critical);
  check_only(scene.warnings(), "time step over sqrt(m/k)", 0.3, 0.25);
  scene.sample.set_time_step(0.24 * critical);
  CHECK(scene.warnings().empty());
  // A light piece counts with the mass that it has in the equations of motion.
  scene.sample.set_time_step(0.3 * critical);
  scene.sample.body(0).mass_scaling = 2;
  CHECK(scene.warnings().empty());
  check_only(scene.warnings({.time_step_ratio = 0.2}), "time step over sqrt(m/k)",
             0.3 / std::sqrt(2), 0.2);
}

TEST_CASE("a moving sample is reported by its kinetic energy, once it has begun to deform") {
  Scene scene;
  scene.sample.body(0).velocity = {0.3, -0.4};
  const double kinetic = 0.5 * 2500 * 0.016 * 0.016 * 0.016 * 0.25;
  const double stored = 4 * 0.5 * force * 1e-5;
  scene.view.stretch.y() = 0.95;
  check_only(scene.warnings(), "kinetic over stored energy", kinetic / stored, 0.02);
  scene.view.stretch.y() = 0.995;
  CHECK(scene.warnings().empty());
}

TEST_CASE(
    "a sample out of balance is reported by its unbalanced force, once it has begun to deform") {
  // East pushes by 100 N more than west; the mean contact force is 225 N.
  Scene scene(test::Cross{.depths = {1.5e-5, 1e-5, 1e-5, 1e-5}});
  scene.view.stretch.y() = 0.95;
  check_only(scene.warnings(), "unbalanced force", 100 / 225.0, 0.15);
  scene.view.stretch.y() = 0.995;
  CHECK(scene.warnings().empty());
}

TEST_CASE("a sample whose contacts carry its weight is in balance") {
  Scene scene(test::Cross{.depths = {1.5e-5, 1e-5, 1e-5, 1e-5}});
  scene.view.stretch.y() = 0.95;
  // East pushes to the west.
  scene.sample.set_body_force({100 / scene.sample.particles().body(0).mass, 0});
  CHECK(scene.warnings().empty());
}

TEST_CASE(
    "before it is loaded, a sample is judged by the stiffness level of the pressure to come") {
  Scene scene;
  scene.view.stage = Stage::hydrostatic;
  ValidityCheck check(roomy);
  check.begin_stage(scene.view);
  CHECK(check.warnings().empty());
  // kappa = p t / k_n.
  scene.view.confining_pressure = 1e8;
  check.begin_stage(scene.view);
  check.begin_stage(scene.view);
  check_only(check.warnings(), "stiffness level kappa", 1e8 * 0.016 / 2e7, 0.05);
}

TEST_CASE("a sample that is above its pressure before it is loaded gets a warning") {
  const double stress = force / (0.012 * 0.016);
  Scene scene;
  scene.view.stage = Stage::hydrostatic;
  scene.view.confining_pressure = 1.0001 * stress;
  ValidityCheck below(roomy);
  below.begin_stage(scene.view);
  CHECK(below.warnings().empty());
  scene.view.confining_pressure = 0.9999 * stress;
  ValidityCheck above(roomy);
  above.begin_stage(scene.view);
  REQUIRE(above.warnings().size() == 1);
  check_only(above.warnings(), "mean stress after relaxation over confining pressure", 1 / 0.9999,
             1);
}

TEST_CASE("pressure and stiffness are judged when the hydrostatic stage begins, not otherwise") {
  Scene scene;
  ValidityCheck check({.stiffness_level = 0});
  for (const Stage stage : {Stage::compaction, Stage::relaxation, Stage::shear}) {
    scene.view.stage = stage;
    check.begin_stage(scene.view);
  }
  CHECK(check.warnings().empty());
}

TEST_CASE("every limit can be moved on its own") {
  Scene scene(test::Cross{.depths = {1.5e-5, 1e-5, 1e-5, 1e-5}});
  scene.view.stretch.y() = 0.95;
  scene.view.rate = {0, 0.25};
  scene.sample.body(0).velocity = {0.1, 0};
  const auto warnings = scene.warnings({0, 0, 0, 0, 0, 0});
  REQUIRE(warnings.size() == 5);
  const Limits wide{1e9, 1e9, 1e9, 1e9, 1e9, 1e9};
  CHECK(scene.warnings(wide).empty());
  const std::vector<std::pair<double Limits::*, std::string>> all{
      {&Limits::inertial_number, "inertial number"},
      {&Limits::overlap_ratio, "mean overlap over mean diameter"},
      {&Limits::kinetic_ratio, "kinetic over stored energy"},
      {&Limits::unbalanced_force, "unbalanced force"},
      {&Limits::time_step_ratio, "time step over sqrt(m/k)"}};
  for (const auto& [limit, name] : all) {
    Limits one = wide;
    one.*limit = 0;
    const auto only = scene.warnings(one);
    REQUIRE(only.size() == 1);
    CHECK(only[0].starts_with(name + " = "));
  }
}

TEST_CASE("a number that stays out of range is reported once, the first time, with its strain") {
  Scene scene;
  ValidityCheck check(roomy);
  check.record(scene.view);
  scene.view.rate.y() = 10;
  scene.view.stretch.y() = 0.75;
  check.record(scene.view);
  scene.view.rate.y() = 20;
  scene.view.stretch.y() = 0.5;
  check.record(scene.view);
  REQUIRE(check.warnings().size() == 1);
  CHECK(contains(check.warnings()[0], " at strain 0.25 of shear"));
  // Another number still has its turn.
  scene.sample.set_time_step(1);
  check.record(scene.view);
  REQUIRE(check.warnings().size() == 2);
  CHECK(contains(check.warnings()[1], "time step"));
  CHECK(contains(check.warnings()[1], " at strain 0.5 of shear"));
}

TEST_CASE("a sample that has lost its pressure is out of range of the inertial number") {
  Scene scene(test::Cross{.depths = {-1e-4, -1e-4, -1e-4, -1e-4}});
  scene.view.rate = {0, 1e-9};
  const auto warnings = scene.warnings();
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("inertial number = inf above 0.001"));
}

TEST_CASE("a stage that its cap on steps ended is a warning, one that arrived is not") {
  Scene scene;
  ValidityCheck check(roomy);
  scene.view.reached_target = true;
  check.end_stage(scene.view);
  CHECK(check.warnings().empty());
  scene.view.reached_target = false;
  scene.view.stage = Stage::hydrostatic;
  check.end_stage(scene.view);
  REQUIRE(check.warnings().size() == 1);
  CHECK(check.warnings()[0].starts_with("missed targets of stages = 1 above 0"));
  CHECK(contains(check.warnings()[0], "of hydrostatic: its cap on steps ended the stage"));
}

TEST_CASE("a pressure in the wrong unit is reported before the first step") {
  Scene scene;
  scene.view.stage = Stage::compaction;
  ValidityCheck right(roomy);
  right.begin_stage(scene.view);
  CHECK(right.warnings().empty());
  scene.view.confining_pressure = 2;  // for 2 MPa
  ValidityCheck wrong(roomy);
  wrong.begin_stage(scene.view);
  REQUIRE(wrong.warnings().size() == 1);
  CHECK(contains(wrong.warnings()[0], "below 1e-06 at"));
  CHECK(wrong.warnings()[0].ends_with(": is the confining pressure in Pa?"));
}

TEST_CASE("millimetres taken for metres are reported before the first step") {
  for (const auto& [diameter, said] :
       {std::pair{16.0, "mean diameter [m] = 16 above 2"},
        std::pair{1.6e-6, "mean diameter [m] = 1.6e-06 below 1e-05"}}) {
    Scene scene;
    scene.view.stage = Stage::compaction;
    scene.view.mean_diameter = diameter;
    ValidityCheck check(roomy);
    check.begin_stage(scene.view);
    REQUIRE(check.warnings().size() == 2);
    CHECK(check.warnings()[0].starts_with(said));
    CHECK(check.warnings()[1].starts_with("thickness over mean diameter, or its inverse = "));
  }
}

TEST_CASE("a servo that does not reach its pressure is reported at the end of shear") {
  Scene scene;
  scene.view.reached_target = true;
  scene.view.mean_confinement_error = -0.04;
  scene.view.saturated_share = 0.04;
  ValidityCheck held(roomy);
  held.end_stage(scene.view);
  CHECK(held.warnings().empty());
  scene.view.mean_confinement_error = -0.39;
  scene.view.saturated_share = 0.3;
  scene.view.reached_target = false;
  ValidityCheck lost(roomy);
  lost.end_stage(scene.view);
  REQUIRE(lost.warnings().size() == 3);
  CHECK(lost.warnings()[0].starts_with("mean error of the lateral stress = 0.39 above 0.05"));
  CHECK(lost.warnings()[1].starts_with("share of steps with the servo at its limit = 0.3 above"));
  CHECK(contains(lost.warnings()[2], "the servo did not hold"));
}

TEST_CASE(
    "energy that contact law and splitting make is reported by its share of the work put in") {
  ValidityCheck check(roomy);
  // 100 J put in; the law makes 3 J and breaks take 7 J out.
  EnergyTerms terms{.boundary_work = 90, .body_force_work = 10, .breakage = 7, .law_residual = -3};
  check.check_energy(terms, 0.1);
  CHECK(check.warnings().empty());
  terms.breakage = -2.5;
  check.check_energy(terms, 0.2);
  REQUIRE(check.warnings().size() == 1);
  CHECK(check.warnings()[0] ==
        "energy made by contact law and splitting over the work put in = 0.055 above 0.05 at "
        "strain 0.2 of shear: the contact law does not conserve energy");
  // Before any work is done there is nothing to compare with.
  ValidityCheck early(roomy);
  early.check_energy({.law_residual = -1}, 0);
  CHECK(early.warnings().empty());
}

TEST_CASE("the table has every number with its worst value, where it was met, limit and reason") {
  Scene scene;
  ValidityCheck check(roomy);
  scene.view.rate.y() = 1e-3;
  check.record(scene.view);
  scene.view.rate.y() = 2e-3;
  scene.view.stretch.y() = 0.75;
  check.record(scene.view);
  scene.view.rate.y() = 1e-3;
  scene.view.stretch.y() = 0.5;
  check.record(scene.view);
  const auto& rows = check.table().rows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [](const CheckedNumber& n) { return n.name == "inertial number"; });
  REQUIRE(row != rows.end());
  CHECK(row->measured);
  CHECK(row->holds());
  CHECK(row->limit == 1e-3);
  CHECK(row->axial_strain == 0.25);
  CHECK(row->reason == "not quasi-static");
  CHECK(check.table().violations() == 0);
  for (const CheckedNumber& number : rows) {
    CHECK(!number.name.empty());
    CHECK(!number.reason.empty());
  }
}

TEST_CASE("a sample with more rock than room is reported") {
  Scene scene;
  ValidityCheck check;
  check.record(scene.view);
  REQUIRE(check.warnings().size() == 1);
  CHECK(check.warnings()[0].starts_with("porosity = -0."));
}
