// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sets up a simulation: checks its input and adds the particles of the assembly.

#include <cstddef>
#include <string>

#include <riprap/bond/bond_law/no_bonds.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/dynamics/boundary/domain_of.hpp>
#include <riprap/material/rocks.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/body_settings.hpp>

namespace riprap {

namespace internal {

/// A policy with parameters for each material has them for all rocks.
template <class P>
void require_all_materials(const char* role, const P& policy, const Rocks& rocks) {
  if constexpr (requires { policy.materials(); })
    if (const std::size_t count = policy.materials(); count != 0)
      require(count == rocks.size(), std::string(role) + ": number of materials",
              static_cast<double>(count),
              "must be that of the rocks, " + std::to_string(rocks.size()));
}

}  // namespace internal

/// The model, if it, the assembly and the rocks break no rule; else throws InvalidInput.
template <class ModelType>
[[nodiscard]] ModelType validated(ModelType model, const Assembly& assembly, const Rocks& rocks) {
  using BoundaryType = decltype(ModelType::motion_model.boundary);
  model.validate();
  assembly.validate();
  rocks.validate();
  internal::require_all_materials("contact law", model.contact_model.law, rocks);
  internal::require_all_materials("bond law", model.contact_model.bond_law, rocks);
  internal::require_all_materials("criterion", model.breakage_model.criterion, rocks);
  for (std::size_t i = 0; i < assembly.particles.size(); ++i)
    require_material(static_cast<ParticleId>(i), assembly.particles[i].material, rocks.size());
  if (assembly.particles.empty()) throw InvalidInput("Assembly.particles is empty");
  if (!PeriodicBoundary<BoundaryType> && assembly.period != Vec2{0, 0})
    throw InvalidInput("Assembly.period is set: give the model a PeriodicCell as its boundary");
  if (!makes_bonds<decltype(ModelType::contact_model.bond_law)> && !assembly.bonds.empty())
    throw InvalidInput("Assembly.bonds is not empty: give the model a bond_law");
  return model;
}

/// Adds the particles of an assembly. Returns the mean area of its grains [m^2]; walls and
/// prescribed bodies are none. That of the first body where there is no grain.
inline double add_particles(const Assembly& assembly, Particles& particles) {
  double area = 0;
  std::size_t grains = 0;
  for (const PlacedParticle& placed : assembly.particles) {
    const BodyIndex i = particles.add(placed.polygon, placed.motion, nullptr, placed.material);
    Body& body = particles.body(i);
    body.velocity = placed.velocity;
    body.angular_velocity = placed.angular_velocity;
    if (body.is_wall() || body.motion == Motion::prescribed) continue;
    area += particles.shape(i).area;
    ++grains;
  }
  return grains == 0 ? particles.shape(0).area : area / static_cast<double>(grains);
}

}  // namespace riprap
