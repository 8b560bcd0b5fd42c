// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Whether the breakage of a model needs finite elements.

#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/breakage/trigger/concepts.hpp>

namespace riprap {

/// False if trigger and line fit both take the loaded particle alone: no particle is meshed then
/// and no influence operator built in any step.
/// @tparam BreakagePart offers `trigger` and `line_fit`
template <class BreakagePart>
inline constexpr bool needs_elements =
    !LoadTrigger<decltype(BreakagePart::trigger)> || !LoadLineFit<decltype(BreakagePart::line_fit)>;

/// Whether trigger or line fit takes the loaded particle.
template <class BreakagePart>
inline constexpr bool needs_loaded_particle =
    LoadTrigger<decltype(BreakagePart::trigger)> ||
    requirements::TriggerByCountAndLoads<decltype(BreakagePart::trigger)> ||
    LineFitOfParticle<decltype(BreakagePart::line_fit)>;

}  // namespace riprap
