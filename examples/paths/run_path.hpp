// SPDX-License-Identifier: BSL-1.0
#pragma once
// One sample along one loading path.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/path_result.hpp>

#include "../run_table/progress_line.hpp"

namespace command_line {
struct Saving;
}

namespace paths {

struct Sample {
  unsigned particles = 300;
  std::uint64_t seed = 1;
  double strength = 300e6;  // uniaxial compressive strength of the rock [Pa]
  double stiffness = 2e7;   // of a contact, normal and tangential [N/m]
  bool breakage = true;
};

// A run that is to be made.
struct PlannedRun {
  std::string variant;  // the same for all samples
  Sample sample{};
  double pressure = 2e6;  // of the preparation and of rates by inertial number [Pa]
  std::vector<riprap::LoadingStage<>> stages{};
  std::string picture{};  // title of a picture of the sample at the end; empty: none

  // Of its folder.
  [[nodiscard]] std::string name() const;
};

// What a run leaves.
struct Run {
  PlannedRun plan;
  std::vector<riprap::CurvePoint> points{};  // of the curve
  std::vector<double> hardin{};              // B_r at each of them [-]
  double solid_area = 0;                     // inside the boundary at the start of loading [m^2]
  double area = 0;                           // of the sample at the start of loading [m^2]
  double thickness = 0;                      // [m]
  std::size_t breakages_before = 0;          // in preparation
  std::vector<riprap::StageResult> stages{};
  std::vector<std::string> warnings{};
  bool interrupted = false;
};

// Throws InvalidInput if the path cannot be run on the sample.
void check_path(const PlannedRun& plan);

// Makes the run, a unit of the work of `line`; its tables grow in the folder of `saving`, which
// exists. Goes on from a checkpoint that is there, and leaves one of its end: a run that is made
// already takes no step.
Run run_path(const PlannedRun& plan, const command_line::Saving& saving,
             run_table::ProgressLine& line);

}  // namespace paths
