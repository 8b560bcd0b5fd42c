// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/neighbour_list/displacement_bound.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double size = 0.1;   // of the bodies, at most
constexpr double near = 0.25;  // apart along an axis

// In a square, most of them far from most others.
Particles crowd(Random& random) {
  Particles particles(1, 1);
  for (int i = 0; i < 36; ++i)
    particles.add(random_polygon({}, size, random).moved({}, {0.12 * (i % 6), 0.12 * (i / 6)}),
                  Motion::free);
  return particles;
}

struct Vertex {
  BodyIndex body;
  Vec2 place;
};
std::vector<Vertex> vertices(const Particles& particles) {
  std::vector<Vertex> all;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    for (const Vec2& v : particles.ring(i)) all.push_back({i, v});
  return all;
}

bool are_near(const Particles& particles, BodyIndex i, BodyIndex j) {
  const Vec2 way = particles.body(j).position - particles.body(i).position;
  return way.lpNorm<Eigen::Infinity>() <= 0.6 * near;  // and still are when they have moved
}

// A strain and a shift of all [1, m], and something of its own for each.
void move_all(Particles& particles, const Vec2& strain, const Vec2& shift, Random& random) {
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    Body& body = particles.body(i);
    body.position += componentwise_product(strain, body.position) + shift;
    body.position += Vec2{random.uniform(-1e-5, 2e-5), random.uniform(-1e-5, 1e-5)};
    body.rotation = body.rotation.turned(random.uniform(-0.0001, 0.0002));
    particles.update_ring(i);
  }
}

// Only the one in the middle is not at an end.
Particles row_of_three() {
  Particles particles(1, 1);
  for (const Vec2& at : {Vec2{-1, 2}, Vec2{0, 0}, Vec2{1, -2}})
    particles.add(ConvexPolygon{at, at + Vec2{0.1, 0}, at + Vec2{0, 0.1}}, Motion::free);
  return particles;
}

}  // namespace

TEST_CASE("vertices of near bodies never come nearer between two times than the bound has grown") {
  Random random(1);
  for (const double stride : {0.0, 0.0004, 1.0}) {
    int judged = 0;
    for (const double rate : {0.0, 1e-4, -3e-4}) {
      CAPTURE(stride);
      CAPTURE(rate);
      Particles particles = crowd(random);
      DisplacementBound<UnboundedDomain> bound;
      bound.restart(particles, {});
      // Each time of the past with the bound that something then 0.002 apart was given.
      struct Past {
        std::vector<Vertex> vertices;
        double closed;
      };
      std::vector<Past> pasts;
      for (int step = 0; step < 60; ++step) {
        // Strain that begins, turns round and ends: the flow is not always foreseen.
        const double now = step < 5 || step > 50 ? 0 : step % 25 < 20 ? rate : -rate;
        move_all(particles, {now, -2 * now}, {rate, -rate}, random);
        bound.update(particles, {}, stride, near, 1);
        const std::vector<Vertex> all = vertices(particles);
        for (const Past& past : pasts) {
          if (bound.value() >= past.closed) continue;
          ++judged;
          double farthest = 0;
          for (std::size_t k = 0; k < all.size(); ++k)
            for (std::size_t l = 0; l < k; ++l) {
              if (!are_near(particles, all[k].body, all[l].body)) continue;
              const Vec2 apart = all[k].place - all[l].place;
              const Vec2 before = past.vertices[k].place - past.vertices[l].place;
              farthest = std::max(farthest, (apart - before).norm());
            }
          REQUIRE(farthest <= 0.002);
        }
        if (step % 4 == 0) pasts.push_back({all, bound.contact_threshold(0.002)});
      }
    }
    CHECK(judged > 100);  // the bound is of use
  }
}

