// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/average_stress.hpp>

#include <doctest/doctest.h>
#include <limits>

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/particle/body.hpp>
#include <support/fake_contacts.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double pi = std::numbers::pi;

// A unit square pushed from both sides along axis 1 with a force; the wall particles' centroids lie
// on its sides, so that the branches end there.
FakeContacts squeezed_square(double force) {
  return {.list = {fake_contact(0, 1, {-0.5, 0}, {0, 0}, {1, 0}, force, 0),
                   fake_contact(1, 2, {0, 0}, {0.5, 0}, {1, 0}, force, 0)}};
}

// A square lattice of bodies with contacts that carry the forces of a uniform stress.
struct Lattice {
  std::vector<Body> bodies;
  FakeContacts contacts;

  Lattice(const Stress2& s, double spacing, double thickness, int half) {
    const int n = 2 * half + 1;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        Body body;
        body.position = spacing * Vec2{i - half, j - half};
        bodies.push_back(body);
      }
    const double side = spacing * thickness;
    const auto connect = [&](int p, int q, const Vec2& n_pq) {
      const Vec2 f =
          side * Vec2{s.s11 * n_pq.x() + s.s12 * n_pq.y(), s.s12 * n_pq.x() + s.s22 * n_pq.y()};
      const auto a = static_cast<BodyIndex>(p);
      const auto b = static_cast<BodyIndex>(q);
      contacts.list.push_back(fake_contact(a, b, bodies[a].position, bodies[b].position, n_pq,
                                           f.dot(n_pq), f.dot(perpendicular(n_pq))));
    };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        if (i + 1 < n) connect(j * n + i, j * n + i + 1, {1, 0});
        if (j + 1 < n) connect(j * n + i, (j + 1) * n + i, {0, 1});
      }
  }
};

void check_same(const Stress2& measured, const Stress2& expected, double tolerance) {
  CHECK(measured.s11 == near(expected.s11, tolerance));
  CHECK(measured.s22 == near(expected.s22, tolerance));
  CHECK(measured.s12 == near(expected.s12, tolerance));
}

}  // namespace

TEST_CASE("a unit square under opposite inward unit forces has a stress of +1 on their axis") {
  check_same(average_stress(squeezed_square(1), 1, 1), {1, 0, 0}, 1e-15);
}

TEST_CASE("stress is force over length times thickness") {
  check_same(average_stress(squeezed_square(500), 1, 0.016), {31250, 0, 0}, 1e-10);
  check_same(average_stress(squeezed_square(500), 4, 0.016), {7812.5, 0, 0}, 1e-10);
}

TEST_CASE("outward forces are tension, negative") {
  check_same(average_stress(squeezed_square(-1), 1, 1), {-1, 0, 0}, 1e-15);
}

TEST_CASE("a pair of opposite couples is a pure shear stress") {
  // Shear forces on all four sides of a unit square: +y on the right, +x on the top as pushed by it
  // on its neighbours, equal and opposite on the others.
  const FakeContacts contacts{.list = {fake_contact(0, 1, {-0.5, 0}, {0, 0}, {1, 0}, 0, 1),
                                       fake_contact(0, 2, {0, 0}, {0.5, 0}, {1, 0}, 0, 1),
                                       fake_contact(3, 0, {0, -0.5}, {0, 0}, {0, 1}, 0, -1),
                                       fake_contact(0, 4, {0, 0}, {0, 0.5}, {0, 1}, 0, -1)}};
  check_same(average_stress(contacts, 1, 1), {0, 0, 1}, 1e-15);
}

TEST_CASE("of forces that turn the assembly the symmetric part counts") {
  const FakeContacts contacts{.list = {fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 0, 3)}};
  check_same(average_stress(contacts, 1, 1), {0, 0, 1.5}, 1e-15);
  check_same(average_stress_within(contacts, Ellipse{{2, 2}}, 1), {0, 0, 1.5 / (4 * pi)}, 1e-15);
}

TEST_CASE("average stress turns with the assembly, and bodies may be exchanged") {
  const Stress2 s{3e6, 1e6, 0.4e6};
  const Lattice lattice(s, 0.02, 0.016, 3);
  const double area = 49 * 0.0004;
  const Stress2 upright = average_stress(lattice.contacts, area, 0.016);
  for (const double angle : {0.3, 1.7, -2.2}) {
    const Rotation turn = Rotation::from_angle(angle);
    FakeContacts turned = lattice.contacts;
    for (std::size_t i = 0; i < turned.list.size(); ++i) {
      FakeContact& c = turned.list[i];
      c.geometry.normal = turn * c.geometry.normal;
      c.arm_a = turn * c.arm_a;
      c.arm_b = turn * c.arm_b;
      if (i % 2 == 0) c = exchanged(c);
    }
    check_same(average_stress(turned, area, 0.016), upright.rotated(turn), 1e-7);
  }
}

