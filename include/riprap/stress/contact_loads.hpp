// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The contact forces on each particle.

#include <cstdint>
#include <span>
#include <vector>

#include <riprap/contact/concepts.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/concepts.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// A contact force on a particle, in laboratory axes.
struct ContactLoad {
  Vec2 arm_lab{0, 0};       ///< contact point minus centroid [m]
  Vec2 force_lab{0, 0};     ///< on the particle [N]
  double normal_force = 0;  ///< of the contact, pushing: positive [N]
  BodyIndex partner = 0;
  PairSide side{};
};

/// Throws InvalidInput for a load that is not finite.
inline void require_finite(const ContactLoad& load) {
  require_finite("sum of a contact's arm and force",
                 load.arm_lab.x() + load.arm_lab.y() + load.force_lab.x() + load.force_lab.y());
}

/// The load of a contact on one of its two bodies.
template <class ContactType>
[[nodiscard]] ContactLoad load_on(const ContactType& contact, PairSide side) {
  const Vec2 on_b = contact.force_on_b();
  if (side.is_b()) return {contact.arm_b, on_b, contact.force.normal, contact.a, side};
  return {contact.arm_a, -on_b, contact.force.normal, contact.b, side};
}

/// The loads of particle i alone, in the order of the contacts.
template <TouchingContacts Contacts>
[[nodiscard]] std::vector<ContactLoad> loads_on(const Contacts& contacts, BodyIndex i) {
  std::vector<ContactLoad> loads;
  contacts.for_each_touching([&](const auto& contact) {
    if (contact.a == i || contact.b == i) loads.push_back(load_on(contact, {0, contact.b == i}));
  });
  return loads;
}

/// Loads of particles, gathered one by one. Particles of different tasks of `for_each_task` may be
/// gathered in parallel.
class ContactLoads {
 public:
  /// Discards all loads. `gather` and `sides` refer to the present pairs of `contacts`.
  template <ListedContacts Contacts>
  void begin(const Contacts& contacts, std::size_t particles) {
    index_ = &contacts.index();
    ranges_.assign(particles, {});
    tasks_.resize(task_count(particles));
    for (auto& task : tasks_) task.clear();
  }

  /// Gathers the loads of particle i, in the order of the pairs; behind them those of its bonds, if
  /// the contacts come with bonds (Interactions).
  template <ListedContacts Contacts>
  void gather(const Contacts& contacts, BodyIndex i) {
    std::vector<ContactLoad>& all = tasks_[task_of(i)];
    ranges_[i].first = static_cast<std::uint32_t>(all.size());
    for (const PairSide side : index_->of(i)) {
      const auto& contact = contacts.pairs()[side.pair()];
      if (contact.touching) all.push_back(load_on(contact, side));
    }
    if constexpr (requires { contacts.for_each_bond_force_on(i, requirements::ContactVisitor{}); })
      contacts.for_each_bond_force_on(i, [&](const auto& force, bool is_b) {
        all.push_back(load_on(force, PairSide{0, is_b}));
      });
    ranges_[i].last = static_cast<std::uint32_t>(all.size());
  }

  /// Loads of particle i; none before `gather`.
  [[nodiscard]] std::span<const ContactLoad> of(BodyIndex i) const {
    const ContactLoad* const all = tasks_[task_of(i)].data();
    return {all + ranges_[i].first, all + ranges_[i].last};
  }
  /// All pairs of particle i, touching or not.
  [[nodiscard]] std::span<const PairSide> sides(BodyIndex i) const { return index_->of(i); }

 private:
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  const PairIndex* index_ = nullptr;  // of the contacts that `begin` was given
  std::vector<std::vector<ContactLoad>> tasks_;
  std::vector<Range> ranges_;  // of each particle, within its task
};

}  // namespace riprap
