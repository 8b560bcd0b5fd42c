// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/bond_list.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/random.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double k_n = 3e9;
constexpr double k_s = 1e9;
constexpr double thickness = 0.5;
constexpr double length = 1;
constexpr BrittleBond strong{.normal_stiffness = k_n,
                             .tangential_stiffness = k_s,
                             .tensile_strength = 1e30,
                             .cohesion = 1e30,
                             .friction = 0};
using List = BondList<BrittleBond, UnboundedDomain>;

/// Two squares side by side, joined along the edge x = 0.5; body 0 is the left one.
struct Pair {
  Particles particles{thickness, 2000};
  List list{strong};
  std::vector<List::BondType> failed{};

  explicit Pair(const BrittleBond& law = strong) : list(law) {
    particles.add(rectangle({0, 0}, length, length), Motion::free);
    particles.add(rectangle({1, 0}, length, length), Motion::free);
    const std::vector<PlacedBond> bonds{{.a = 0, .b = 1, .ends = {{{0.5, 0.5}, {0.5, -0.5}}}}};
    list.add(bonds, particles, {});
  }
  void move(BodyIndex i, const Vec2& by, double turn, const Vec2& about) {
    Body& body = particles.body(i);
    const Rotation r = Rotation::from_angle(turn);
    body.position = about + r * (body.position - about) + by;
    const Vec2 axis = r * Vec2{body.rotation.cosine, body.rotation.sine};
    body.rotation = {axis.x(), axis.y()};
  }
  void update() { list.update(particles, {}, failed); }
  [[nodiscard]] double energy() {
    update();
    return list.stored_energy(thickness);
  }
  [[nodiscard]] const Wrench& on(BodyIndex i) const { return list.wrenches()[i]; }
};

}  // namespace

TEST_CASE("pure opening: the force is stiffness times area times opening, and so is the energy") {
  for (const double opening : {1e-4, -1e-4}) {
    Pair pair;
    pair.move(1, {opening, 0}, 0, {0, 0});
    pair.update();
    const double force = k_n * length * thickness * opening;
    // Positions have an error of 1e-16 of their size, 1: 1e-12 of the opening.
    CHECK((pair.on(1).force - Vec2{-force, 0}).norm() <= 1e-11 * std::abs(force));
    CHECK((pair.on(0).force - Vec2{force, 0}).norm() <= 1e-11 * std::abs(force));
    CHECK(pair.on(1).moment == near(0, 1e-11 * std::abs(force)));
    CHECK(pair.energy() == near_relative(0.5 * force * opening, 1e-11));
    CHECK(pair.list[0].tractions[0].normal == near_relative(-k_n * opening, 1e-11));
  }
}

TEST_CASE("pure sliding: a force along the edge, and the couple that balances it") {
  Pair pair;
  const double sliding = 2e-4;
  pair.move(1, {0, sliding}, 0, {0, 0});
  pair.update();
  const double force = k_s * length * thickness * sliding;
  CHECK((pair.on(1).force - Vec2{0, -force}).norm() <= 1e-11 * force);
  // At the arm -0.5 from the centroid of b and 0.5 from that of a.
  CHECK(pair.on(1).moment == near_relative(0.5 * force, 1e-11));
  CHECK(pair.on(0).moment == near_relative(0.5 * force, 1e-11));
  CHECK(pair.energy() == near_relative(0.5 * force * sliding, 1e-11));
}

TEST_CASE("pure rotation about the middle of the edge, of any size") {
  // The copies of the edge cross at the angle q: 2 s sin(q / 2) apart at s from the middle, along
  // the normal half-way. Energy 4 sin^2(q / 2) k t L^3 / 24, moment its derivative.
  for (const double turn : {1e-4, 0.1, 1.0}) {
    Pair pair;
    pair.move(1, {0, 0}, turn, {0.5, 0});
    pair.update();
    const double third = thickness * length * length * length;
    const double half = std::sin(0.5 * turn);
    CHECK(pair.energy() == near_relative(k_n * third * 4 * half * half / 24, 1e-11));
    const Vec2 arm = Vec2{0.5, 0} - pair.particles.body(1).position;
    const double about_middle = pair.on(1).moment - cross(arm, pair.on(1).force);
    CHECK(about_middle == near_relative(-k_n * third * std::sin(turn) / 12, 1e-11));
    CHECK(pair.on(1).force.norm() <= 1e-11 * k_n * turn);
  }
}

