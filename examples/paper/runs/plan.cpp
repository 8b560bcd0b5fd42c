// SPDX-License-Identifier: BSL-1.0
// Table 1 and what the paper leaves open: the library's defaults.

#include "plan.hpp"

#include <array>
#include <cmath>

#include <riprap/core/version.hpp>
#include <riprap/riprap.hpp>
#include <riprap/simulation/presets/bagherzadeh_2008.hpp>
#include <riprap/simulation/presets/recommended.hpp>

#include "../../biaxial/setup_json.hpp"

namespace study {

std::string to_text(Mode mode) { return mode == Mode::nb ? "nb" : "wb"; }

std::string to_text(Variation variation) {
  static constexpr std::array names = {"",
                                       "mean_tension_line",
                                       "failure_plane",
                                       "small_pieces",
                                       "weak_rock",
                                       "two_pinned_contacts",
                                       "periodic_cell",
                                       "stocky_pieces",
                                       "large_pieces",
                                       "blunt_particles",
                                       "slow_shear",
                                       "stiff_contacts",
                                       "many_particles",
                                       "recommended_preset",
                                       "paper_preset"};
  return names.at(static_cast<std::size_t>(variation));
}

std::string pressure_text(double pressure) { return riprap::to_text(pressure / 1e6) + " MPa"; }

std::string RunPlan::name() const {
  std::string name =
      to_text(mode) + "_" + riprap::to_text(pressure / 1e6) + "MPa_" + std::to_string(seed);
  if (variation != Variation::none) name += "_" + to_text(variation);
  return name;
}

std::string RunPlan::folder() const {
  return (variation == Variation::none ? "runs/" : "rows/") + name();
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
  if (variation == Variation::small_pieces) {
    cut.minimum_area = 0.02;
    cut.maximum_aspect = 5;
  }
  return cut;
}

riprap::HoekBrown RunPlan::criterion() const {
  riprap::HoekBrown rock;
  if (variation == Variation::weak_rock) rock.compressive_strength /= 4;
  return rock;
}

double RunPlan::stiffness_factor() const { return variation == Variation::stiff_contacts ? 4 : 1; }

namespace {

const char* name_of(const riprap::OverlapMoments&) { return "OverlapMoments"; }
const char* name_of(const riprap::OverlapChord&) { return "OverlapChord"; }
const char* name_of(const riprap::EnergyConservingSpring&) { return "EnergyConservingSpring"; }
const char* name_of(const riprap::LinearSpringCoulomb&) { return "LinearSpringCoulomb"; }

template <class ModelType>
Json motion_json(const ModelType& model) {
  const auto& law = model.contact_model.law;
  return {{"narrow_phase", name_of(model.contact_model.narrow_phase)},
          {"contact_law", name_of(law)},
          {"normal_stiffness_N_m", law.normal_stiffness},
          {"tangential_stiffness_N_m", law.tangential_stiffness},
          {"friction", law.friction},
          {"local_damping", model.motion_model.damping.coefficient},
          {"time_step_fraction", model.motion_model.time_step.fraction}};
}

template <class ModelType>
Json breakage_json(const ModelType& model) {
  const auto& breakage = model.breakage_model;
  return {{"compressive_strength_Pa", breakage.criterion.compressive_strength},
          {"m_b", breakage.criterion.m_b},
          {"s", breakage.criterion.s},
          {"a_b", breakage.criterion.a_b},
          {"mesh_triangles", model.stress_model.mesher.triangles},
          {"nodes_of_triangle", model.stress_model.element.nodes},
          {"rat_measure", rat_measure(breakage.trigger)},
          {"ratf", breakage.trigger.critical},
          {"minimum_piece_area", breakage.splitter.minimum_area},
          {"maximum_piece_aspect", breakage.splitter.maximum_aspect},
          {"check_every", breakage.check_every}};
}

}  // namespace

Json RunPlan::parameters() const {
  constexpr int layout_of_record = 3;  // of run.json and its pictures: another one, another run
  const riprap::Rock rock;
  Json j = {
      {"riprap", riprap::version},
      {"record", layout_of_record},
      {"mode", to_text(mode)},
      {"variation", to_text(variation)},
      {"assembly", assembly_json(assembly())},
      {"test", test_json(test())},
      {"rock",
       {{"density_kg_m3", rock.density}, {"young_Pa", rock.young}, {"poisson", rock.poisson}}}};
  const auto add_model = [&](const auto& model) {
    j["motion"] = motion_json(model);
    if (mode != Mode::nb) j["breakage"] = breakage_json(model);
  };
  if (variation == Variation::recommended_preset)
    add_model(riprap::presets::recommended());
  else if (variation == Variation::paper_preset)
    add_model(riprap::presets::bagherzadeh_2008());
  else
    add_model(
        with_contacts_of(*this, riprap::Model<>{}).criterion(criterion()).splitter(splitter()));
  return j;
}

// In steps of unbreakable particles: those of shear are inversely proportional to its rate. The
// unit is the 26,000 of shear at 14 MPa.
double RunPlan::work_before() const { return 2.3 * particles * std::sqrt(stiffness_factor()); }

double RunPlan::work_in_shear() const {
  const double steps = axial_strain / 0.2 * 1e-3 / test().inertial_number *
                       std::sqrt(14e6 / pressure * stiffness_factor());
  return particles * steps * cost_of_step();
}

// Measured. The more particles are near to breaking the fewer checks are skipped, and the more of
// them break the more there are; of pinned ones no check is skipped.
double RunPlan::cost_of_step() const {
  if (mode == Mode::nb) return 1;
  const double ratio = pressure / 6e6;
  const double cost = 1.2 + ratio * ratio;
  switch (variation) {
  case Variation::two_pinned_contacts:
  case Variation::paper_preset:
    return 10;
  case Variation::mean_tension_line:
  case Variation::failure_plane:
  case Variation::small_pieces:
  case Variation::weak_rock:
  case Variation::recommended_preset:
    return 2 * cost;
  default:
    return cost;
  }
}

}  // namespace study
