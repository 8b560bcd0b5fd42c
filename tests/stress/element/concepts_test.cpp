// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/stress/element/concepts.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

struct WithoutStrain : archetype::Element {
  void strain_displacement() const {}
};
struct WithoutMass : archetype::Element {
  void mass() const {}
};
struct NotConst : archetype::Element {
  Eigen::Matrix3d mass(const std::array<Vec2, 3>&) { return Eigen::Matrix3d::Zero(); }
};
struct GivesAnExpression : archetype::Element {
  auto mass(const std::array<Vec2, 3>&) const { return Eigen::Matrix3d::Zero(); }
};
struct ChangesTheCorners : archetype::Element {
  Eigen::Matrix3d mass(std::array<Vec2, 3>&) const { return Eigen::Matrix3d::Zero(); }
};
struct StrainIsNotConst : archetype::Element {
  StrainDisplacement strain_displacement(const std::array<Vec2, 3>&) {
    return StrainDisplacement::Zero();
  }
};
struct StrainIsAnExpression : archetype::Element {
  auto strain_displacement(const std::array<Vec2, 3>&) const { return StrainDisplacement::Zero(); }
};
struct StrainChangesTheCorners : archetype::Element {
  StrainDisplacement strain_displacement(std::array<Vec2, 3>&) const {
    return StrainDisplacement::Zero();
  }
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

}  // namespace

TEST_CASE("an element may be made of another") {
  struct Heavier : ConstantStrainTriangle {
    Eigen::Matrix3d mass(const std::array<Vec2, 3>& corners) const {
      return 2 * ConstantStrainTriangle::mass(corners);
    }
  };
  CHECK(Element<Heavier>);
}
