// SPDX-License-Identifier: BSL-1.0
// curve [L1]: short biaxial tests with breakage under each of the three boundaries, whose tables
// must be the same to the last byte whatever the compiler, the level of optimisation and the
// processor. With L1 [kB], Eigen takes the first-level cache to be of that size, as on another
// processor.
//
// A change that is meant to change results changes the hash below as well. Put in the new one,
// which this program prints, once .ci/determinism prints the same one for both compilers. Any other
// change that leads here is a mistake.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <riprap/riprap.hpp>

using namespace riprap;

namespace {

constexpr std::uint64_t expected = 0xCD92AB7CF64EF00Full;

// FNV-1a (Fowler, Noll and Vo) of 64 bits.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ull;
  return hash;
}

Curve sheared(const auto& boundary, const Assembly& assembly, double pressure) {
  Simulation sim{Model{}.boundary(boundary), assembly, Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = pressure, .axial_strain = 0.02}.run(sim, curve);
  return curve;
}

std::string tables(const Curve& curve) {
  return curve_csv(curve) + energy_csv(curve) + breakages_csv(curve);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kB = 1024;
  if (argc > 1) Eigen::setCpuCacheSizes(std::atoi(argv[1]) * kB, 1024 * kB, 16 * 1024 * kB);

  const Assembly many = random_assembly({.count = 150, .seed = 1});
  const RandomAssembly few{.count = 60, .seed = 3};
  const Curve ring = sheared(StrainField{}, many, 8e6);
  // Few particles, so a higher pressure for some of them to break.
  const Curve platens = sheared(RigidPlatens{}, random_platen_assembly(few), 20e6);
  const Curve cell = sheared(PeriodicCell{}, random_periodic_assembly(few), 16e6);
  const std::string text = tables(ring) + tables(platens) + tables(cell);
  const std::uint64_t hash = hash_of(text);

  std::fputs(text.c_str(), stdout);
  std::printf("hash 0x%016llX\n", static_cast<unsigned long long>(hash));
  if (std::min({ring.breaks().size(), platens.breaks().size(), cell.breaks().size()}) < 2) {
    std::puts("too few particles broke for the hash to speak for breakage");
    return 1;
  }
  if (hash != expected) {
    std::printf("expected 0x%016llX. See the top of tests/determinism/curve.cpp.\n",
                static_cast<unsigned long long>(expected));
    return 1;
  }
}
