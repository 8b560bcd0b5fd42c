// SPDX-License-Identifier: BSL-1.0
#pragma once
// The contact models that are compared; compiled each by itself.

#include "../run_table/biaxial_numbers.hpp"
#include "../run_table/biaxial_setup.hpp"

namespace contact_models {

using run_table::BiaxialNumbers;
using run_table::Setup;

BiaxialNumbers run_chord(const Setup& setup);
BiaxialNumbers run_incremental(const Setup& setup);
BiaxialNumbers run_area(const Setup& setup);
BiaxialNumbers run_moments(const Setup& setup);

}  // namespace contact_models
