// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The records of a file of frames; their arrays are listed in docs/replay.md.

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/breakage/trigger/load_scale.hpp>
#include <riprap/output/record.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// What a file of frames starts with.
inline constexpr std::string_view frames_signature = "riprap frames 1\n";

namespace internal {

/// Vectors as x, y, x, y, ...
template <class Points>
[[nodiscard]] std::vector<float> coordinates(const Points& points) {
  std::vector<float> out;
  for (const Vec2& p : points) {
    out.push_back(static_cast<float>(p.x()));
    out.push_back(static_cast<float>(p.y()));
  }
  return out;
}

/// One number per index, in single precision.
template <class Value>
[[nodiscard]] std::vector<float> floats(std::size_t count, Value&& value) {
  std::vector<float> out(count);
  for (std::size_t k = 0; k < count; ++k) out[k] = static_cast<float>(value(k));
  return out;
}

}  // namespace internal

/// What does not change in a run: thickness, and RatF where the trigger has one number for it.
template <class Sim>
[[nodiscard]] Record run_record(const Sim& sim) {
  Record record("RUN ");
  record.add("thickness", sim.particles().thickness());
  if constexpr (Sim::breakable)
    if constexpr (requires { double{sim.model().breakage_model.trigger.critical}; })
      record.add("ratf", double{sim.model().breakage_model.trigger.critical});
  return record;
}

/// A particle, with its vertices in its own frame.
[[nodiscard]] inline Record particle_record(const Particles& particles, BodyIndex i) {
  const Ancestry& ancestry = particles.ancestry(i);
  Record record("PART");
  record.add("id", ancestry.id);
  record.add("parent", ancestry.parent);
  record.add("root", ancestry.root);
  record.add("generation", std::uint32_t{ancestry.generation});
  record.add("material", std::uint32_t{particles.material(i)});
  record.add("motion", static_cast<std::uint32_t>(particles.body(i).motion));
  record.add("area", particles.shape(i).area);
  record.add("vertices", internal::coordinates(particles.local_ring(i)));
  return record;
}

/// Poses and contacts now. Rat is 0 where breakage is off.
template <class Sim>
[[nodiscard]] Record frame_record(const Sim& sim) {
  using ContactType = typename Sim::Contacts::ContactType;
  const Particles& particles = sim.particles();
  const auto of_bodies = [&](auto value) {
    return internal::floats(particles.size(),
                            [&](std::size_t i) { return value(particles.bodies()[i]); });
  };
  Record record("FRAM");
  record.add("step", sim.steps());
  record.add("time", sim.time());
  record.add("breaks", static_cast<std::uint32_t>(sim.breaks().size()));
  if constexpr (Sim::Domain::periodic) {
    const auto& cell = sim.contacts().domain();
    record.add("cell", internal::coordinates(std::vector<Vec2>{cell.centre, cell.period}));
  }
  std::vector<std::uint32_t> ids(particles.size());
  for (BodyIndex i = 0; i < particles.size(); ++i) ids[i] = particles.ancestry(i).id;
  record.add("id", ids);
  record.add("x", of_bodies([](const Body& b) { return b.position.x(); }));
  record.add("y", of_bodies([](const Body& b) { return b.position.y(); }));
  record.add("angle", of_bodies([](const Body& b) { return b.rotation.angle(); }));
  record.add("vx", of_bodies([](const Body& b) { return b.velocity.x(); }));
  record.add("vy", of_bodies([](const Body& b) { return b.velocity.y(); }));
  record.add("spin", of_bodies([](const Body& b) { return b.angular_velocity; }));
  std::vector<double> ratios(particles.size(), 0);
  // Before that, no particle has been meshed.
  if (sim.breakage()) ratios = sim.failed_ratios();
  record.add("rat", internal::floats(ratios.size(), [&](std::size_t i) { return ratios[i]; }));

  std::vector<const ContactType*> contacts;
  sim.contacts().for_each_touching([&](const ContactType& c) { contacts.push_back(&c); });
  const auto of_contacts = [&](auto value) {
    return internal::floats(contacts.size(), [&](std::size_t k) { return value(*contacts[k]); });
  };
  std::vector<std::uint32_t> a;
  std::vector<std::uint32_t> b;
  for (const ContactType* c : contacts) {
    a.push_back(ids[c->a]);
    b.push_back(ids[c->b]);
  }
  record.add("a", a);
  record.add("b", b);
  record.add("px", of_contacts([](const ContactType& c) { return c.geometry.point.x(); }));
  record.add("py", of_contacts([](const ContactType& c) { return c.geometry.point.y(); }));
  record.add("normal", of_contacts([](const ContactType& c) { return c.force.normal; }));
  record.add("tangential", of_contacts([](const ContactType& c) { return c.force.tangential; }));
  return record;
}

