// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/coarse_grained_stress.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/fake_contacts.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

void check_same(const Stress2& measured, const Stress2& expected, double tolerance) {
  CHECK(measured.s11 == near(expected.s11, tolerance));
  CHECK(measured.s22 == near(expected.s22, tolerance));
  CHECK(measured.s12 == near(expected.s12, tolerance));
}

/// Points of a grid in a box, and the area of one.
struct Grid {
  std::vector<Vec2> points;
  double area = 0;

  Grid(const Vec2& low, const Vec2& high, int count) {
    const Vec2 step = (high - low) / count;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        points.push_back(low + componentwise_product(step, Vec2{i + 0.5, j + 0.5}));
    area = step.x() * step.y();
  }
};

auto pressed() {
  Simulation sim{Model{}.criterion(NeverFails{}), random_assembly({.count = 120, .seed = 4}),
                 Rock{}};
  sim.boundary().set_rate(20, 20);
  for (int i = 0; i < 6500; ++i) sim.step();
  return sim;
}

}  // namespace

TEST_CASE("the integral over the plane is the sum of forces times branches") {
  const auto sim = pressed();
  const double thickness = sim.particles().thickness();
  const LucyKernel kernel{0.03};
  const auto lines = force_lines(sim.contacts());
  Vec2 low{1, 1};
  Vec2 high{-1, -1};
  for (const ForceLine& l : lines)
    for (const Vec2& p : {l.from, l.to}) {
      low = componentwise_min(low, p);
      high = componentwise_max(high, p);
    }
  const Vec2 reach{kernel.radius, kernel.radius};
  const Grid grid(low - reach, high + reach, 100);
  Stress2 sum;
  for (const Stress2& s : coarse_grained_stresses(lines, grid.points, kernel, thickness))
    sum += grid.area * s;
  const Stress2 expected = average_stress(sim.contacts(), 1, thickness);
  REQUIRE(expected.mean() > 0);
  // A step of a tenth of the radius; the kernel has two continuous derivatives.
  check_same(sum, expected, 1e-4 * expected.mean());
}

TEST_CASE("in a lattice of equal contacts the field is the average stress") {
  // Branches of unit length along both axes of a square lattice: a cell of unit area has one each.
  FakeContacts contacts;
  for (int i = -9; i < 9; ++i)
    for (int j = -9; j < 9; ++j) {
      const Vec2 at{static_cast<double>(i), static_cast<double>(j)};
      contacts.list.push_back(fake_contact(0, 1, at, at + Vec2{1, 0}, {1, 0}, 30, 5));
      contacts.list.push_back(fake_contact(0, 1, at, at + Vec2{0, 1}, {0, 1}, 80, 5));
    }
  const double thickness = 0.5;
  const std::vector<Vec2> points{{0, 0}, {0.5, 0.5}, {0.2, -0.4}, {1.3, 0.9}};
  // f l / t; the tangential forces cancel in the symmetric part: along axis 2 their tangent is
  // minus axis 1.
  for (const Stress2& s :
       coarse_grained_stresses(force_lines(contacts), points, LucyKernel{6}, thickness))
    // The lines are one apart, a sixth of the radius: the error of a midpoint rule over these.
    check_same(s, {60, 160, 0}, 0.01 * 160);
  // Between the last line of a half plane along axis 2 and the first one that is not there: half.
  FakeContacts half;
  for (const FakeContact& c : contacts.list)
    if (c.geometry.point.x() < 0.25) half.list.push_back(c);
  const Stress2 on_edge = coarse_grained_stresses(force_lines(half), std::vector<Vec2>{{0.5, 0.3}},
                                                  LucyKernel{6}, thickness)[0];
  CHECK(on_edge.s22 == near(80, 0.01 * 160));
}

TEST_CASE("the grid of points finds every line within the radius") {
  const auto sim = pressed();
  const LucyKernel kernel{0.03};
  const auto lines = force_lines(sim.contacts());
  const auto all = coarse_grained_stresses(sim.contacts(), sim.particles(), kernel);
  REQUIRE(all.size() == sim.particles().size());
  for (BodyIndex i = 0; i < all.size(); i += 7) {
    const Vec2 at = sim.particles().body(i).position;
    Stress2 direct;  // without a grid
    for (const ForceLine& l : lines)
      direct += (kernel.mean_over(l.from, l.to, at) / sim.particles().thickness()) * l.product;
    check_same(all[i], direct, 0);
  }
}

TEST_CASE("in a periodic cell the mean over the cell is its average stress") {
  Simulation sim{Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}),
                 random_periodic_assembly({.count = 60, .seed = 3}), Rock{}};
  sim.boundary().set_rate(20, 20);
  for (int i = 0; i < 6500; ++i) sim.step();
  const auto& cell = sim.contacts().domain();
  const double thickness = sim.particles().thickness();
  const Vec2 half = 0.5 * cell.period;
  const Grid grid(cell.centre - half, cell.centre + half, 80);
  const LucyKernel kernel{0.25 * cell.period.x()};
  Stress2 mean;
  for (const Stress2& s :
       coarse_grained_stresses(force_lines(sim.contacts()), grid.points, kernel, thickness))
    mean += (1.0 / 6400) * s;
  const Stress2 expected =
      average_stress(sim.contacts(), cell.period.x() * cell.period.y(), thickness);
  REQUIRE(expected.mean() > 0);
  check_same(mean, expected, 1e-4 * expected.mean());
}

TEST_CASE("platens have no stress, and what is not finite is refused by name") {
  const ConvexPolygon square{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  Particles particles(1, 1);
  particles.add(square, Motion::free);
  particles.add(square, Motion::platen);
  FakeContacts contacts;
  contacts.list.push_back(fake_contact(0, 1, {0, 0}, {0.1, 0}, {1, 0}, 5, 0));
  const auto stresses = coarse_grained_stresses(contacts, particles, LucyKernel{0.4});
  CHECK(stresses[0].s11 > 0);
  CHECK(stresses[1].s11 == 0);
  const std::vector<Vec2> points{{0, std::numeric_limits<double>::infinity()}};
  const auto lines = force_lines(contacts);
  const auto text = [&](const auto& at, const LucyKernel& kernel, double thickness) {
    return message_of([&] { (void)coarse_grained_stresses(lines, at, kernel, thickness); });
  };
  CHECK(contains(text(points, {1}, 1), "coordinate of a point = inf"));
  CHECK(contains(text(std::vector<Vec2>{}, {1}, 0), "thickness = 0"));
  CHECK(contains(text(std::vector<Vec2>{}, {-1}, 1), "LucyKernel.radius = -1"));
}
