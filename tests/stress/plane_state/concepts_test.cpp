// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/stress/plane_state/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutElasticity : archetype::PlaneState {
  void elasticity() const {}
};
struct WithoutStress : archetype::PlaneState {
  void out_of_plane_stress() const {}
};
struct NotConst : archetype::PlaneState {
  Eigen::Matrix3d elasticity(const Rock&) { return Eigen::Matrix3d::Zero(); }
};
struct GivesAnExpression : archetype::PlaneState {
  auto elasticity(const Rock&) const { return Eigen::Matrix3d::Zero(); }
};
struct ChangesTheRock : archetype::PlaneState {
  Eigen::Matrix3d elasticity(Rock&) const { return Eigen::Matrix3d::Zero(); }
};
struct StressIsNotConst : archetype::PlaneState {
  double out_of_plane_stress(const Rock&, const Stress2&) { return 0; }
};
struct StressIsNoNumber : archetype::PlaneState {
  Vec2 out_of_plane_stress(const Rock&, const Stress2&) const { return {0, 0}; }
};
struct StressChangesTheRock : archetype::PlaneState {
  double out_of_plane_stress(Rock&, const Stress2&) const { return 0; }
};
struct StressChangesTheStress : archetype::PlaneState {
  double out_of_plane_stress(const Rock&, Stress2&) const { return 0; }
};

static_assert(PlaneState<archetype::PlaneState>);
static_assert(!PlaneState<WithoutElasticity>);
static_assert(!PlaneState<WithoutStress>);
static_assert(!PlaneState<NotConst>);
static_assert(!PlaneState<GivesAnExpression>);
static_assert(!PlaneState<ChangesTheRock>);
static_assert(!PlaneState<StressIsNotConst>);
static_assert(!PlaneState<StressIsNoNumber>);
static_assert(!PlaneState<StressChangesTheRock>);
static_assert(!PlaneState<StressChangesTheStress>);

}  // namespace

TEST_CASE("a plane state may be made of another") {
  struct Softer : PlaneStress {
    Eigen::Matrix3d elasticity(const Rock& rock) const {
      return 0.5 * PlaneStress::elasticity(rock);
    }
  };
  CHECK(PlaneState<Softer>);
}
