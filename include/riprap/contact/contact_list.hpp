// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact pass of a step: neighbour list, contact detection, contact forces.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/pair_search.hpp>
#include <riprap/contact/concepts.hpp>
#include <riprap/contact/contact_forces.hpp>
#include <riprap/contact/detection/evaluate_each_pair.hpp>
#include <riprap/contact/divided_contacts.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/contact/overlap_limit.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_list.hpp>
#include <riprap/contact/pair/task_partition.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/core/step_phase.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// All pairs of neighbours, their contacts and forces. A history lasts as long as its contact.
template <BroadPhase Broad, NarrowPhase Narrow, ContactLaw Law, class Domain = UnboundedDomain,
          NeighbourList List = RebuildEveryStep, Detection Detect = EvaluateEachPair>
class ContactList {
 public:
  using Image = typename Domain::Image;
  using ContactType = Contact<typename Law::History, typename Narrow::Cache, Image>;

  ContactList(Broad broad, Narrow narrow, Law law)
      : search_(std::move(broad)), narrow_(std::move(narrow)), law_(std::move(law)) {
    riprap::validate(law_);
  }

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] Law& law() { return law_; }

  /// Sets the domain for the coming update.
  void set_domain(const Domain& domain) { domain_ = domain; }
  [[nodiscard]] const Domain& domain() const { return domain_; }

  /// All pairs of neighbours, touching or not, sorted by (a, b, image).
  [[nodiscard]] std::span<const ContactType> pairs() const { return list_.pairs(); }
  /// Revision of the pair list; changes whenever the sequence of pairs changes.
  [[nodiscard]] std::uint64_t revision() const { return list_.revision(); }
  /// From the revision before to this one: arrays that run parallel to the pairs follow by it.
  [[nodiscard]] const PairMap& map() const { return list_.map(); }

  /// The pairs of each body.
  [[nodiscard]] const PairIndex& index() const { return index_; }

  /// Calls `visit(contact)` for every pair that touches, in order.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (std::size_t task = 0; task < tasks_.size(); ++task) for_each_touching_in(task, visit);
  }
  /// Number of tasks, and the touching pairs whose first body is of one of them, in order.
  [[nodiscard]] std::size_t tasks() const { return tasks_.size(); }
  template <class Visit>
  void for_each_touching_in(std::size_t task, Visit&& visit) const {
    for (const std::uint32_t k : touching(tasks_[task])) visit(pairs()[k]);
  }

  /// Calls `visit(contact, index)` once for every touching pair with a body of a task of
  /// `for_each_task`, in the order of the pairs, so that tasks can gather by body in parallel.
  template <class Visit>
  void for_each_touching_of(std::size_t task, Visit&& visit) const {
    if (task >= tasks_.size()) return;
    for (const std::uint32_t k : tasks_[task].shared_pairs)
      if (pairs()[k].touching) visit(pairs()[k], k);
    for (const std::uint32_t k : touching(tasks_[task])) visit(pairs()[k], k);
  }

  /// Velocity of b's image relative to a at their contact [m/s].
  [[nodiscard]] Vec2 relative_velocity(const ContactType& contact,
                                       const Particles& particles) const {
    return riprap::relative_velocity(contact, particles, domain_);
  }

  /// Power that the deformation of a periodic cell puts into the bodies through their images [W].
  [[nodiscard]] double image_power() const {
    ExactSum power;
    for (std::size_t task = 0; task < tasks_.size(); ++task) add_image_work(task, 1, power);
    return power.value();
  }
  /// Adds the work that it does in a time [s], through the contacts of a task of `for_each_task`.
  void add_image_work(std::size_t task, double time, ExactSum& work) const {
    if constexpr (Domain::periodic) {
      if (task >= tasks_.size()) return;
      for (const std::uint32_t k : tasks_[task].crossing)
        work.add(-time * pairs()[k].force_on_b().dot(domain_.velocity(pairs()[k].image)));
    }
  }

  /// Energy dissipated by friction and by dashpots since the start [J].
  [[nodiscard]] double friction_loss() const { return loss(&ContactLosses::friction); }
  [[nodiscard]] double viscous_loss() const { return loss(&ContactLosses::viscous); }

  /// Optional: records the motion of the bodies of a task of `for_each_task` right after it. Tasks
  /// may run in parallel; the next `update` records the tasks that were left out.
  void record_motion(const Particles& particles, std::size_t task, std::size_t first,
                     std::size_t last) {
    list_state_.record_motion(particles, task, first, last);
  }

  /// Finds contacts and forces at the present poses and sums them into the bodies' wrenches.
  /// @param time_step [s] of the motion that led here; zero to re-evaluate without motion
  /// @param on_phase_end called with each phase of the step that has ended
  template <Execution E = Serial, class OnPhaseEnd = NoPhaseTimer>
  void update(Particles& particles, double time_step, const E& execution = {},
              OnPhaseEnd&& on_phase_end = {}) {
    if (list_state_.is_stale(particles, domain_, execution)) rebuild(particles);
    on_phase_end(StepPhase::broad_phase);
    const DetectionInput<ContactType, Narrow, Domain, ListState> input{
        list_.pairs(), touching_, particles, narrow_, domain_, list_state_};
    const auto contacts = [&](std::size_t t) { detection_.find(input, tasks_[t]); };
    constexpr bool in_order = std::is_same_v<E, Serial>;
    if constexpr (in_order) clear_wrenches(particles, 0, particles.size());
    const auto forces = [&](std::size_t t) {
      const ContactTask& task = tasks_[t];
      if constexpr (!in_order) clear_wrenches(particles, task.first_body, task.last_body);
      find_forces(tasks_[t], list_.pairs(), touching(task), particles, law_, domain_, time_step,
                  in_order ? particles.size() : task.last_body, losses_[t]);
    };
    constexpr bool timed = !std::is_same_v<std::remove_cvref_t<OnPhaseEnd>, NoPhaseTimer>;
    if (!timed && divided_.empty()) {
      // Detection and forces of a task while its contacts are in the cache. Same results.
      execution.run(tasks_.size(), [&](std::size_t t) {
        contacts(t);
        forces(t);
      });
    } else {
      execution.run(tasks_.size(), contacts);
      divided_.hand_over(law_, [&](const ContactType& of) { return list_.find_touching(of); });
      on_phase_end(StepPhase::narrow_phase);
      execution.run(tasks_.size(), forces);
    }
    if constexpr (!in_order) sum_shared(particles, execution);
    on_phase_end(StepPhase::contact_law);
  }

  /// Throws SimulationError, naming the particles, for an overlap above `most_overlap`.
  void check_overlaps(const Particles& particles) const {
    double largest = 0;
    for (const ContactTask& task : tasks_) largest = std::max(largest, task.largest_overlap);
    if (largest > most_overlap * smallest_area_) refuse_deep_overlaps(*this, particles);
  }

  /// Makes the next update search the pairs anew.
  void invalidate() {
    list_state_.invalidate();
    detection_.forget_all();
  }

  /// After body i was removed, and those behind it have moved up: the next update, which must come
  /// at once, finds the other contacts with their histories.
  void remove(BodyIndex i) {
    list_.remove(i);
    detection_.carry(list_.map());
    list_state_.invalidate();
  }

  /// After the particle at `parent` has broken, with its second piece at the highest index: the
  /// next update hands the histories of its contacts to those of its pieces.
  /// @param of_second whether a point [m] lies on the side of the second piece
  template <class OfSecond>
  void divide(BodyIndex parent, BodyIndex second, OfSecond&& of_second) {
    record_contacts(parent);
    divided_.divide(parent, second, domain_, of_second);
  }
  /// After a part of the particle at `parent` has been cut off and removed: the next update keeps
  /// the histories of contacts that are left.
  /// @param of_lost whether a point [m] lies on the side of that part
  template <class OfLost>
  void cut_off(BodyIndex parent, OfLost&& of_lost) {
    record_contacts(parent);
    divided_.cut_off(parent, domain_, of_lost);
  }

  /// Pairs apart, and what the neighbour list and the detection keep, are found anew by `restore`.
  template <class Self>
  static void for_each_field(Self& self, auto&& visit) {
    visit("law", self.law_);
    visit("domain", self.domain_);
    visit("losses", self.losses_);
    if constexpr (std::is_const_v<Self>) {
      std::vector<ContactType> touching;
      self.for_each_touching([&](const ContactType& c) { touching.push_back(c); });
      visit("touching", std::as_const(touching));
    } else {
      visit("touching", self.restored_);
    }
  }
  /// After the fields have been written: lists for the poses of the particles, without evaluating a
  /// contact. Throws InvalidInput for a contact of bodies that are far apart.
  void restore(const Particles& particles) {
    list_.clear();
    list_state_ = ListState{};
    detection_ = {};
    rebuild(particles);
    for (const ContactType& contact : restored_) {
      ContactType* const pair = list_.find(contact);
      if (!pair)
        throw InvalidInput("contact of the bodies " + std::to_string(contact.a) + " and " +
                           std::to_string(contact.b) + ": they are not neighbours");
      *pair = contact;
    }
    restored_ = {};
    for (ContactTask& task : tasks_) list_touching(task);
  }

 private:
  // From the pairs' own flags.
  void list_touching(ContactTask& task) {
    task.crossing.clear();
    for (std::size_t k = task.first_pair; k < task.last_pair; ++k) {
      if (!pairs()[k].touching) continue;
      touching_[task.first_pair + task.touching++] = static_cast<std::uint32_t>(k);
      if (pairs()[k].crosses_boundary) task.crossing.push_back(static_cast<std::uint32_t>(k));
    }
  }

  // Of a particle that has broken.
  void record_contacts(BodyIndex parent) {
    for (std::size_t k = 0; k < list_.size(); ++k) {
      const ContactType& pair = pairs()[k];
      if (pair.a != parent && pair.b != parent) continue;
      detection_.forget(k);
      if (pair.touching) divided_.add(pair);
    }
    list_state_.invalidate();
  }

  using ListState = typename List::template State<Domain>;

  void rebuild(const Particles& particles) {
    list_.begin();
    const PairExtent extent = search_.visit_pairs(
        particles, domain_, List::uses_skin,
        [this](BodyIndex a, BodyIndex b, const Image& image) { list_.add(a, b, image); });
    list_.finish();
    list_state_.rebuilt(particles, domain_, extent);
    detection_.carry(list_.map());
    for (ContactType& pair : list_.pairs()) {
      pair.crosses_boundary = pair.image != Image{};
      pair.at_platen = particles.body(pair.a).motion == Motion::platen ||
                       particles.body(pair.b).motion == Motion::platen;
      pair.a_is_wall = particles.body(pair.a).is_wall();
      pair.b_is_wall = particles.body(pair.b).is_wall();
    }
    partition_pairs(pairs(), particles.size(), tasks_);
    index_.build(pairs(), particles.size());
    touching_.resize(list_.size());
    losses_.resize(tasks_.size());
    smallest_area_ = std::numeric_limits<double>::infinity();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      smallest_area_ = std::min(smallest_area_, particles.shape(i).area);
  }

  // The touching pairs of a task, in order.
  [[nodiscard]] std::span<const std::uint32_t> touching(const ContactTask& task) const {
    return {touching_.data() + task.first_pair, task.touching};
  }

  static void clear_wrenches(Particles& particles, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      particles.body(static_cast<BodyIndex>(i)).contact = Wrench{};
  }

  // Bodies with pairs in several tasks: the division into tasks does not enter the sum.
  template <Execution E>
  void sum_shared(Particles& particles, const E& execution) {
    execution.run(tasks_.size(), [&](std::size_t t) {
      for (const BodyIndex i : tasks_[t].shared_bodies)
        particles.body(i).contact = sum_forces(index_.of(i), pairs());
    });
  }

  [[nodiscard]] double loss(ExactSum ContactLosses::*part) const {
    ExactSum sum;
    for (const ContactLosses& losses : losses_) sum += losses.*part;
    return sum.value();
  }

  PairSearch<Broad, Domain> search_;
  [[no_unique_address]] ListState list_state_;
  [[no_unique_address]] typename Detect::template State<Narrow> detection_;
  Narrow narrow_;
  Law law_;
  [[no_unique_address]] Domain domain_{};
  PairList<ContactType> list_;
  DividedContacts<ContactType> divided_;
  PairIndex index_;
  std::vector<ContactTask> tasks_;
  std::vector<ContactType> restored_;    // touching pairs, from `for_each_field` to `restore`
  std::vector<std::uint32_t> touching_;  // of each task, from the index of its first pair on
  double smallest_area_ = 0;             // of a particle [m^2]
  std::vector<ContactLosses> losses_;    // of the tasks, since the start
};

}  // namespace riprap
