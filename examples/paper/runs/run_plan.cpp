// SPDX-License-Identifier: BSL-1.0
// Table 1 and what the paper leaves open: the library's defaults.

#include "run_plan.hpp"

#include <algorithm>
#include <cmath>

#include <riprap/core/version.hpp>
#include <riprap/riprap.hpp>

#include "../../biaxial/setup_json.hpp"

namespace study {

std::string to_text(Mode mode) {
  switch (mode) {
  case Mode::nb:
    return "nb";
  case Mode::wb:
    return "wb";
  case Mode::pinned:
    return "pinned";
  }
  return "";
}

std::string to_text(Variation variation) {
  switch (variation) {
  case Variation::none:
    return "";
  case Variation::stocky_pieces:
    return "stocky_pieces";
  case Variation::large_pieces:
    return "large_pieces";
  case Variation::blunt_particles:
    return "blunt_particles";
  case Variation::slow_shear:
    return "slow_shear";
  }
  return "";
}

std::string pressure_text(double pressure) { return riprap::to_text(pressure / 1e6) + " MPa"; }

std::string RunPlan::name() const {
  std::string name =
      to_text(mode) + "_" + riprap::to_text(pressure / 1e6) + "MPa_" + std::to_string(seed);
  if (variation != Variation::none) name += "_" + to_text(variation);
  return name;
}

std::string RunPlan::folder() const {
  return (variation == Variation::none ? "runs/" : "causes/") + name();
}

riprap::RandomAssembly RunPlan::assembly() const {
  riprap::RandomAssembly a{.count = particles, .seed = seed};
  if (variation == Variation::blunt_particles) {
    a.shape.fewest_vertices = 5;
    a.shape.most_vertices = 8;
  }
  return a;
}

riprap::BiaxialTest RunPlan::test() const {
  const double rate = variation == Variation::slow_shear ? 0.5 : 1;
  return {.confining_pressure = pressure,
          .axial_strain = axial_strain,
          .inertial_number = rate * (pressure < 1e6 ? 5e-4 : 1e-3)};
}

riprap::StraightCut RunPlan::splitter() const {
  riprap::StraightCut cut;
  if (variation == Variation::stocky_pieces) cut.maximum_aspect = 2;
  if (variation == Variation::large_pieces) cut.minimum_area *= 2;
  return cut;
}

namespace {

Json motion_json(const riprap::Model<>& model) {
  const auto& law = model.contact_model.law;
  return {{"normal_stiffness_N_m", law.normal_stiffness},
          {"tangential_stiffness_N_m", law.tangential_stiffness},
          {"friction", law.friction},
          {"local_damping", model.motion_model.damping.coefficient},
          {"time_step_fraction", model.motion_model.time_step.fraction}};
}

Json breakage_json(const riprap::Model<>& model, const riprap::StraightCut& splitter) {
  const auto& breakage = model.breakage_model;
  const riprap::HoekBrown& c = breakage.criterion;
  return {{"compressive_strength_Pa", c.compressive_strength},
          {"m_b", c.m_b},
          {"s", c.s},
          {"a_b", c.a_b},
          {"mesh_triangles", model.stress_model.mesher.triangles},
          {"ratf", breakage.trigger.critical},
          {"minimum_piece_area", splitter.minimum_area},
          {"maximum_piece_aspect", splitter.maximum_aspect},
          {"check_every", breakage.check_every}};
}

}  // namespace

Json RunPlan::parameters() const {
  constexpr int layout_of_record = 2;  // of run.json and its pictures: another one, another run
  const riprap::Model<> model;
  const riprap::Rock rock;
  Json j = {
      {"riprap", riprap::version},
      {"record", layout_of_record},
      {"mode", to_text(mode)},
      {"assembly", assembly_json(assembly())},
      {"test", test_json(test())},
      {"rock",
       {{"density_kg_m3", rock.density}, {"young_Pa", rock.young}, {"poisson", rock.poisson}}},
      {"motion", motion_json(model)}};
  if (mode != Mode::nb) j["breakage"] = breakage_json(model, splitter());
  return j;
}

// In steps of unbreakable particles: those of shear are inversely proportional to its rate. The
// unit is the 26,000 of shear at 14 MPa.
double RunPlan::work_before() const { return 2.3 * particles; }

double RunPlan::work_in_shear() const {
  const double steps =
      axial_strain / 0.2 * 1e-3 / test().inertial_number * std::sqrt(14e6 / pressure);
  // Measured. The more particles are near to breaking the fewer checks are skipped; of pinned ones
  // none is.
  const double ratio = pressure / 3.2e6;
  const double cost_of_step = mode == Mode::nb ? 1 : mode == Mode::wb ? 1.3 + ratio * ratio : 25;
  return particles * steps * cost_of_step;
}

std::vector<RunPlan> all_runs(const Options& options) {
  const std::vector<double> pressures = options.quick
                                            ? std::vector<double>{0.5e6, 2e6, 14e6}
                                            : std::vector<double>{0.5e6, 1e6, 2e6, 4e6, 8e6, 14e6};
  const unsigned particles = options.quick ? 150 : 500;
  std::vector<RunPlan> runs;
  for (unsigned seed = 1; seed <= options.samples; ++seed)
    for (const double pressure : pressures)
      for (const Mode mode : {Mode::nb, Mode::wb, Mode::pinned})
        runs.push_back({mode, pressure, seed, particles});
  // Where breakage matters most.
  for (const double pressure : pressures)
    if (pressure >= 8e6)
      for (const Variation variation : {Variation::stocky_pieces, Variation::large_pieces,
                                        Variation::blunt_particles, Variation::slow_shear})
        runs.push_back({.mode = Mode::wb,
                        .pressure = pressure,
                        .particles = particles,
                        .variation = variation});
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RunPlan& a, const RunPlan& b) { return a.work() > b.work(); });
  return runs;
}

}  // namespace study