namespace internal {

// Mesh, stresses and failed elements of particle i; its corners alone where none are evaluated.
template <class Sim>
void add_elements(Record& record, const Sim& sim, BodyIndex i) {
  ElementStress stress;
  std::vector<Vec2> nodes(sim.particles().local_ring(i).begin(),
                          sim.particles().local_ring(i).end());
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> failed;
  // The stress is linear in the loads, which the trigger may scale.
  const auto& breakage = sim.model().breakage_model;
  const double scale = load_scale(breakage.trigger, sim.particles(), i, sim.rock(i));
  if constexpr (Sim::needs_elements) {
    stress = sim.element_stress(i);
    const Mesh mesh = sim.mesh(i);
    const auto& criterion = criterion_of(breakage.criterion, sim.particles().material(i));
    nodes = mesh.nodes;
    for (const auto& t : mesh.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
    for (std::size_t k = 0; k < stress.size(); ++k)
      failed.push_back(evaluate(criterion, scale * stress[k]).failed());
  }
  const auto of_points = [&](auto value) {
    return floats(stress.size(), [&](std::size_t k) { return value(scale * stress[k]); });
  };
  record.add("nodes", coordinates(nodes));
  record.add("triangles", triangles);
  record.add("s11", of_points([](const Stress2& s) { return s.s11; }));
  record.add("s22", of_points([](const Stress2& s) { return s.s22; }));
  record.add("s12", of_points([](const Stress2& s) { return s.s12; }));
  record.add("failed", failed);
}

}  // namespace internal

/// Particle i, which is about to break: pose, mesh, stresses, failed elements and contact forces;
/// corners in place of a mesh where the model evaluates no elements. For the hook before_splits.
template <class Sim>
[[nodiscard]] Record breaking_particle(const Sim& sim, BodyIndex i) {
  const Body& body = sim.particles().body(i);
  std::vector<Vec2> points;
  std::vector<Vec2> forces;
  sim.contacts().for_each_touching([&](const auto& c) {
    if (c.a != i && c.b != i) return;
    // Where the copy of b is met across a periodic cell, the point seen from b itself.
    points.push_back(c.a == i ? c.geometry.point : Vec2(body.position + c.arm_b));
    forces.push_back(c.a == i ? Vec2(-c.force_on_b()) : c.force_on_b());
  });

  Record record("BREK");
  record.add("pose", std::vector<float>{static_cast<float>(body.position.x()),
                                        static_cast<float>(body.position.y()),
                                        static_cast<float>(body.rotation.angle())});
  internal::add_elements(record, sim, i);
  record.add("points", internal::coordinates(points));
  record.add("forces", internal::coordinates(forces));
  return record;
}

/// Adds what the break made of the particle.
inline void add_event(Record& record, const BreakEvent& event) {
  record.add("step", event.step);
  record.add("time", event.time);
  record.add("id", event.particle.id);
  record.add("pieces", std::vector<std::uint32_t>{event.pieces[0], event.pieces[1]});
  record.add("areas", std::vector<double>{event.areas[0], event.areas[1]});
  record.add("line",
             internal::coordinates(std::vector<Vec2>{event.line.point, event.line.direction}));
  record.add("rat", event.failures.ratio());
  record.add("mode", static_cast<std::uint32_t>(event.mode));
}

}  // namespace riprap
