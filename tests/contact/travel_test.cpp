#include <riprap/contact/travel.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

Particles crowd(Random& random) {
  Particles particles(1, 1);
  for (int i = 0; i < 8; ++i)
    particles.add(random_polygon({}, 0.1, random).moved({}, {0.2 * i, 0}), Motion::free);
  return particles;
}

std::vector<Vec2> vertices(const Particles& particles) {
  std::vector<Vec2> all;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    all.insert(all.end(), particles.ring(i).begin(), particles.ring(i).end());
  return all;
}

}  // namespace

TEST_CASE("no vertex ever moves farther between two times than the bound has grown") {
  Random random(1);
  for (const double stride : {0.0, 0.004, 1.0}) {
    Particles particles = crowd(random);
    Travel<OpenPlane> travel;
    travel.restart(particles, {});
    // Each time of the past with the bound that something then 0.01 apart was given.
    struct Past {
      std::vector<Vec2> vertices;
      double closed;
    };
    std::vector<Past> pasts;
    int judged = 0;
    for (int step = 0; step < 60; ++step) {
      for (BodyIndex i = 0; i < particles.size(); ++i) {
        Body& body = particles.body(i);
        body.position += Vec2{random.uniform(-1e-4, 2e-4), random.uniform(-1e-4, 1e-4)};
        body.rotation = body.rotation.turned(random.uniform(-0.001, 0.002));
        particles.update_ring(i);
      }
      travel.update(particles, {}, stride, 1);
      const std::vector<Vec2> now = vertices(particles);
      for (const Past& past : pasts) {
        if (travel.so_far() >= past.closed) continue;
        ++judged;
        for (std::size_t k = 0; k < now.size(); ++k)
          REQUIRE((now[k] - past.vertices[k]).norm() <= 0.5 * 0.01);
      }
      pasts.push_back({now, travel.until_closed(0.01)});
    }
    CHECK(judged > 30);  // the bound is of use
  }
}

TEST_CASE("who is followed by those who move it has gone as far as who is measured later") {
  Particles particles(1, 1);
  constexpr std::size_t count = task_size + 10;  // two tasks
  for (std::size_t i = 0; i < count; ++i) particles.add({{0, 0}, {1, 0}, {0, 1}}, Motion::free);
  const auto move = [&](BodyIndex i, double way) { particles.body(i).position += Vec2{way, 0}; };
  // Which tasks are followed: none, the one of the farther way, the other, both.
  for (const unsigned followed : {0U, 1U, 2U, 3U}) {
    Travel<OpenPlane> travel;
    travel.restart(particles, {});
    for (int step = 1; step <= 2; ++step) {
      move(3, 0.01);
      move(count - 1, 0.002);
      if (followed & 1U) travel.follow(particles, 0, 0, task_size);
      if (followed & 2U) travel.follow(particles, 1, task_size, count);
      travel.update(particles, {}, 1, 1);
      CHECK(travel.so_far() == near_relative(std::sqrt(2.0) * 0.01 * step, 1e-12));
    }
  }
}

TEST_CASE("nobody has gone nowhere") {
  const Particles particles(1, 1);
  Travel<OpenPlane> travel;
  travel.restart(particles, {});
  travel.update(particles, {}, 0.035, 1);
  CHECK(travel.so_far() == 0);
}

TEST_CASE("one body that goes straight on has a bound of its way, times root two") {
  Particles particles(1, 1);
  particles.add({{0, 0}, {1, 0}, {0, 1}}, Motion::free);
  Travel<OpenPlane> travel;
  travel.restart(particles, {});
  for (int step = 0; step < 100; ++step) {
    particles.body(0).position.x() += 0.01;
    travel.update(particles, {}, 0.035, 1);
  }
  CHECK(std::abs(travel.so_far() - std::sqrt(2)) <= 1e-13);  // round-off of a hundred sums
}

TEST_CASE("a body that trembles adds nothing up") {
  Particles particles(1, 1);
  particles.add({{0, 0}, {1, 0}, {0, 1}}, Motion::free);
  Travel<OpenPlane> travel;
  travel.restart(particles, {});
  for (int step = 0; step < 100; ++step) {
    particles.body(0).position.x() += step % 2 == 0 ? 0.01 : -0.01;
    travel.update(particles, {}, 0.035, 1);
    CHECK(travel.so_far() <= 0.0142);
  }
}

TEST_CASE("images that the cell carries along count as ways of both bodies") {
  Particles particles(1, 1);
  particles.add({{0, 0}, {0.1, 0}, {0, 0.1}}, Motion::free);
  Travel<PeriodicPlane> travel;
  travel.restart(particles, {.period = {1, 2}});
  // Three periods off, an image comes nearer by three times what one period has lost.
  travel.update(particles, {.period = {0.99, 2}}, 1, 3);
  CHECK(std::abs(travel.so_far() - 0.5 * 3 * 0.01) <= 1e-15);
}
