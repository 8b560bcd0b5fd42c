// SPDX-License-Identifier: BSL-1.0
#pragma once
// Section 3.2 of the paper: the study of examples/unconfined with the paper's rock.

#include <filesystem>

namespace study {

// Fills the folder, unless it is finished already.
void make_unconfined(const std::filesystem::path& folder);

}  // namespace study
