// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>
#include <limits>
#include <support/violated.hpp>

#include <riprap/breakage/trigger/any_element.hpp>
#include <riprap/breakage/trigger/failed_area_ratio.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/conformance/trigger.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct FailedCount {
  std::size_t critical = 20;
  bool operator()(const FailureCount& failures) const { return failures.failed >= critical; }
  void validate() const {}
};

struct HalfOnly {
  bool operator()(const FailureCount& failures) const {
    return 2 * failures.failed == failures.elements;
  }
  void validate() const {}
};

struct EverySecondTime {
  mutable bool now = false;
  bool operator()(const FailureCount&) const { return now = !now; }
  void validate() const {}
};

struct NeedsTooMany : FailedCount {
  std::size_t failed_elements_needed(std::size_t) const { return critical + 1; }
};

struct NeedsTooMuchArea : FailedAreaRatio {
  double failed_area_needed() const { return 1.1 * critical; }
};

/// A strength that is `strength` at the first call and changes by `change` with each.
struct Strength : NeverBreaks {
  mutable double strength = 1;
  double change = 0;
  double strength_factor(ParticleId, double) const { return strength += change; }
};

}  // namespace

TEST_CASE("the triggers of riprap obey the axioms") {
  CHECK(to_text(trigger_violations(FailedElementRatio{})) == "");
  CHECK(to_text(trigger_violations(FailedAreaRatio{})) == "");
  CHECK(to_text(trigger_violations(AnyElement{})) == "");
  CHECK(to_text(trigger_violations(WeibullStrength{})) == "");
  CHECK(to_text(trigger_violations(NeverBreaks{})) == "");
}

TEST_CASE("a user's trigger obeys the axioms") {
  CHECK(to_text(trigger_violations(FailedCount{})) == "");
  CHECK(to_text(trigger_violations(Strength{})) == "");
}

TEST_CASE("a trigger that breaks particles without failed elements is reported") {
  check_violated(trigger_violations(FailedCount{.critical = 0}),
                 "a particle without failed elements stays whole");
  check_violated(trigger_violations(FailedElementRatio{.critical = 0}),
                 "a particle without failed elements stays whole");
}

TEST_CASE("a trigger that is not monotonic, or not repeatable, is reported") {
  check_violated(trigger_violations(HalfOnly{}), "one more failed element never prevents a break");
  check_violated(trigger_violations(EverySecondTime{}), "the same count gives the same answer");
}

TEST_CASE("a trigger that fires with fewer failed elements than are needed is reported") {
  check_violated(trigger_violations(NeedsTooMany{}),
                 "a particle with fewer failed elements than are needed stays whole");
  check_violated(trigger_violations(NeedsTooMuchArea{}),
                 "a particle with less failed area than is needed stays whole");
}

TEST_CASE("a trigger with an impossible strength is reported") {
  check_violated(trigger_violations(Strength{{}, 0, 0}), "a strength factor is above zero");
  check_violated(trigger_violations(Strength{{}, std::numeric_limits<double>::infinity(), 0}),
                 "a strength factor is finite");
  check_violated(trigger_violations(Strength{{}, 1, 1e-9}), "a particle keeps its strength factor");
}
