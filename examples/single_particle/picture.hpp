// SPDX-License-Identifier: BSL-1.0
#pragma once
// The four panels: mesh and forces, safety factors, failed elements with lines, pieces.

#include <riprap/output/svg.hpp>

#include "analysis.hpp"

riprap::Svg picture(const Analysis& analysis);
