// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Bonds for ParaView: the live ones, and those that have broken.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <riprap/bond/bond.hpp>
#include <riprap/output/vtp.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/bond_break.hpp>

namespace riprap {

/// The edge of a broken bond now, on the first of its particles [m]; none if that has broken since
/// or was removed.
[[nodiscard]] inline std::optional<std::array<Vec2, 2>> edge_now(const BondBreak& broken,
                                                                 const Particles& particles) {
  const auto i = particles.find(broken.particles[0]);
  if (!i) return std::nullopt;
  const Body& body = particles.body(*i);
  return std::array{body.position + body.rotation * broken.ends[0],
                    body.position + body.rotation * broken.ends[1]};
}

/// Bonds as lines along their edges, the live ones first. Arrays: `live` (1 or 0); `failure` (0:
/// none, 1: tension, 2: shear); `a` and `b`, the ids of the two particles (-1: dust); `normal` and
/// `tangential`, mean traction on b [Pa], pushing positive, 0 for broken ones; `energy` [J], stored
/// or, when the bond broke, lost.
template <class Sim>
[[nodiscard]] VtpFile bonds_vtp(const Sim& sim) {
  struct Drawn {
    bool live = false;
    BondFailure failure = BondFailure::none;
    std::array<ParticleId, 2> ids{no_particle, no_particle};
    double normal = 0;
    double tangential = 0;
    double energy = 0;
  };
  const Particles& particles = sim.particles();
  VtpFile file(VtpCells::lines);
  std::vector<Drawn> lines;
  for (const auto& bond : sim.bonds()) {
    file.add_cell(bond.ends(particles.body(bond.a)));
    const auto& [p, q] = bond.tractions;
    lines.push_back({true,
                     BondFailure::none,
                     {particles.ancestry(bond.a).id, particles.ancestry(bond.b).id},
                     0.5 * (p.normal + q.normal),
                     0.5 * (p.tangential + q.tangential),
                     stored_energy(bond, sim.bonds().law(), particles.thickness())});
  }
  for (const BondBreak& broken : sim.bond_breaks()) {
    const auto edge = edge_now(broken, particles);
    if (!edge) continue;
    file.add_cell(*edge);
    lines.push_back({false, broken.failure, broken.particles, 0, 0, broken.energy});
  }
  const auto add = [&](const char* name, auto value) {
    file.add_values(name, [&](std::size_t k) { return value(lines[k]); });
  };
  const auto number = [](ParticleId id) {
    return id == no_particle ? std::int64_t{-1} : std::int64_t{id};
  };
  add("live", [](const Drawn& line) { return static_cast<int>(line.live); });
  add("failure", [](const Drawn& line) { return static_cast<int>(line.failure); });
  add("a", [&](const Drawn& line) { return number(line.ids[0]); });
  add("b", [&](const Drawn& line) { return number(line.ids[1]); });
  add("normal", [](const Drawn& line) { return line.normal; });
  add("tangential", [](const Drawn& line) { return line.tangential; });
  add("energy", [](const Drawn& line) { return line.energy; });
  return file;
}

}  // namespace riprap