TEST_CASE(
    "a sample that shrinks as a whole has a bound of the way of neighbours, not of its ends") {
  for (const double extent : {1.0, 100.0})
    for (const double stride : {1.0, 5e-5}) {
      CAPTURE(extent);
      CAPTURE(stride);
      Particles particles(1, 1);
      for (int i = 0; i < 11; ++i) {
        const Vec2 at{0.1 * i * extent - 3, 5 - 0.1 * i * extent};
        particles.add(ConvexPolygon{at, at + Vec2{0.1, 0}, at + Vec2{0, 0.1}}, Motion::free);
      }
      DisplacementBound<UnboundedDomain> bound;
      bound.restart(particles, {});
      constexpr double strain = 1e-5;
      double before = 0;
      constexpr int steps = 100;
      for (int step = 0; step < steps; ++step) {
        for (BodyIndex i = 0; i < particles.size(); ++i)
          particles.body(i).position -= strain * particles.body(i).position;
        bound.update(particles, {}, stride, near, 1);
        if (step == 9) before = bound.value();  // the first way was not foreseen
      }
      // Half of what the strain along both axes takes of `near`. A strain of 1e-3 in all does not
      // grow quite evenly: what is foreseen for a step misses the square of its strain, 1e-10 of
      // the ends' 100 m.
      const double expected = 0.5 * near * std::sqrt(2.0) * strain * (steps - 10);
      CHECK(bound.value() - before == near_relative(expected, 0.02));
    }
}

TEST_CASE("motion recorded by the task that moves a body equals motion measured later") {
  constexpr std::size_t count = task_size + 10;  // two tasks
  // Which tasks are followed: none, the one of the farther way, the other, both.
  for (const unsigned followed : {0U, 1U, 2U, 3U}) {
    Particles particles(1, 1);
    for (std::size_t i = 0; i < count; ++i) particles.add({{0, 0}, {1, 0}, {0, 1}}, Motion::free);
    const auto move = [&](BodyIndex i, double way) { particles.body(i).position += Vec2{way, 0}; };
    DisplacementBound<UnboundedDomain> bound;
    bound.restart(particles, {});
    for (int step = 1; step <= 2; ++step) {
      move(3, 0.01);
      move(count - 1, 0.002);
      if (followed & 1U) bound.record_motion(particles, 0, 0, task_size);
      if (followed & 2U) bound.record_motion(particles, 1, task_size, count);
      bound.update(particles, {}, 1, 0, 1);
      CHECK(bound.value() == near_relative(std::sqrt(2.0) * 0.01 * step, 1e-12));
    }
  }
}

TEST_CASE("no bodies, no displacement") {
  const Particles particles(1, 1);
  DisplacementBound<UnboundedDomain> bound;
  bound.restart(particles, {});
  bound.update(particles, {}, 0.035, near, 1);
  CHECK(bound.value() == 0);
}

TEST_CASE("one body of several that goes straight on has a bound of its way, times root two") {
  Particles particles = row_of_three();
  DisplacementBound<UnboundedDomain> bound;
  bound.restart(particles, {});
  for (int step = 0; step < 100; ++step) {
    particles.body(1).position.x() += 0.01;
    bound.update(particles, {}, 0.035, near, 1);
  }
  CHECK(std::abs(bound.value() - std::sqrt(2)) <= 1e-13);  // round-off of a hundred sums
}

TEST_CASE("the bound of a body that swings to and fro is that of one swing") {
  Particles particles = row_of_three();
  DisplacementBound<UnboundedDomain> bound;
  bound.restart(particles, {});
  for (int step = 0; step < 100; ++step) {
    particles.body(1).position.x() += step % 2 == 0 ? 0.01 : -0.01;
    bound.update(particles, {}, 0.035, near, 1);
    CHECK(bound.value() <= 0.0142);
  }
}

