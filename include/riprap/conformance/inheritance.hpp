// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of inheritance.

#include <array>
#include <cmath>
#include <utility>

#include <riprap/breakage/inheritance/concepts.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>

namespace riprap {
namespace internal {

/// A moving disc-like parent and two pieces with its mass, centre of mass and inertia between them.
struct ParticleBreak {
  Body parent;
  std::array<Body, 2> pieces;

  template <Inheritance I>
  void inherit(const I& rule) {
    for (Body& piece : pieces) rule(parent, piece);
  }
  /// Sum over the pieces minus what the parent has, of a number or a vector.
  template <class Quantity>
  [[nodiscard]] auto gain(Quantity&& of) const {
    // Not the expression itself, which would hold dangling references.
    const decltype(of(parent)) sum = of(pieces[0]) + of(pieces[1]) - of(parent);
    return sum;
  }
};

[[nodiscard]] inline ParticleBreak random_break(Random& random) {
  const auto vector = [&random](double reach) {
    return Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
  };
  ParticleBreak one;
  one.parent.position = vector(5);
  one.parent.velocity = vector(2);
  one.parent.angular_velocity = random.uniform(-3, 3);
  const double share = random.uniform(0.2, 0.8);
  const Vec2 apart = vector(1);
  const std::array<double, 2> masses{8 * share, 8 * (1 - share)};
  one.parent.mass = 8;
  for (std::size_t i = 0; i < 2; ++i) {
    Body& piece = one.pieces[i];
    piece.mass = masses[i];
    piece.inertia = 0.5 * masses[i];
    piece.position = one.parent.position + (i == 0 ? masses[1] : -masses[0]) / 8 * apart;
    one.parent.inertia +=
        piece.inertia + piece.mass * (piece.position - one.parent.position).squaredNorm();
  }
  return one;
}

/// A hundred random breaks, each before and after the pieces get their velocities.
template <Inheritance I, class Visit>
void visit_breaks(const I& inherit, Visit&& visit) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const ParticleBreak before = random_break(random);
    ParticleBreak one = before;
    one.inherit(inherit);
    visit(before, one);
  }
}

}  // namespace internal

/// Which axioms an inheritance breaks.
template <Inheritance I>
[[nodiscard]] Violations inheritance_violations(const I& inherit) {
  AxiomCheck check;
  internal::visit_breaks(inherit, [&](const internal::ParticleBreak& before,
                                      const internal::ParticleBreak& one) {
    check.at_most("pieces have no more kinetic energy than their parent: gain [J]",
                  one.gain([](const Body& b) { return b.kinetic_energy(); }),
                  1e-12 * one.parent.kinetic_energy());
    for (std::size_t k = 0; k < 2; ++k) {
      check.equal("a piece stays where it is",
                  (one.pieces[k].position - before.pieces[k].position).norm(), 0, 0);
      check.equal("a piece keeps its mass", one.pieces[k].mass, before.pieces[k].mass, 0);
      check.equal("a piece keeps its inertia", one.pieces[k].inertia, before.pieces[k].inertia, 0);
    }
  });
  return std::move(check).violations();
}

/// For inheritances that neither push nor stop the pieces: momentum is conserved, in whatever frame
/// it is seen from.
template <Inheritance I>
[[nodiscard]] Violations inheritance_momentum_violations(const I& inherit) {
  AxiomCheck check;
  internal::visit_breaks(inherit, [&](const internal::ParticleBreak& before,
                                      const internal::ParticleBreak& one) {
    // Round-off of 8 kg at 5 m and 5 m/s.
    check.equal("the momentum of the pieces is the parent's: difference [N s]",
                one.gain([](const Body& b) -> Vec2 { return b.mass * b.velocity; }).norm(), 0,
                1e-12);
    check.equal("the angular momentum of the pieces is the parent's: difference [N m s]",
                one.gain([](const Body& b) {
                  return b.mass * cross(b.position, b.velocity) + b.inertia * b.angular_velocity;
                }),
                0, 1e-12);
    internal::ParticleBreak faster = before;
    faster.parent.velocity += Vec2{7, -4};
    faster.inherit(inherit);
    for (std::size_t k = 0; k < 2; ++k)
      check.equal("a velocity added to the parent is added to the pieces",
                  (faster.pieces[k].velocity - one.pieces[k].velocity - Vec2{7, -4}).norm(), 0,
                  1e-13);
  });
  return std::move(check).violations();
}

}  // namespace riprap
