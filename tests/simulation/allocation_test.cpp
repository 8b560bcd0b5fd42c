// SPDX-License-Identifier: BSL-1.0
// A warm step does not touch the allocator. Counts every allocation of this executable.

#include <doctest/doctest.h>

#include <cstdlib>
#include <new>

#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/breakage/trigger/tsoungui_strength.hpp>
#include <riprap/breakage/trigger/with_weibull_strength.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/rectangle.hpp>

namespace {

std::size_t allocations = 0;  // of this thread, the only one

void* counted(std::size_t size) noexcept {
  ++allocations;
  return std::malloc(size);
}

void* counted_or_throw(std::size_t size) {
  if (void* memory = counted(size)) return memory;
  throw std::bad_alloc();
}

void* counted_or_throw(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto to = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(to, (size + to - 1) / to * to)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// All of them: a sanitizer's own form of new would not go with a delete from here.
void* operator new(std::size_t size) { return counted_or_throw(size); }
void* operator new[](std::size_t size) { return counted_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new(std::size_t size, std::align_val_t to) { return counted_or_throw(size, to); }
void* operator new[](std::size_t size, std::align_val_t to) { return counted_or_throw(size, to); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace riprap;

TEST_CASE("a thousand warm steps allocate nothing, rebuilds of the neighbour list included") {
  Simulation sim{Model{}, random_assembly({.count = 200, .seed = 5}), Rock{}};
  sim.set_breakage(false);
  // Loose bodies that are pushed together get new neighbours all the time.
  sim.boundary().set_rate(2, 2);
  const auto pairs = [&] { return sim.contacts().pairs().size(); };
  std::size_t most_pairs = 0;
  for (int k = 0; k < 20'000 && most_pairs < 500; ++k) {
    sim.step();
    most_pairs = std::max(most_pairs, pairs());
  }
  // Back, and at it again: all lists have had their longest.
  sim.boundary().set_rate(-2, -2);
  for (int k = 0; k < 2000; ++k) sim.step();
  const std::size_t before = allocations;
  const std::size_t pairs_before = pairs();
  for (int k = 0; k < 1000; ++k) sim.step();
  CHECK(allocations == before);
  CHECK(pairs() != pairs_before);  // there were new lists
}

TEST_CASE("a thousand warm checks by the contact loads allocate nothing") {
  const WithWeibullStrength<TsounguiStrength> trigger{.trigger = {1e15}};
  Simulation sim{Model{}.trigger(trigger).line_fit(MeanStressLine{}),
                 random_assembly({.count = 200, .seed = 5}), Rock{}};
  sim.boundary().set_rate(2, 2);
  for (int k = 0; k < 20'000 && sim.contacts().pairs().size() < 500; ++k) sim.step();
  sim.boundary().set_rate(-2, -2);
  for (int k = 0; k < 2000; ++k) sim.step();
  const std::size_t before = allocations;
  for (int k = 0; k < 1000; ++k) sim.step();
  CHECK(allocations == before);
}

TEST_CASE("a thousand warm steps of bonded particles allocate nothing") {
  Assembly assembly{.thickness = 0.016, .particles = {}};
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 15; ++j)
      assembly.particles.push_back({test::rectangle({0.01 * i, 0.01 * j}, 0.01, 0.01),
                                    Motion::free,
                                    {0.1 * (i % 3), 0.1 * (j % 2)}});
  bond_common_edges(assembly);
  Simulation sim{Model{}.boundary(NoBoundary{}).bond_law(SofteningBond{}).criterion(NeverFails{}),
                 assembly, Rock{}};
  for (int k = 0; k < 1000; ++k) sim.step();
  const std::size_t before = allocations;
  for (int k = 0; k < 1000; ++k) sim.step();
  CHECK(allocations == before);
  CHECK(sim.bonds().stored_energy(0.016) > 0);
}

TEST_CASE("a split costs less than twenty allocations, an operator less than a thousand") {
  Simulation sim{Model{}, random_assembly({.count = 200, .seed = 5}), Rock{}};
  sim.boundary().set_rate(10, 10);
  int alone = 0;
  for (int k = 0; k < 20'000 && sim.breaks().size() < 20; ++k) {
    const std::size_t before = allocations;
    const std::size_t breaks = sim.breaks().size();
    sim.step();
    const std::size_t splits = sim.breaks().size() - breaks;
    // In the same step operators may be built, for the particle that breaks or for others.
    alone += splits > 0 && allocations - before < 20 * splits;
  }
  CHECK(alone >= 5);

  // No particle has an operator before the first check. A mesh tries spacings until one gives the
  // requested number of triangles, so that some take more than others.
  const Simulation unchecked{Model{}, random_assembly({.count = 200, .seed = 5}), Rock{}};
  std::size_t least = 10'000;
  for (BodyIndex i = 0; i < 10; ++i) {
    const std::size_t before = allocations;
    (void)unchecked.mesh(i);
    least = std::min(least, allocations - before);
  }
  CHECK(least < 1000);
}
