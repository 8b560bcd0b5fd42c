// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle breaks when the failed share of its area reaches a limit.

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// FailedElementRatio with elements weighted by their areas: the same where all are equal. Where
/// they are not, the count gives small elements the weight of large ones.
struct FailedAreaRatio {
  double critical = 0.4;  ///< failed area over the area of the particle [-]; above 1 nothing breaks

  [[nodiscard]] bool operator()(const FailureCount& failures) const {
    return failures.area_ratio() >= reached();
  }
  [[nodiscard]] double failed_area_needed() const { return reached(); }

  static void for_each_field(auto& self, auto&& visit) { visit("critical", self.critical); }

  void validate() const { require_positive("FailedAreaRatio.critical", critical); }

 private:
  // Round-off of sums of areas: 40 of 100 equal ones reach 0.4. The areas of a mesh agree with that
  // of its polygon to 1e-12 or so.
  [[nodiscard]] double reached() const { return (1 - 1e-9) * critical; }
};

static_assert(ScreenableTrigger<FailedAreaRatio>);

}  // namespace riprap