TEST_CASE("images count as ways of both bodies where the cell does not shrink as it did before") {
  Particles particles(1, 1);
  particles.add({{0, 0}, {0.1, 0}, {0, 0.1}}, Motion::free);
  particles.body(0).position = {0, 0};
  DisplacementBound<PeriodicDomain> bound;
  bound.restart(particles, {.period = {1, 2}});
  // Three periods off, an image comes nearer by three times what one period has lost.
  bound.update(particles, {.period = {0.99, 2}}, 1, 0, 3);
  CHECK(std::abs(bound.value() - 0.5 * 3 * 0.01) <= 1e-15);
  // As much again is foreseen: the image is where the flow carries it, and near bodies come nearer
  // by 2 % of what they are apart.
  bound.update(particles, {.period = {0.98, 2}}, 1, 0.25, 3);
  CHECK(std::abs(bound.value() - 0.5 * 0.25 * 0.02) <= 1e-15);
}

TEST_CASE("a sample that is sheared as a whole has a bound of the way of neighbours") {
  Particles particles(1, 1);
  for (int i = 0; i < 11; ++i) {
    const Vec2 at{0.1 * i, 20.0 * i};
    particles.add(ConvexPolygon{at, at + Vec2{0.1, 0}, at + Vec2{0, 0.1}}, Motion::free);
  }
  PeriodicDomain domain{.period = {1, 2}, .shear_offset = 0.3};
  DisplacementBound<PeriodicDomain> bound;
  bound.restart(particles, domain);
  constexpr double strain = 1e-5;
  constexpr int steps = 100;
  double before = 0;
  for (int step = 0; step < steps; ++step) {
    for (BodyIndex i = 0; i < particles.size(); ++i)
      particles.body(i).position.x() += strain * particles.body(i).position.y();
    domain.shear_offset += strain * domain.period.y();
    bound.update(particles, domain, 1.0, near, 3);
    if (step == 9) before = bound.value();  // the first way was not foreseen
  }
  // Half of what the strain takes of `near`; round-off of 200 m is 3e-14 m.
  CHECK(std::abs(bound.value() - before - 0.5 * near * strain * (steps - 10)) <= 1e-12);
}

TEST_CASE("the bound goes on with the pieces of a body as with the body") {
  Particles particles(1, 2500);
  const auto add = [&](double x) { particles.add(rectangle({x, 0}, 2, 1), Motion::free); };
  for (const double x : {-10.0, 0.0, 10.0}) add(x);  // the outer two stay
  DisplacementBound<UnboundedDomain> bound;
  bound.restart(particles, {});
  const auto value = [&] {
    bound.update(particles, {}, 1, 1, 1);
    return bound.value();
  };
  const Vec2 corner = particles.ring(1)[0];
  particles.body(1).position += Vec2{0.03, 0.01};
  particles.body(1).rotation = Rotation::from_angle(0.05);
  particles.update_ring(1);
  (void)value();  // the gradient is known from here on
  const double whole = value();
  CHECK(whole >= (particles.ring(1)[0] - corner).norm());

  const Body before = particles.body(1);
  const Ancestry ancestry = particles.ancestry(1);
  const auto piece = [&](double x) {
    return rectangle({x, 0}, 1, 1).moved(before.rotation, before.position);
  };
  particles.replace(1, piece(-0.5), Motion::free, ancestry);
  particles.add(piece(0.5), Motion::free, &ancestry);
  bound.divide(particles, before, 1, 3);
  CHECK(bound.bodies() == 4);
  // Centroids of the pieces move otherwise than that of the whole, corners do not.
  const double pieces = value();
  double moved = 0;
  for (const BodyIndex i : {1U, 3U})
    for (const Vec2& now : particles.ring(i)) {
      const Vec2 then = before.rotation.inverse_times(now - before.position);
      moved = std::max(moved, (now - then).norm());
    }
  CHECK(pieces >= moved);
  CHECK(pieces <= 2 * moved);
  // A piece that moves on alone.
  particles.body(3).position += Vec2{0.2, 0};
  particles.update_ring(3);
  (void)value();
  CHECK(value() >= 0.2);
}
