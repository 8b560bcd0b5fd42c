// SPDX-License-Identifier: BSL-1.0
#pragma once
// The files that a run leaves in its folder.

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>

#include <riprap/output/frames.hpp>
#include <riprap/output/paraview.hpp>

#include "checkpoints.hpp"

inline constexpr std::array result_files{
    "curves.svg",       "assembly_before.svg", "assembly_after.svg", "forces_before.svg",
    "forces_after.svg", "displacement.svg",    "curve.csv",          "energy.csv",
    "breakages.csv",    "summary.json",        "parameters.toml"};

inline std::filesystem::path paraview_folder(const std::filesystem::path& folder) {
  return folder / "paraview";
}
inline std::filesystem::path frames_folder(const std::filesystem::path& folder) {
  return folder / "frames";
}

// Removes the files of an earlier run, and nothing else: what the new run does not write again
// would be taken for its own.
inline void remove_results(const std::filesystem::path& folder) {
  std::error_code ignored;  // what cannot be removed shows when it is written
  for (const std::string name : result_files)
    for (const std::string& file : {name, name + ".part"})  // of a run that was killed
      if (!std::filesystem::is_directory(folder / file, ignored))
        std::filesystem::remove(folder / file, ignored);
  riprap::ParaViewSeries::remove(paraview_folder(folder));
  riprap::FrameWriter::remove(frames_folder(folder));
  riprap::CheckpointFolder(command_line::checkpoint_folder(folder)).clear();
}

// The axial strain at which a run has finished that left all its results in a folder.
inline std::optional<double> finished_strain(const std::filesystem::path& folder) {
  std::ifstream file(folder / "summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || summary.value("status", "") != "finished") return std::nullopt;
  return summary.at("/parameters/test/axial_strain"_json_pointer).get<double>();
}

// Those that are there, separated by commas.
inline std::string present_results(const std::filesystem::path& folder) {
  std::string out;
  std::error_code ignored;
  for (const char* name : result_files)
    if (std::filesystem::exists(folder / name, ignored))
      out += (out.empty() ? "" : ", ") + std::string(name);
  return out;
}
