// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the biaxial example, group by group.

#include "../command_line/option_table.hpp"
#include "options.hpp"

// Assembly, test and rock.
void add_sample_and_test(command_line::OptionTable& table, Options& options);
// Contacts, motion, stress in the particles, and breakage.
void add_model(command_line::OptionTable& table, Options& options);
