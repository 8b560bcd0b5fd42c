// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Fragments: the parts of a bonded sample that live bonds hold together.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <riprap/bond/components.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/measurement/coordination.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/measurement/grading.hpp>
#include <riprap/measurement/rattlers.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Bodies that are joined, directly or through others; one without bonds is a fragment, too.
struct Fragment {
  std::uint32_t number = 0;       ///< as in fragment_numbers
  ParticleId root = no_particle;  ///< of all its bodies
  double area = 0;                ///< [m^2]
  Vec2 centroid{0, 0};            ///< [m]; of the bodies themselves, not of images
  bool is_free = true;            ///< none of its bodies is driven
  std::vector<BodyIndex> bodies;  ///< in rising order
};

/// The number of the fragment of each body, from 0 on, in the order of their lowest bodies.
/// @param bonds a range of objects with bodies `a` and `b`
template <class Bonds>
[[nodiscard]] std::vector<std::uint32_t> fragment_numbers(const Bonds& bonds, std::size_t bodies) {
  Components joined(bodies);
  for (const auto& bond : bonds) joined.join(bond.a, bond.b);
  std::vector<std::uint32_t> numbers(bodies);
  std::uint32_t next = 0;
  for (BodyIndex i = 0; i < bodies; ++i) {
    const BodyIndex lowest = joined.of(i);
    numbers[i] = lowest == i ? next++ : numbers[lowest];
  }
  return numbers;
}
/// Of a simulation; each body on its own in a model without bonds.
template <class Sim>
[[nodiscard]] std::vector<std::uint32_t> fragment_numbers(const Sim& sim) {
  const std::size_t bodies = sim.particles().size();
  if constexpr (has_bonds<Sim>) {
    return fragment_numbers(sim.bonds(), bodies);
  } else {
    std::vector<std::uint32_t> numbers(bodies);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
  }
}

/// Number of fragments, walls and platens included.
template <class Sim>
[[nodiscard]] std::size_t fragment_count(const Sim& sim) {
  if constexpr (!has_bonds<Sim>) {
    return sim.particles().size();
  } else {
    const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
    return numbers.empty() ? 0 : *std::ranges::max_element(numbers) + std::size_t{1};
  }
}

/// The fragments of a simulation, walls and platens left out, in the order of their lowest bodies.
template <class Sim>
[[nodiscard]] std::vector<Fragment> fragments(const Sim& sim) {
  const Particles& particles = sim.particles();
  const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
  std::vector<Fragment> all(numbers.size());
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    const Body& body = particles.body(i);
    if (body.is_wall()) continue;
    Fragment& fragment = all[numbers[i]];
    const double area = particles.shape(i).area;
    fragment.number = numbers[i];
    fragment.root = particles.ancestry(i).root;
    fragment.area += area;
    fragment.centroid += area * body.position;
    fragment.is_free = fragment.is_free && body.is_free();
    fragment.bodies.push_back(i);
  }
  std::erase_if(all, [](const Fragment& fragment) { return fragment.bodies.empty(); });
  for (Fragment& fragment : all) fragment.centroid = fragment.centroid / fragment.area;
  return all;
}

/// As `grading`, with free fragments and dust: clusters are particles of the sample. The grading of
/// the intact clusters is grading_before_breakage, for the cells of a cluster have one root.
template <class Sim>
[[nodiscard]] Grading fragment_grading(const Sim& sim) {
  const Particles& particles = sim.particles();
  std::vector<SizeFraction> fractions;
  const auto mass = [&](MaterialIndex material, double area) {  // over the density of material 0
    return area * particles.density_ratio(material, 0);
  };
  for (const Fragment& fragment : fragments(sim)) {
    if (!fragment.is_free) continue;
    double of_all = 0;
    for (const BodyIndex i : fragment.bodies)
      of_all += mass(particles.material(i), particles.shape(i).area);
    fractions.push_back({equivalent_diameter(fragment.area), of_all});
  }
  for (const DustPiece& piece : particles.dust())
    fractions.push_back({equivalent_diameter(piece.area), mass(piece.material, piece.area)});
  return Grading::of_fractions(std::move(fractions));
}

/// Breakages so far: of particles, and of clusters, where a fragment has come off.
template <class Sim>
[[nodiscard]] std::size_t breakages(const Sim& sim) {
  std::size_t count = sim.breaks().size();
  if constexpr (has_bonds<Sim>)
    for (const auto& event : sim.bond_breaks()) count += event.separates;
  return count;
}

namespace internal {

/// Of each fragment, whether none of its bodies is driven.
/// @param numbers of the fragments of the bodies
[[nodiscard]] inline std::vector<bool> free_fragments(const std::vector<std::uint32_t>& numbers,
                                                      const Particles& particles) {
  std::vector<bool> is_free(numbers.size(), false);
  for (const std::uint32_t number : numbers) is_free[number] = true;
  for (BodyIndex i = 0; i < numbers.size(); ++i)
    if (!particles.body(i).is_free()) is_free[numbers[i]] = false;
  return is_free;
}

}  // namespace internal

/// As `coordination`, of free fragments: one touches another once, with however many of its bodies
/// and, in a small periodic cell, images.
template <class Sim>
[[nodiscard]] Coordination fragment_coordination(const Sim& sim) {
  if constexpr (!has_bonds<Sim>) {
    return coordination(sim.contacts(), sim.particles());
  } else {
    const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
    const std::vector<bool> is_free = internal::free_fragments(numbers, sim.particles());
    std::vector<std::array<std::uint32_t, 2>> pairs;
    sim.contacts().for_each_touching([&](const auto& c) {
      const auto [first, second] = std::minmax(numbers[c.a], numbers[c.b]);
      if (first != second) pairs.push_back({first, second});
    });
    std::ranges::sort(pairs);
    pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
    std::size_t ends = 0;
    for (const auto& pair : pairs)
      for (const std::uint32_t number : pair) ends += is_free[number];
    const auto free = std::ranges::count(is_free, true);
    if (free == 0) return {};
    const double mean = static_cast<double>(ends) / static_cast<double>(free);
    return {0.5 * mean, mean};
  }
}

/// Contacts with a force between two fragments, by the fragments' numbers.
template <class Sim>
[[nodiscard]] std::vector<LoadedContact> loaded_fragment_contacts(const Sim& sim) {
  const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
  std::vector<LoadedContact> out;
  for (const LoadedContact& contact : loaded_contacts(sim.contacts())) {
    const LoadedContact between{numbers[contact[0]], numbers[contact[1]]};
    if (between[0] != between[1]) out.push_back(between);
  }
  return out;
}

/// Of every body, whether its fragment is a rattler among the fragments.
template <class Sim>
[[nodiscard]] std::vector<bool> fragment_rattlers(const Sim& sim, unsigned fewest = 2) {
  const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
  const std::vector<bool> is_free = internal::free_fragments(numbers, sim.particles());
  const std::vector<bool> of_fragments = rattlers(loaded_fragment_contacts(sim), is_free, fewest);
  std::vector<bool> out;
  for (const std::uint32_t number : numbers) out.push_back(of_fragments[number]);
  return out;
}

}  // namespace riprap
