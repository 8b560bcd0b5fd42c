// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle breaks when the share of failed elements reaches RatF: the default trigger.

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Rat >= RatF (section 3.2 of the paper).
struct FailedElementRatio {
  double critical = 0.4;  ///< RatF [-]; above 1 nothing breaks

  [[nodiscard]] bool operator()(const FailureCount& failures) const {
    return failures.ratio() >= critical;
  }
  [[nodiscard]] std::size_t failed_elements_needed(std::size_t elements) const {
    return failed_elements_for_ratio(elements, critical);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("critical", self.critical); }

  void validate() const { require_positive("FailedElementRatio.critical", critical); }
};

static_assert(Trigger<FailedElementRatio>);

}  // namespace riprap
