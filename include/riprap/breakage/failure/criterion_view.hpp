// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Any criterion behind one type, for policies that are no templates.

#include <riprap/breakage/failure/element_failure.hpp>

namespace riprap {

/// Refers to the criterion of a model; valid as long as that is.
class CriterionView {
 public:
  template <Criterion C>
  explicit CriterionView(const C& criterion)
      : criterion_(&criterion), tensile_strength_([](const void* c) -> double {
          return static_cast<const C*>(c)->tensile_strength();
        }),
        evaluate_([](const void* c, const Stress2& stress) {
          return riprap::evaluate(*static_cast<const C*>(c), stress);
        }),
        planes_([](const void* c, const Stress2& stress, FailureMode mode) {
          return riprap::failure_planes(*static_cast<const C*>(c), stress, mode);
        }) {}

  /// [Pa], positive.
  [[nodiscard]] double tensile_strength() const { return tensile_strength_(criterion_); }
  /// Mode and safety factor under a stress [Pa].
  [[nodiscard]] ElementFailure evaluate(const Stress2& stress) const {
    return evaluate_(criterion_, stress);
  }
  /// The planes along which a stress [Pa] fails by a mode; none for `intact`.
  [[nodiscard]] FailurePlanes failure_planes(const Stress2& stress, FailureMode mode) const {
    return planes_(criterion_, stress, mode);
  }

 private:
  const void* criterion_;
  double (*tensile_strength_)(const void*);
  ElementFailure (*evaluate_)(const void*, const Stress2&);
  FailurePlanes (*planes_)(const void*, const Stress2&, FailureMode);
};

}  // namespace riprap
