// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the study leaves in a folder.

#include <filesystem>

#include <riprap/output/file.hpp>

#include "figures.hpp"
#include "report.hpp"
#include "specimen_picture.hpp"

namespace unconfined {

inline void write_files(const Study& s, const std::filesystem::path& folder) {
  riprap::make_folder(folder);
  const auto at = [&](const char* name) { return (folder / name).string(); };
  draw_specimen(s).save(at("fig3_specimen.svg"));
  draw_poisson(s).save(at("fig4_poisson.svg"));
  draw_strength(s).save(at("fig5_strength.svg"));
  draw_others(s).save(at("what_moves_rat.svg"));
  riprap::write_file(at("unconfined.json"), to_json(s).dump(2) + "\n");
}

}  // namespace unconfined
