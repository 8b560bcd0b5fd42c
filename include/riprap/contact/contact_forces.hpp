// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From contact geometry and motion to contact forces on the bodies.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/task_partition.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// From b to the image of b in contact with a [m].
template <class ContactType, class Domain>
[[nodiscard]] Vec2 image_offset(const ContactType& contact, const Domain& domain) {
  if constexpr (Domain::periodic)
    if (contact.crosses_boundary) return domain.offset(contact.image);
  return {0, 0};
}

/// Velocity of b's image relative to a at their contact [m/s].
template <class ContactType, class Domain>
[[nodiscard, gnu::always_inline]] inline Vec2
relative_velocity(const ContactType& contact, const Particles& particles, const Domain& domain) {
  const Vec2 b = particles.body(contact.b).velocity_at(contact.arm_b);
  const Vec2 a = particles.body(contact.a).velocity_at(contact.arm_a);
  Vec2 relative{b.x() - a.x(), b.y() - a.y()};
  if constexpr (Domain::periodic)
    if (contact.crosses_boundary) relative += domain.velocity(contact.image);
  return relative;
}

/// Harmonic mean of the scaled masses, halved; that of the free one of the two [kg].
[[nodiscard]] inline double effective_mass(const Body& a, const Body& b) {
  if (!a.is_free()) return b.mass_scaling * b.mass;
  if (!b.is_free()) return a.mass_scaling * a.mass;
  const double p = a.mass_scaling * a.mass;
  const double q = b.mass_scaling * b.mass;
  return p * q / (p + q);
}

/// Lever arms of a contact from the centroids of its bodies; platens have none.
template <class ContactType, class Domain>
[[gnu::always_inline]] inline void find_arms(ContactType& contact, const Body& a, const Body& b,
                                             const Domain& domain) {
  const Vec2& at_a = contact.geometry.point;
  const Vec2 at_b = contact.geometry.point - image_offset(contact, domain);
  // Written as vectors: they are read as vectors soon after, and reading two scalar stores as one
  // vector would defeat store forwarding.
  contact.arm_a = at_a.array() - a.position.array();
  contact.arm_b = at_b.array() - b.position.array();
  if (contact.at_platen) (a.motion == Motion::platen ? contact.arm_a : contact.arm_b) = {0, 0};
}

/// The force of a touching pair at the present poses. Books it in the pair; returns what it loses.
/// Inlined into the loop over all contacts although breaks call it, too; a step is slower
/// otherwise.
/// @param time_step [s] of the motion that led here
template <class ContactType, class Law, class Domain>
[[gnu::always_inline]] inline ContactForce find_force(ContactType& contact,
                                                      const Particles& particles, const Law& law,
                                                      const Domain& domain, double time_step) {
  const Body& a = particles.body(contact.a);
  const Body& b = particles.body(contact.b);
  find_arms(contact, a, b, domain);
  const Vec2& n = contact.geometry.normal;
  const Vec2 relative = relative_velocity(contact, particles, domain);
  const double along = relative.y() * n.x() - relative.x() * n.y();
  const ContactMotion motion{.normal_velocity = relative.x() * n.x() + relative.y() * n.y(),
                             .tangential_velocity = contact.at_platen ? 0 : along,
                             .time_step = time_step,
                             .effective_mass = effective_mass(a, b),
                             .material_a = particles.material(contact.a),
                             .material_b = particles.material(contact.b)};
  const ContactForce force = law(contact.geometry, motion, contact.history);
  contact.force = {force.normal, force.tangential};
  return force;
}

/// Energy that contacts have dissipated [J].
struct ContactLosses {
  ExactSum friction;
  ExactSum viscous;

  void add(const ContactForce& force) {
    friction.add(force.friction_loss);
    viscous.add(force.viscous_loss);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("friction", self.friction);
    visit("viscous", self.viscous);
  }
};

/// Collects the losses that are not zero, without a branch: few contacts slide, unpredictably.
class LossBuffer {
 public:
  explicit LossBuffer(ExactSum& sum) : sum_(sum) {}
  LossBuffer(const LossBuffer&) = delete;
  LossBuffer& operator=(const LossBuffer&) = delete;
  ~LossBuffer() { flush(); }

  void add(double loss) {
    losses_[count_] = loss;
    count_ += static_cast<std::size_t>(loss != 0);
    if (count_ == losses_.size()) flush();
  }

 private:
  void flush() {
    for (std::size_t k = 0; k < count_; ++k) sum_.add(losses_[k]);
    count_ = 0;
  }

  ExactSum& sum_;
  std::array<double, 64> losses_;
  std::size_t count_ = 0;
};

/// Forces of the touching pairs of a task, added to the wrenches of bodies a, and of bodies b below
/// `end_body`: all of them, if tasks run in order; else its own, and `sum_forces` follows for its
/// `shared_bodies` when all tasks have ended. Both are sums in the order of the pairs.
/// @param time_step [s] of the motion that led here
/// @param losses what the pairs lose is added
template <class ContactType, class Law, class Domain>
void find_forces(ContactTask& task, std::span<ContactType> pairs, Particles& particles,
                 const Law& law, const Domain& domain, double time_step, std::size_t end_body,
                 ContactLosses& losses) {
  double largest_overlap = 0;
  LossBuffer friction(losses.friction);
  LossBuffer viscous(losses.viscous);
  for (const std::uint32_t k : task.touching) {
    ContactType& contact = pairs[k];
    const ContactForce force = find_force(contact, particles, law, domain, time_step);
    friction.add(force.friction_loss);
    viscous.add(force.viscous_loss);
    largest_overlap = std::max(largest_overlap, contact.geometry.area);
    const Vec2 on_b = contact.force_on_b();
    particles.body(contact.a).contact.subtract(on_b, cross(contact.arm_a, on_b));
    if (contact.b < end_body)
      particles.body(contact.b).contact.add(on_b, cross(contact.arm_b, on_b));
  }
  task.largest_overlap = largest_overlap;
}

/// The wrench on a body: the sum over its touching pairs, in their order.
/// @param sides of all its pairs, in order
template <class ContactType>
[[nodiscard]] Wrench sum_forces(std::span<const PairSide> sides,
                                std::span<const ContactType> pairs) {
  Wrench sum;
  for (const PairSide side : sides) {
    const ContactType& contact = pairs[side.pair()];
    if (!contact.touching) continue;
    const Vec2 on_b = contact.force_on_b();
    if (side.is_b())
      sum.add(on_b, cross(contact.arm_b, on_b));
    else
      sum.subtract(on_b, cross(contact.arm_a, on_b));
  }
  return sum;
}

}  // namespace riprap
