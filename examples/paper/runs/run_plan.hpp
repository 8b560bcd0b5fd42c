// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs that make the study, and what each of them is made of.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_placement.hpp>

#include "../options.hpp"

namespace study {

// Keeps the order in which things are written.
using Json = nlohmann::ordered_json;

// Unbreakable; breakable and free in the stress analysis; breakable and pinned at two contacts.
enum class Mode { nb, wb, pinned };

// What a run does otherwise than its series, one thing at a time, to find the cause of a result.
enum class Variation { none, stocky_pieces, large_pieces, blunt_particles, slow_shear };

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
  [[nodiscard]] riprap::StraightCut splitter() const;
  // Everything the result depends on.
  [[nodiscard]] Json parameters() const;
  // About how long it takes, compaction and relaxation apart from the rest [any unit].
  [[nodiscard]] double work_before() const;
  [[nodiscard]] double work_in_shear() const;
  [[nodiscard]] double work() const { return work_before() + work_in_shear(); }
};

std::string to_text(Mode mode);
std::string to_text(Variation variation);
// "0.5 MPa"
std::string pressure_text(double pressure);

// The longest first, so that none is left alone at the end.
std::vector<RunPlan> all_runs(const Options& options);

}  // namespace study