TEST_CASE("the share of a segment inside a circle") {
  const Ellipse circle{{1, 1}};
  CHECK(circle.area() == near(pi, 1e-15));
  CHECK(circle.share_inside({-2, 0}, {2, 0}) == near(0.5, 1e-15));
  CHECK(circle.share_inside({0, 0}, {0, 4}) == near(0.25, 1e-15));
  CHECK(circle.share_inside({4, 0}, {0, 0}) == near(0.25, 1e-15));
  CHECK(circle.share_inside({-0.3, 0.1}, {0.5, 0.7}) == 1);
  // A chord 0.6 off the centre has the half length 0.8.
  CHECK(circle.share_inside({-1, 0.6}, {1, 0.6}) == near(0.8, 1e-15));
  CHECK(circle.share_inside({0, 0.6}, {3.2, 0.6}) == near(0.25, 1e-15));
  // Beside it, beyond it, before it, touching it.
  CHECK(circle.share_inside({-2, 1.5}, {2, 1.5}) == 0);
  CHECK(circle.share_inside({2, 0}, {3, 0}) == 0);
  CHECK(circle.share_inside({3, 0}, {2, 0}) == 0);
  CHECK(circle.share_inside({-2, 1}, {2, 1}) == 0);
  // Segments of no length.
  CHECK(circle.share_inside({0.2, 0.3}, {0.2, 0.3}) == 1);
  CHECK(circle.share_inside({2, 0.3}, {2, 0.3}) == 0);
}

TEST_CASE("the share of a segment inside an ellipse") {
  const Ellipse ellipse{{3, 0.5}};
  CHECK(ellipse.area() == near(1.5 * pi, 1e-14));
  CHECK(ellipse.share_inside({-6, 0}, {6, 0}) == near(0.5, 1e-15));
  CHECK(ellipse.share_inside({0, -2}, {0, 2}) == near(0.25, 1e-15));
  CHECK(ellipse.share_inside({-3, 0.3}, {3, 0.3}) == near(0.8, 1e-15));
  // Where it leaves along the diagonal, x^2 / 9 + 4 x^2 = 1.
  CHECK(ellipse.share_inside({0, 0}, {1, 1}) == near(1 / std::sqrt(1.0 / 9 + 4), 1e-15));
}

TEST_CASE("the shares of the parts of a segment add up") {
  const Ellipse ellipse{{1.3, 0.7}};
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{random.uniform(-2, 2), random.uniform(-2, 2)};
    const Vec2 q{random.uniform(-2, 2), random.uniform(-2, 2)};
    const double s = random.uniform(0, 1);
    const Vec2 x = p + s * (q - p);
    // Where the line only grazes the ellipse the root loses half its digits.
    CHECK(ellipse.share_inside(p, q) ==
          near(s * ellipse.share_inside(p, x) + (1 - s) * ellipse.share_inside(x, q), 1e-7));
    CHECK(ellipse.share_inside(p, q) == near(ellipse.share_inside(q, p), 1e-7));
  }
}

TEST_CASE("a region that holds all contacts has the average of the assembly") {
  const Lattice lattice({2e6, 5e6, -0.7e6}, 0.02, 0.016, 4);
  const Ellipse all{{0.2, 0.15}};
  const Stress2 within = average_stress_within(lattice.contacts, all, 0.016);
  check_same(within, average_stress(lattice.contacts, all.area(), 0.016), 1e-7);
}

TEST_CASE("in a uniform stress the region reads that stress whatever its size and shape") {
  const Stress2 s{2e6, 5e6, -0.7e6};
  const Lattice lattice(s, 0.01, 0.016, 25);
  for (const Vec2& axes : {Vec2{0.2, 0.2}, Vec2{0.23, 0.11}, Vec2{0.09, 0.17}}) {
    const Stress2 within = average_stress_within(lattice.contacts, Ellipse{axes}, 0.016);
    // Sum of the chords of lattice lines against the area: for an ellipse of n spacings the error
    // is of the order n^-1.5; 9 spacings across give 4 %.
    CHECK(within.s11 == near_relative(s.s11, 0.02));
    CHECK(within.s22 == near_relative(s.s22, 0.02));
    CHECK(within.s12 == near_relative(s.s12, 0.02));
  }
}

TEST_CASE("a contact on the rim of the region counts with the part of its branch inside") {
  FakeContacts contacts{.list = {fake_contact(0, 1, {0.5, 0}, {2.5, 0}, {1, 0}, 10, 0)}};
  const Ellipse unit{{1, 1}};
  // Half a metre of two lies inside.
  check_same(average_stress_within(contacts, unit, 1), {10 * 0.5 / pi, 0, 0}, 1e-14);
}

TEST_CASE("sin phi of a test that loads axis 2") {
  CHECK(sin_phi({1, 5, 0}) == near(2.0 / 3, 1e-15));
  CHECK(sin_phi({1e6, 4e6, 0}) == near(0.6, 1e-15));
  CHECK(sin_phi({1, 3, 9}) == 0.5);
  CHECK(sin_phi({2, 2, 0}) == 0);
  CHECK(sin_phi({3, 1, 0}) == -0.5);
  CHECK(sin_phi({0, 0, 0}) == 0);
}

TEST_CASE("an average over no area, or of forces that are not finite, is refused by name") {
  FakeContacts contacts;
  contacts.list.push_back(fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 5, 0));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS((void)average_stress(contacts, bad, 1), InvalidInput);
    CHECK_THROWS_AS((void)average_stress(contacts, 1, bad), InvalidInput);
    CHECK_THROWS_AS((void)average_stress_within(contacts, Ellipse{{bad, 1}}, 1), InvalidInput);
    CHECK_THROWS_AS((void)average_stress_within(contacts, Ellipse{{1, 1}}, bad), InvalidInput);
  }
  CHECK(message_of([&] { (void)average_stress(contacts, -1, 1); }) ==
        "average_stress: area = -1: must be a finite number above 0");
  contacts.list[0].force.normal = std::numeric_limits<double>::infinity();
  CHECK(contains(message_of([&] { (void)average_stress(contacts, 1, 1); }),
                 "sum of contact forces times branch vectors"));
  CHECK_THROWS_AS((void)average_stress_within(contacts, Ellipse{{1, 1}}, 1), InvalidInput);
}
