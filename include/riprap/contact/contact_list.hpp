// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pair list: all pairs of the Verlet list, their contacts and contact forces.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/contact/contact.hpp>
#include <riprap/contact/domain.hpp>
#include <riprap/contact/law/concepts.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/acceleration/neighbour_list/verlet_list.hpp>
#include <riprap/acceleration/batching/pair_batch.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/acceleration/batching/prefetch.hpp>
#include <riprap/core/splitmix64.hpp>
#include <riprap/core/step_phase.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// The pairs found by the broad phase, sorted by (a, b): forces are summed in that order, whatever
/// the broad phase. A history lasts as long as its contact. In a periodic domain a pair is a body
/// and one image of another, so that two bodies may form several pairs.
template <BroadPhase Broad, NarrowPhase Narrow, ContactLaw Law, class Domain = UnboundedDomain>
class ContactList {
 public:
  using Image = typename Domain::Image;
  using ContactType = Contact<typename Law::History, typename Narrow::Cache, Image>;

  ContactList(Broad broad, Narrow narrow, Law law)
      : neighbours_(std::move(broad)), narrow_(std::move(narrow)), law_(std::move(law)) {
    riprap::validate(law_);
  }

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] Law& law() { return law_; }

  /// Sets the domain for the coming update.
  void set_domain(const Domain& domain) { domain_ = domain; }
  [[nodiscard]] const Domain& domain() const { return domain_; }

  /// All pairs of the Verlet list, touching or not, sorted by (a, b, image).
  [[nodiscard]] std::span<const ContactType> pairs() const { return pairs_; }

  /// Revision of the pair list; changes whenever the sequence of pairs changes.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The revision before, and the index of pair k in it; `not_present` for a new pair, and for one
  /// that belongs to the second piece of a broken particle now.
  [[nodiscard]] std::uint64_t previous_revision() const { return previous_revision_; }
  [[nodiscard]] std::uint32_t previous_index(std::size_t k) const { return previous_index_[k]; }
  static constexpr std::uint32_t not_present = std::numeric_limits<std::uint32_t>::max();

  /// Calls `visit(contact)` for every pair that touches, in order.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (const Task& task : tasks_)
      for (const std::uint32_t k : touching(task)) visit(pairs_[k]);
  }

  /// Calls `visit(contact, index)` once for every touching pair with a body of a task of
  /// `for_each_task`, in the order of the pairs, so that tasks can gather by body in parallel.
  template <class Visit>
  void for_each_touching_of(std::size_t task, Visit&& visit) const {
    if (task >= tasks_.size()) return;
    for (const std::uint32_t k : tasks_[task].shared_pairs)
      if (pairs_[k].touching) visit(pairs_[k], k);
    for (const std::uint32_t k : touching(tasks_[task])) visit(pairs_[k], k);
  }

  /// Velocity of b's image relative to a at their contact [m/s].
  [[nodiscard]] Vec2 relative_velocity(const ContactType& contact,
                                       const Particles& particles) const {
    const Vec2 b = particles.body(contact.b).velocity_at(contact.arm_b);
    const Vec2 a = particles.body(contact.a).velocity_at(contact.arm_a);
    Vec2 relative{b.x() - a.x(), b.y() - a.y()};
    if constexpr (Domain::periodic)
      if (contact.crosses_boundary) relative += domain_.velocity(contact.image);
    return relative;
  }

  /// Power that the deformation of a periodic cell puts into the bodies through their images [W].
  [[nodiscard]] double image_power() const {
    double sum = 0;
    if constexpr (Domain::periodic)
      for (const Task& task : tasks_)
        for (const std::uint32_t k : task.crossing)
          sum -= pairs_[k].force_on_b().dot(domain_.velocity(pairs_[k].image));
    return sum;
  }

  /// Energy dissipated by friction and by dashpots since the start [J].
  [[nodiscard]] double friction_loss() const { return friction_loss_; }
  [[nodiscard]] double viscous_loss() const { return viscous_loss_; }

  /// Optional: records the motion of the bodies of a task of `for_each_task` right after it. Tasks
  /// may run in parallel; the next `update` records the tasks that were left out.
  void record_motion(const Particles& particles, std::size_t task, std::size_t first,
                     std::size_t last) {
    neighbours_.record_motion(particles, task, first, last);
  }

  /// Finds contacts and forces at the present poses and sums them into the bodies' wrenches.
  /// @param time_step [s] of the motion that led here; zero to re-evaluate without motion
  /// @param on_phase_end called with each phase of the step that has ended
  template <Execution E = Serial, class OnPhaseEnd = NoPhaseTimer>
  void update(Particles& particles, double time_step, const E& execution = {},
              OnPhaseEnd&& on_phase_end = {}) {
    if (neighbours_.stale(particles, domain_, execution)) rebuild(particles);
    on_phase_end(StepPhase::broad_phase);
    const auto contacts = [&](std::size_t t) { find_contacts(tasks_[t], particles); };
    const auto forces = [&](std::size_t t) { find_forces(tasks_[t], particles, time_step); };
    if constexpr (std::is_same_v<std::remove_cvref_t<OnPhaseEnd>, NoPhaseTimer>) {
      // Detection and forces of a task while its contacts are in the cache. Same results.
      execution.run(tasks_.size(), [&](std::size_t t) {
        contacts(t);
        forces(t);
      });
    } else {
      execution.run(tasks_.size(), contacts);
      on_phase_end(StepPhase::narrow_phase);
      execution.run(tasks_.size(), forces);
    }
    add_deferred(particles);
    on_phase_end(StepPhase::contact_law);
  }

  /// Largest overlap of a contact, as a fraction of the area of the smaller particle. Beyond it one
  /// particle has penetrated the other, or they overlapped from the start.
  static constexpr double most_overlap = 0.75;

  /// Throws SimulationError, naming the particles, for a larger overlap.
  void check_overlaps(const Particles& particles) const {
    double largest = 0;
    for (const Task& task : tasks_) largest = std::max(largest, task.largest_overlap);
    if (largest > most_overlap * smallest_area_) find_deep_overlap(particles);
  }

  /// Makes the next update rebuild the pair list.
  void invalidate() {
    neighbours_.invalidate();
    std::fill(skip_until_.begin(), skip_until_.end(), unknown);
  }

  /// After the particle at `parent` has broken: contacts with `of_second(point)` are transferred to
  /// the piece at `second` with their histories, the others stay. Call update afterwards.
  template <class OfSecond>
  void divide(BodyIndex parent, BodyIndex second, OfSecond&& of_second) {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      ContactType& contact = pairs_[k];
      if (contact.a != parent && contact.b != parent) continue;
      skip_until_[k] = unknown;
      if (!contact.touching) continue;
      if (!of_second(contact.a == parent ? contact.geometry.point : point_at_b(contact))) continue;
      if (contact.a == parent) {
        // The new piece has the highest index: it becomes b. Tangential forces keep their sign,
        // since normal, tangent and the roles of the bodies are all reversed.
        contact.geometry.point = point_at_b(contact);
        contact.a = contact.b;
        contact.geometry.normal = -contact.geometry.normal;
        if constexpr (Domain::periodic) contact.image = -contact.image;
      }
      contact.b = second;
    }
    neighbours_.invalidate();
  }

 private:
  static constexpr double unknown = -std::numeric_limits<double>::infinity();

  [[nodiscard]] Vec2 image_offset(const ContactType& contact) const {
    if constexpr (Domain::periodic)
      if (contact.crosses_boundary) return domain_.offset(contact.image);
    return {0, 0};
  }
  // The contact point relative to b itself, not to its image.
  [[nodiscard]] Vec2 point_at_b(const ContactType& contact) const {
    return contact.geometry.point - image_offset(contact);
  }

  // A pair; a < b.
  struct Key {
    BodyIndex a = 0;
    BodyIndex b = 0;
    [[no_unique_address]] Image image{};
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  [[nodiscard]] static Key key(const ContactType& contact) {
    return {contact.a, contact.b, contact.image};
  }

  // Pairs that were in the list before keep their contact.
  void rebuild(const Particles& particles) {
    keys_.clear();
    neighbours_.visit_pairs(particles, domain_,
                            [this](BodyIndex a, BodyIndex b, const Image& image) {
                              keys_.push_back({a, b, image});
                            });
    std::sort(keys_.begin(), keys_.end());
    order_.resize(pairs_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    const auto before = [this](std::uint32_t p, std::uint32_t q) {
      return key(pairs_[p]) < key(pairs_[q]);
    };
    // Only a split changes the order.
    if (!std::is_sorted(order_.begin(), order_.end(), before))
      std::sort(order_.begin(), order_.end(), before);
    next_pairs_.clear();
    next_skip_until_.clear();
    previous_index_.clear();
    const std::size_t bodies_before = tasks_.empty() ? 0 : tasks_.back().last_body;
    auto old = order_.begin();
    for (const Key& k : keys_) {
      while (old != order_.end() && key(pairs_[*old]) < k) ++old;
      if (old != order_.end() && key(pairs_[*old]) == k) {
        next_pairs_.push_back(pairs_[*old]);
        next_skip_until_.push_back(skip_until_[*old]);
        previous_index_.push_back(k.b < bodies_before ? *old : not_present);
      } else {
        next_pairs_.push_back({.a = k.a, .b = k.b, .image = k.image});
        next_skip_until_.push_back(unknown);
        previous_index_.push_back(not_present);
      }
    }
    std::swap(pairs_, next_pairs_);
    std::swap(skip_until_, next_skip_until_);
    for (ContactType& pair : pairs_) {
      pair.crosses_boundary = pair.image != Image{};
      pair.at_platen = particles.body(pair.a).motion == Motion::platen ||
                       particles.body(pair.b).motion == Motion::platen;
    }
    previous_revision_ = revision_;
    revision_ = keys_.size();
    for (const Key& k : keys_)
      revision_ = splitmix64(revision_ ^ (static_cast<std::uint64_t>(k.a) << 32 | k.b));
    partition_tasks(particles.size());
    smallest_area_ = std::numeric_limits<double>::infinity();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      smallest_area_ = std::min(smallest_area_, particles.shape(i).area);
  }

  // A task owns the pairs whose first body is one of its own, and adds forces to its own bodies
  // only. Wrenches on bodies of other tasks are deferred until all tasks have ended.
  struct Deferred {
    BodyIndex body = 0;
    Wrench wrench;
  };
  struct Task {
    std::size_t first_body = 0;
    std::size_t last_body = 0;
    std::size_t first_pair = 0;
    std::size_t last_pair = 0;
    std::size_t touching = 0;  // number of touching pairs
    // Pairs of earlier tasks with a body of this one, in order.
    std::vector<std::uint32_t> shared_pairs{};
    // Its touching pairs across the boundary of a periodic cell.
    std::vector<std::uint32_t> crossing{};
    double largest_overlap = 0;  // [m^2]
    double friction_loss = 0;
    double viscous_loss = 0;
    std::vector<Deferred> deferred{};
  };

  void partition_tasks(std::size_t bodies) {
    tasks_.resize(task_count(bodies));
    touching_.resize(pairs_.size());
    auto pair = pairs_.begin();
    const auto place = [&] { return static_cast<std::size_t>(pair - pairs_.begin()); };
    for_each_task(Serial{}, bodies, [&](std::size_t t, std::size_t first, std::size_t last) {
      Task& task = tasks_[t];
      task.first_body = first;
      task.last_body = last;
      task.first_pair = place();
      pair = std::partition_point(pair, pairs_.end(),
                                  [last](const ContactType& c) { return c.a < last; });
      task.last_pair = place();
      task.touching = 0;
      task.shared_pairs.clear();
    });
    for (const Task& task : tasks_)
      for (std::size_t k = task.first_pair; k < task.last_pair; ++k)
        if (pairs_[k].b >= task.last_body)
          tasks_[task_of(pairs_[k].b)].shared_pairs.push_back(static_cast<std::uint32_t>(k));
  }

  // The touching pairs of a task, in order.
  [[nodiscard]] std::span<const std::uint32_t> touching(const Task& task) const {
    return {touching_.data() + task.first_pair, task.touching};
  }

  // With more pairs the records do not fit into the cache, and access to active pairs is irregular:
  // their records are prefetched, and the rings and bodies of the next task.
  static constexpr std::size_t pairs_in_cache = 20'000;
  static constexpr std::size_t prefetch_distance = 12;
  [[gnu::always_inline]] static void prefetch_next_task(const Task& task,
                                                        const Particles& particles) {
    const std::size_t end = std::min(task.last_body + task_size, particles.size());
    for (std::size_t i = task.last_body; i < end; ++i) {
      const auto body = static_cast<BodyIndex>(i);
      const Ring ring = particles.ring(body);
      prefetch(ring.data(), ring.size_bytes());
      prefetch(&particles.body(body), sizeof(Body));
    }
  }

  // Pairs of a task that may touch, in order, stored in the task's part of `touching_`.
  // Branch-free: separation is unpredictable.
  [[nodiscard]] std::span<const std::uint32_t> active_pairs(const Task& task) {
    const double displacement = neighbours_.displacement().value();
    std::uint32_t* const active = touching_.data() + task.first_pair;
    std::size_t count = 0;
    for (std::size_t k = task.first_pair; k < task.last_pair; ++k) {
      active[count] = static_cast<std::uint32_t>(k);
      count += static_cast<std::size_t>(displacement >= skip_until_[k]);
    }
    return {active, count};
  }

  // Contact detection: evaluates the narrow phase for all active pairs of a task.
  void find_contacts(Task& task, const Particles& particles) {
    const bool prefetching = pairs_.size() > pairs_in_cache;
    if (prefetching) prefetch_next_task(task, particles);
    const std::span<const std::uint32_t> active = active_pairs(task);
    std::size_t last = task.first_pair;
    bool all_touch = true;
    PairBatch<Narrow> batch;
    const auto evaluate_single = [&](std::size_t k) { all_touch &= find_contact(k, particles); };
    task.crossing.clear();
    for (std::size_t place = 0; place < active.size(); ++place) {
      const std::size_t k = active[place];
      if (prefetching && place + prefetch_distance < active.size())
        prefetch(&pairs_[active[place + prefetch_distance]], sizeof(ContactType));
      ContactType& contact = pairs_[k];
      if (batch.add(k, contact, particles)) {
        touching_[last++] = static_cast<std::uint32_t>(k);
        batch.find_if_full(narrow_, evaluate_single);
      } else if (find_contact(k, particles)) {
        touching_[last++] = static_cast<std::uint32_t>(k);
        if constexpr (Domain::periodic)
          if (contact.crosses_boundary) task.crossing.push_back(static_cast<std::uint32_t>(k));
      }
    }
    batch.finish(evaluate_single);
    task.touching = last - task.first_pair;
    if (!all_touch) remove_separated(task);
  }

  // Batched pairs were optimistically listed as touching; remove those that separated.
  void remove_separated(Task& task) {
    const auto first = touching_.begin() + static_cast<std::ptrdiff_t>(task.first_pair);
    const auto last = std::remove_if(first, first + static_cast<std::ptrdiff_t>(task.touching),
                                     [this](std::uint32_t k) { return !pairs_[k].touching; });
    task.touching = static_cast<std::size_t>(last - first);
  }

  // True if pair k touches.
  bool find_contact(std::size_t k, const Particles& particles) {
    ContactType& contact = pairs_[k];
    const std::optional<ContactGeometry> geometry = evaluate_narrow_phase(contact, particles);
    if (geometry) {
      if (!contact.touching) contact.history = typename Law::History{};
      contact.geometry = *geometry;
      skip_until_[k] = unknown;
    } else if constexpr (requires { narrow_.clearance(contact.cache); }) {
      skip_until_[k] =
          neighbours_.displacement().contact_threshold(narrow_.clearance(contact.cache));
    }
    contact.touching = geometry.has_value();
    return contact.touching;
  }

  // Narrow phase of a and b, or of a and the image of b.
  [[nodiscard]] std::optional<ContactGeometry>
  evaluate_narrow_phase(ContactType& contact, const Particles& particles) const {
    const Ring ring = particles.ring(contact.b);
    if constexpr (Domain::periodic) {
      if (contact.crosses_boundary) {
        const Vec2 offset = domain_.offset(contact.image);
        std::array<Vec2, max_polygon_vertices> image;
        for (std::size_t k = 0; k < ring.size(); ++k) image[k] = ring[k] + offset;
        return narrow_(particles.ring(contact.a), Ring{image.data(), ring.size()}, contact.cache);
      }
    }
    return narrow_(particles.ring(contact.a), ring, contact.cache);
  }

  void find_forces(Task& task, Particles& particles, double time_step) {
    for (std::size_t i = task.first_body; i < task.last_body; ++i)
      particles.body(static_cast<BodyIndex>(i)).contact = Wrench{};
    task.deferred.clear();
    double largest_overlap = 0;
    double friction_loss = 0;
    double viscous_loss = 0;
    for (const std::uint32_t k : touching(task)) {
      ContactType& contact = pairs_[k];
      Body& a = particles.body(contact.a);
      Body& b = particles.body(contact.b);
      find_arms(contact, a, b);
      largest_overlap = std::max(largest_overlap, contact.geometry.area);
      const Vec2& n = contact.geometry.normal;
      const Vec2 relative = relative_velocity(contact, particles);
      const double along = relative.y() * n.x() - relative.x() * n.y();
      const ContactMotion motion{.normal_velocity = relative.x() * n.x() + relative.y() * n.y(),
                                 .tangential_velocity = contact.at_platen ? 0 : along,
                                 .time_step = time_step,
                                 .effective_mass = effective_mass(a, b)};
      const ContactForce force = law_(contact.geometry, motion, contact.history);
      contact.force = {force.normal, force.tangential};
      friction_loss += force.friction_loss;
      viscous_loss += force.viscous_loss;
      const Vec2 on_b = contact.force_on_b();
      a.contact.subtract(on_b, cross(contact.arm_a, on_b));
      const double moment = cross(contact.arm_b, on_b);
      if (contact.b < task.last_body)
        b.contact.add(on_b, moment);
      else
        task.deferred.push_back({contact.b, {on_b, moment}});
    }
    task.largest_overlap = largest_overlap;
    task.friction_loss = friction_loss;
    task.viscous_loss = viscous_loss;
  }

  // Reduced in task order, so the result does not depend on scheduling.
  void add_deferred(Particles& particles) {
    for (const Task& task : tasks_) {
      for (const Deferred& d : task.deferred)
        particles.body(d.body).contact.add(d.wrench.force, d.wrench.moment);
      friction_loss_ += task.friction_loss;
      viscous_loss_ += task.viscous_loss;
    }
  }

  [[gnu::cold]] void find_deep_overlap(const Particles& particles) const {
    for_each_touching([&](const ContactType& contact) {
      const bool first = particles.shape(contact.a).area < particles.shape(contact.b).area;
      const BodyIndex smaller = first ? contact.a : contact.b;
      const double share = contact.geometry.area / particles.shape(smaller).area;
      if (share <= most_overlap) return;
      throw SimulationError(particle_text(particles.ancestry(contact.a).id) + " and " +
                            particle_text(particles.ancestry(contact.b).id) + " overlap in " +
                            to_text(share) + " of the area of the smaller one: at most " +
                            to_text(most_overlap) + " makes a contact");
    });
  }

  void find_arms(ContactType& contact, const Body& a, const Body& b) const {
    const Vec2& at_a = contact.geometry.point;
    const Vec2 at_b = point_at_b(contact);
    // Written as vectors: they are read as vectors soon after, and reading two scalar stores as one
    // vector would defeat store forwarding.
    contact.arm_a = at_a.array() - a.position.array();
    contact.arm_b = at_b.array() - b.position.array();
    if (contact.at_platen) (a.motion == Motion::platen ? contact.arm_a : contact.arm_b) = {0, 0};
  }

  [[nodiscard]] static double effective_mass(const Body& a, const Body& b) {
    if (!a.is_free()) return b.mass_scaling * b.mass;
    if (!b.is_free()) return a.mass_scaling * a.mass;
    const double p = a.mass_scaling * a.mass;
    const double q = b.mass_scaling * b.mass;
    return p * q / (p + q);
  }

  NeighbourSearch<Broad, Domain> neighbours_;
  Narrow narrow_;
  Law law_;
  [[no_unique_address]] Domain domain_{};
  std::vector<ContactType> pairs_;
  std::vector<double> skip_until_;  // of each pair, in terms of DisplacementBound::value()
  std::uint64_t revision_ = 0;
  std::uint64_t previous_revision_ = 0;
  std::vector<std::uint32_t> previous_index_;  // of each pair
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> touching_;  // of each task, from the index of its first pair on
  double smallest_area_ = 0;             // of a particle [m^2]
  double friction_loss_ = 0;
  double viscous_loss_ = 0;
  // Workspaces of a rebuild.
  std::vector<Key> keys_;
  std::vector<std::uint32_t> order_;
  std::vector<ContactType> next_pairs_;
  std::vector<double> next_skip_until_;
};

}  // namespace riprap