TEST_CASE("forces are the gradient of the energy, balance each other, and know no rigid motion") {
  Random random(3);
  for (int n = 0; n < 20; ++n) {
    Pair pair;
    const auto draw = [&](double size) { return random.uniform(-size, size); };
    pair.move(0, {draw(0.1), draw(0.1)}, draw(0.4), {0, 0});
    pair.move(1, {draw(0.1), draw(0.1)}, draw(0.4), {0, 0});
    pair.update();
    const std::array wrenches{pair.on(0), pair.on(1)};
    const double energy = pair.energy();

    const double size = wrenches[0].force.norm();
    CHECK((wrenches[0].force + wrenches[1].force).norm() <= 1e-12 * size);
    double moment = 0;  // about the origin
    for (const BodyIndex i : {0u, 1u})
      moment += wrenches[i].moment + cross(pair.particles.body(i).position, wrenches[i].force);
    CHECK(moment == near(0, 1e-12 * size));

    // Central differences: an error of step^2 from the third derivative, 1e-16 / step from
    // rounding.
    const double step = 1e-5;
    for (const BodyIndex i : {0u, 1u}) {
      const auto slope = [&](const Vec2& along, double turn) {
        std::array<double, 2> at{};
        for (std::size_t side = 0; side < 2; ++side) {
          Pair moved = pair;
          const double by = side == 0 ? -step : step;
          moved.move(i, by * along, by * turn, pair.particles.body(i).position);
          at[side] = moved.energy();
        }
        return (at[1] - at[0]) / (2 * step);
      };
      const double tolerance = 1e-8 * k_n;
      CHECK(slope({1, 0}, 0) == near(-wrenches[i].force.x(), tolerance));
      CHECK(slope({0, 1}, 0) == near(-wrenches[i].force.y(), tolerance));
      CHECK(slope({0, 0}, 1) == near(-wrenches[i].moment, tolerance));
    }

    const double turn = draw(3);
    const Vec2 by{draw(1), draw(1)};
    for (const BodyIndex i : {0u, 1u}) pair.move(i, by, turn, {0.3, 0.7});
    CHECK(pair.energy() == near_relative(energy, 1e-11));
    const Vec2 turned = Rotation::from_angle(turn) * wrenches[1].force;
    CHECK((pair.on(1).force - turned).norm() <= 1e-11 * size);
    CHECK(pair.on(1).moment == near(wrenches[1].moment, 1e-11 * size));
  }
}

TEST_CASE("a rigid motion of two unstrained bodies strains no bond") {
  Pair pair;
  for (const BodyIndex i : {0u, 1u}) pair.move(i, {3, -2}, 2.5, {0.2, 0.1});
  pair.update();
  // Positions of 5 m have an error of 1e-15.
  CHECK(pair.on(0).force.norm() <= 1e-14 * k_n);
}

TEST_CASE("a bond that fails is handed over, and its forces are gone") {
  Pair pair{BrittleBond{.normal_stiffness = k_n, .tensile_strength = 1e6}};
  pair.move(1, {0.999e6 / k_n, 0}, 0, {0, 0});
  pair.update();
  CHECK(pair.list.size() == 1);
  CHECK(pair.list.pairs().contains(0, 1, {}));
  pair.move(1, {0.002e6 / k_n, 0}, 0, {0, 0});
  pair.update();
  REQUIRE(pair.failed.size() == 1);
  CHECK(pair.failed[0].failure == BondFailure::tension);
  CHECK(pair.list.empty());
  CHECK_FALSE(pair.list.pairs().contains(0, 1, {}));
  CHECK(pair.on(0).force == Vec2{0, 0});
}

TEST_CASE("the order in which bodies and ends are named does not matter") {
  Pair pair;
  List other{strong};
  const std::vector<PlacedBond> bonds{{.a = 1, .b = 0, .ends = {{{0.5, -0.5}, {0.5, 0.5}}}}};
  other.add(bonds, pair.particles, {});
  pair.move(1, {1e-3, 2e-3}, 0.01, {0, 0});
  pair.update();
  std::vector<List::BondType> failed;
  other.update(pair.particles, {}, failed);
  CHECK(other.wrenches()[1].force == pair.on(1).force);
  CHECK(other.wrenches()[1].moment == pair.on(1).moment);
}

TEST_CASE("bodies without a normal between them are refused") {
  Pair pair;
  const std::vector<PlacedBond> bonds{{.a = 0, .b = 1, .ends = {{{0, 0}, {1, 0}}}}};
  CHECK(
      test::message_of([&] { pair.list.add(bonds, pair.particles, {}); }) ==
      "bond of particle 0 and particle 1: distance of the centroids across the edge [m] = 0: must "
      "not be zero");
}
