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

static_assert(PlaneState<archetype::PlaneState>);
static_assert(!PlaneState<WithoutElasticity>);
static_assert(!PlaneState<WithoutStress>);
static_assert(!PlaneState<NotConst>);
static_assert(!PlaneState<GivesAnExpression>);
static_assert(!PlaneState<ChangesTheRock>);

}  // namespace

TEST_CASE("a plane state may be made of another") {
  struct Softer : PlaneStress {
    Eigen::Matrix3d elasticity(const Rock& rock) const {
      return 0.5 * PlaneStress::elasticity(rock);
    }
  };
  CHECK(PlaneState<Softer>);
}
