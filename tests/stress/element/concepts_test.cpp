// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

using Corners = std::array<Vec2, 3>;
using Rule = std::array<TrianglePoint, 2>;

struct WithoutStrain : archetype::Element {
  void strain_displacement() const {}
};
struct WithoutMass : archetype::Element {
  void mass() const {}
};
struct NotConst : archetype::Element {
  NodalMass<3> mass(const Corners&) { return NodalMass<3>::Zero(); }
};
struct GivesAnExpression : archetype::Element {
  auto mass(const Corners&) const { return NodalMass<3>::Zero(); }
};
struct ChangesTheCorners : archetype::Element {
  NodalMass<3> mass(Corners&) const { return NodalMass<3>::Zero(); }
};
struct StrainIsNotConst : archetype::Element {
  StrainDisplacement<3> strain_displacement(const Corners&, const Barycentric&) {
    return StrainDisplacement<3>::Zero();
  }
};
struct StrainIsAnExpression : archetype::Element {
  auto strain_displacement(const Corners&, const Barycentric&) const {
    return StrainDisplacement<3>::Zero();
  }
};
struct StrainChangesTheCorners : archetype::Element {
  StrainDisplacement<3> strain_displacement(Corners&, const Barycentric&) const {
    return StrainDisplacement<3>::Zero();
  }
};
struct StrainWithoutPoint : archetype::Element {
  StrainDisplacement<3> strain_displacement(const Corners&) const {
    return StrainDisplacement<3>::Zero();
  }
};
struct FourNodes : archetype::Element {
  static constexpr std::size_t nodes = 4;
};
struct NodesAtRunTime : archetype::Element {
  std::size_t nodes = 3;
};
struct OtherNodes : archetype::Element {  // than its matrices
  static constexpr std::size_t nodes = 6;
};
struct WithoutSampling : archetype::Element {
  void sampling_points() const {}
};
struct SharesOfTwo : archetype::Element {
  static constexpr Rule sampling_points{TrianglePoint{}, TrianglePoint{}};
};
struct UnequalShares : archetype::Element {
  static constexpr Rule sampling_points{TrianglePoint{{0.5, 0.25, 0.25}, 0.25},
                                        TrianglePoint{{0.25, 0.375, 0.375}, 0.75}};
};
struct UnequalWeights : UnequalShares {  // to integrate by
  static constexpr Rule integration_points = UnequalShares::sampling_points;
  static constexpr auto sampling_points = LinearStrainTriangle::sampling_points;
};
struct NegativeShare : archetype::Element {
  static constexpr Rule integration_points{TrianglePoint{{1, 0, 0}, 1.5},
                                           TrianglePoint{{0, 1, 0}, -0.5}};
};
struct OffThePlane : archetype::Element {
  static constexpr Rule integration_points{TrianglePoint{{1, 1, 0}, 0.5},
                                           TrianglePoint{{0, 1, 0}, 0.5}};
};

static_assert(Element<archetype::Element>);
static_assert(!Element<WithoutStrain>);
static_assert(!Element<WithoutMass>);
static_assert(!Element<NotConst>);
static_assert(!Element<GivesAnExpression>);
static_assert(!Element<ChangesTheCorners>);
static_assert(!Element<StrainIsNotConst>);
static_assert(!Element<StrainIsAnExpression>);
static_assert(!Element<StrainChangesTheCorners>);
static_assert(!Element<StrainWithoutPoint>);
static_assert(!Element<FourNodes>);
static_assert(!Element<NodesAtRunTime>);
static_assert(!Element<OtherNodes>);
static_assert(!Element<WithoutSampling>);
static_assert(!Element<SharesOfTwo>);
static_assert(!Element<UnequalShares>);
static_assert(Element<UnequalWeights>);
static_assert(!Element<NegativeShare>);
static_assert(!Element<OffThePlane>);

}  // namespace

TEST_CASE("an element may be made of another") {
  struct Heavier : ConstantStrainTriangle {
    NodalMass<3> mass(const Corners& corners) const {
      return 2 * ConstantStrainTriangle::mass(corners);
    }
  };
  CHECK(Element<Heavier>);
}
