// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/execution/threads.hpp>

#include <doctest/doctest.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

using namespace riprap;

TEST_CASE("every task is done once, by however many threads") {
  for (const int count : {1, 2, 5}) {
    std::vector<int> done(1000, 0);
    Threads{count}.run(done.size(), [&](std::size_t k) { ++done[k]; });
    CHECK(done == std::vector<int>(1000, 1));
  }
}

TEST_CASE("of several exceptions that of the first task comes out, when all tasks are done") {
  std::vector<int> done(100, 0);
  const auto work = [&](std::size_t k) {
    ++done[k];
    if (k % 10 == 7) throw std::runtime_error(std::to_string(k));
  };
  CHECK_THROWS_WITH_AS(Threads{3}.run(done.size(), work), "7", std::runtime_error);
  CHECK(done == std::vector<int>(100, 1));
}

TEST_CASE("for a single task no other thread is used") {
  int team = 0;
  Threads{5}.run(1, [&](std::size_t) { team = omp_get_num_threads(); });
  CHECK(team == 1);
}

TEST_CASE("a number of threads below one is an error") {
  CHECK_THROWS_WITH_AS(
      Simulation(Model{}.execution(Threads{0}), random_assembly({.count = 50}), Rock{}),
      "Threads.count = 0: must be 1 or more", InvalidInput);
}

namespace {

// Everything that a particle is, byte by byte.
template <class Execution>
std::string state_after_crushing(Execution execution) {
  // More than one task, so that bodies have contacts in other tasks than their own; weak particles.
  Simulation sim{Model{}.execution(execution).trigger(FailedElementRatio{.critical = 0.1}),
                 random_assembly({.count = 300, .seed = 3}), Rock{}};
  BiaxialTest{.confining_pressure = 14e6, .axial_strain = 0.003, .rest_unbalanced_force = 0.1}.run(
      sim);
  REQUIRE(sim.breaks().size() > 3);
  std::string bytes;
  for (const Body& body : sim.particles().bodies()) {
    char copy[sizeof(Vec2) + sizeof(Rotation) + sizeof(double)];
    std::memcpy(copy, &body.position, sizeof(Vec2));
    std::memcpy(copy + sizeof(Vec2), &body.rotation, sizeof(Rotation));
    std::memcpy(copy + sizeof(Vec2) + sizeof(Rotation), &body.angular_velocity, sizeof(double));
    bytes.append(copy, sizeof copy);
  }
  for (const double work :
       {sim.work().boundary, sim.work().damping, sim.contacts().friction_loss()})
    bytes.append(reinterpret_cast<const char*>(&work), sizeof work);
  return bytes;
}

}  // namespace

TEST_CASE("a sample that is crushed ends in the same bytes whatever the number of threads") {
  const std::string serial = state_after_crushing(Serial{});
  CHECK(state_after_crushing(Threads{1}) == serial);
  CHECK(state_after_crushing(Threads{2}) == serial);
  CHECK(state_after_crushing(Threads{3}) == serial);
}
