// SPDX-License-Identifier: BSL-1.0
#pragma once
// A run of the study, and what it is made of.

#include <nlohmann/json.hpp>
#include <string>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_placement.hpp>

#include "variation.hpp"

namespace study {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

// Unbreakable; breakable.
enum class Mode { nb, wb };

struct RunPlan {
  Mode mode = Mode::nb;
  double pressure = 2e6;  // [Pa]
  unsigned seed = 1;
  unsigned particles = 500;
  double axial_strain = 0.2;
  Variation variation = Variation::none;

  [[nodiscard]] std::string name() const;    // such as wb_0.5MPa_1
  [[nodiscard]] std::string folder() const;  // within that of the study
  [[nodiscard]] bool is(Mode m, double p) const { return mode == m && pressure == p; }
  // One sample of each series is drawn.
  [[nodiscard]] bool has_pictures() const { return seed == 1 && variation == Variation::none; }
  [[nodiscard]] riprap::RandomAssembly assembly() const;
  [[nodiscard]] riprap::BiaxialTest test() const;
  [[nodiscard]] riprap::HoekBrown criterion() const;
  [[nodiscard]] riprap::StraightCut splitter() const;
  // Of contacts, over the default.
  [[nodiscard]] double stiffness_factor() const;
  // A run whose folder has others is made again.
  [[nodiscard]] Json parameters() const;
  // About how long it takes, compaction and relaxation apart from the rest [any unit].
  [[nodiscard]] double work_before() const;
  [[nodiscard]] double work_in_shear() const;
  [[nodiscard]] double work() const { return work_before() + work_in_shear(); }

 private:
  [[nodiscard]] double cost_of_step() const;
};

std::string to_text(Mode mode);
// "0.5 MPa"
std::string pressure_text(double pressure);

// A model with the plan's contacts.
template <class ModelType>
[[nodiscard]] ModelType with_contacts_of(const RunPlan& plan, ModelType model) {
  model.contact_model.law.normal_stiffness *= plan.stiffness_factor();
  model.contact_model.law.tangential_stiffness *= plan.stiffness_factor();
  return model;
}

}  // namespace study
