// SPDX-License-Identifier: BSL-1.0
#pragma once
// The samples that all models begin with.

#include <cstdint>

#include <riprap/particle/assembly.hpp>

namespace rivals {

// A random sample, compacted without breakage and friction; particles at rest.
riprap::Assembly compacted_sample(unsigned particles, std::uint64_t seed);

// Mean diameter of the circles of equal area of its free particles [m].
double mean_diameter(const riprap::Assembly& sample);

}  // namespace rivals
