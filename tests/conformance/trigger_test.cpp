// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>
#include <limits>
#include <support/violated.hpp>

#include <riprap/breakage/trigger/any_element.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/failed_area_ratio.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/breakage/trigger/hertzian_strength.hpp>
#include <riprap/breakage/trigger/mean_stress_failure.hpp>
#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/breakage/trigger/trigger_choice.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/breakage/trigger/with_weibull_strength.hpp>
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

// By the loads, spoilt in one way each.
struct Unloaded {
  FailureMode operator()(const LoadedParticle& particle) const {
    return particle.loads().empty() ? FailureMode::tension : FailureMode::intact;
  }
};
struct UpToAForce {
  FailureMode operator()(const LoadedParticle& particle) const {
    const double force = particle.loads().empty() ? 0 : particle.loads()[0].normal_force;
    return force > 1e3 && force < 1e6 ? FailureMode::tension : FailureMode::intact;
  }
};
struct FirstLoad {
  FailureMode operator()(const LoadedParticle& particle) const {
    const bool large = !particle.loads().empty() && particle.loads()[0].normal_force > 1e4;
    return large ? FailureMode::tension : FailureMode::intact;
  }
};
struct OfThePlace {
  FailureMode operator()(const LoadedParticle& particle) const {
    const bool far = particle.centroid().norm() > 1 && !particle.loads().empty();
    return far ? FailureMode::tension : FailureMode::intact;
  }
};
struct AcrossAxis1 {
  FailureMode operator()(const LoadedParticle& particle) const {
    return particle.mean_stress().s11 > 1e7 ? FailureMode::tension : FailureMode::intact;
  }
};
struct AlternatesByLoads {
  mutable bool now = false;
  FailureMode operator()(const LoadedParticle&) const {
    now = !now;
    return now ? FailureMode::tension : FailureMode::intact;
  }
};

using Choice = TriggerChoice<BrazilianStrength, TsounguiStrength>;

}  // namespace

TEST_CASE("the triggers by loads of riprap obey the axioms, and have no preferred axes") {
  const auto check = [](const auto& trigger) {
    CHECK(to_text(trigger_violations(trigger)) == "");
    CHECK(to_text(trigger_rotation_violations(trigger)) == "");
  };
  check(BrazilianStrength{});
  check(MeanStressFailure{});
  check(HertzianStrength{});
  check(TsounguiStrength{});
  check(WithWeibullStrength{BrazilianStrength{}});
  check(Choice{TsounguiStrength{}});
  CHECK(to_text(trigger_violations(WithWeibullStrength{FailedElementRatio{}})) == "");
}

TEST_CASE("a trigger by loads that breaks an axiom is reported") {
  check_violated(trigger_violations(Unloaded{}), "a particle without loads stays whole");
  check_violated(trigger_violations(UpToAForce{}), "a larger load never prevents a break");
  check_violated(trigger_violations(FirstLoad{}), "the order of the loads does not matter");
  check_violated(trigger_violations(OfThePlace{}), "a shifted particle fails likewise");
  check_violated(trigger_violations(AlternatesByLoads{}), "the same loads give the same answer");
  check_violated(trigger_rotation_violations(AcrossAxis1{}), "a turned particle fails likewise");
  CHECK(to_text(trigger_violations(AcrossAxis1{})) == "");
}

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
