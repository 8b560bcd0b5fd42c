// SPDX-License-Identifier: BSL-1.0
#include "run_unconfined.hpp"

#include "../../unconfined/files.hpp"

void study::make_unconfined(const std::filesystem::path& folder) {
  // Written last.
  if (std::filesystem::exists(folder / "unconfined.json")) return;
  unconfined::write_files(unconfined::unconfined_study(unconfined::Options{}), folder);
}
