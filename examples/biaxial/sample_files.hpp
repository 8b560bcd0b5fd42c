// SPDX-License-Identifier: BSL-1.0
#pragma once
// What the options of a biaxial test take from files.

#include "options.hpp"

// With the diameters of --grading and the polygons of --outlines, where they were given. Throws
// riprap::InvalidInput with the file, the line, the value and the rule.
Options with_sample_files(Options options);
