// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Default models of the roles that only accelerate: those of acceleration/, where that folder is.

#if __has_include(<riprap/acceleration/operator_cache.hpp>)

#include <riprap/acceleration/batching/batched_detection.hpp>
#include <riprap/acceleration/neighbour_list/verlet_list.hpp>
#include <riprap/acceleration/operator_cache.hpp>
#include <riprap/acceleration/screening/stress_bound_screening.hpp>

namespace riprap {

using DefaultNeighbourList = VerletList;
using DefaultDetection = BatchedDetection;
using DefaultScreening = StressBoundScreening;
using DefaultOperatorStore = OperatorCache;

}  // namespace riprap

#else

#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/contact/detection/evaluate_each_pair.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/stress/operator_store/keep_all_operators.hpp>

namespace riprap {

using DefaultNeighbourList = RebuildEveryStep;
using DefaultDetection = EvaluateEachPair;
using DefaultScreening = EvaluateAll;
using DefaultOperatorStore = KeepAllOperators;

}  // namespace riprap

#endif
