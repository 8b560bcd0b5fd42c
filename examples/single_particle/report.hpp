// SPDX-License-Identifier: BSL-1.0
#pragma once
// The numbers of the analysis on the standard output.

#include "analysis.hpp"

void print_report(const Analysis& analysis);
