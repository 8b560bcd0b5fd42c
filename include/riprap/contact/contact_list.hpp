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

#include <riprap/contact/concepts.hpp>
#include <riprap/contact/contact_forces.hpp>
#include <riprap/contact/detection/evaluate_each_pair.hpp>
#include <riprap/contact/former_bonds.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/neighbour_list/rebuild_every_step.hpp>
#include <riprap/contact/neighbours.hpp>
#include <riprap/contact/overlap_limit.hpp>
#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/excluded_pairs.hpp>
#include <riprap/contact/pair/task_partition.hpp>
#include <riprap/contact/piece_contacts.hpp>
#include <riprap/contact/touching_pairs.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/core/step_phase.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// All pairs of neighbours, their contacts and forces. A history lasts as long as its contact.
/// @tparam Excluded pairs that have no contact
template <BroadPhase Broad, NarrowPhase Narrow, ContactLaw Law, class Domain = UnboundedDomain,
          NeighbourList List = RebuildEveryStep, Detection Detect = EvaluateEachPair,
          class Excluded = NoExcludedPairs>
class ContactList
    : public TouchingPairs<ContactList<Broad, Narrow, Law, Domain, List, Detect, Excluded>> {
 public:
  using TouchingPairs<ContactList>::tasks;

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

  /// All pairs of neighbours, touching or not, sorted by (a, b, image); behind them those of pieces
  /// that have come since the last search.
  [[nodiscard]] std::span<const ContactType> pairs() const { return table().pairs(); }
  /// Revision of the pair list; changes whenever the sequence of pairs changes.
  [[nodiscard]] std::uint64_t revision() const { return table().list().revision(); }
  /// From the revision before to this one: arrays that run parallel to the pairs follow by it.
  [[nodiscard]] const PairMap& map() const { return table().list().map(); }

  /// The pairs of each body.
  [[nodiscard]] const PairIndex& index() const { return table().index(); }

  /// Velocity of b's image relative to a at their contact [m/s].
  [[nodiscard]] Vec2 relative_velocity(const ContactType& contact,
                                       const Particles& particles) const {
    return riprap::relative_velocity(contact, particles, domain_);
  }

  /// Power that the deformation of a periodic cell puts into the bodies through their images [W].
  [[nodiscard]] double image_power() const {
    ExactSum power;
    for (std::size_t task = 0; task < tasks(); ++task) add_image_work(task, 1, power);
    return power.value();
  }
  /// Adds the work that it does in a time [s], through the contacts of a task of `for_each_task`.
  void add_image_work(std::size_t task, double time, ExactSum& work) const {
    if constexpr (Domain::periodic) {
      if (task >= tasks()) return;
      for (const std::uint32_t k : table().tasks()[task].crossing)
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
    neighbours_.state().record_motion(particles, task, first, last);
  }

  /// Finds contacts and forces at the present poses and sums them into the bodies' wrenches.
  /// @param time_step [s] of the motion that led here; zero to re-evaluate without motion
  /// @param on_phase_end called with each phase of the step that has ended
  template <Execution E = Serial, class OnPhaseEnd = NoPhaseTimer>
  void update(Particles& particles, double time_step, const E& execution = {},
              OnPhaseEnd&& on_phase_end = {}) {
    if (neighbours_.is_stale(particles, domain_, execution)) search(particles);
    on_phase_end(StepPhase::broad_phase);
    const DetectionInput<ContactType, Narrow, Domain, typename AllNeighbours::State> input{
        table().pairs(), particles, narrow_, domain_, neighbours_.state()};
    const std::span<ContactTask> all = table().tasks();
    const auto contacts = [&](std::size_t t) { detection_.find(input, all[t]); };
    constexpr bool in_order = std::is_same_v<E, Serial>;
    if constexpr (in_order) clear_wrenches(particles, 0, particles.size());
    const auto forces = [&](std::size_t t) {
      ContactTask& task = all[t];
      if constexpr (!in_order) clear_wrenches(particles, task.first_body, task.last_body);
      find_forces(task, table().pairs(), particles, law_, domain_, time_step,
                  in_order ? particles.size() : task.last_body, losses_[t]);
    };
    if constexpr (std::is_same_v<std::remove_cvref_t<OnPhaseEnd>, NoPhaseTimer>) {
      // Detection and forces of a task while its contacts are in the cache. Same results.
      execution.run(all.size(), [&](std::size_t t) {
        contacts(t);
        forces(t);
      });
    } else {
      execution.run(all.size(), contacts);
      on_phase_end(StepPhase::narrow_phase);
      execution.run(all.size(), forces);
    }
    if constexpr (!in_order) sum_shared(particles, execution);
    on_phase_end(StepPhase::contact_law);
  }

  /// Throws SimulationError, naming the particles, for an overlap above `most_overlap`.
  void check_overlaps(const Particles& particles) const {
    double largest = 0;
    for (const ContactTask& task : table().tasks())
      largest = std::max(largest, task.largest_overlap);
    if (largest > most_overlap * smallest_area_) refuse_deep_overlaps(*this, particles);
  }

  /// Makes the next update search the pairs anew.
  void invalidate() {
    neighbours_.invalidate();
    detection_.forget_all();
  }
  /// The same, with other pairs left out.
  void exclude(Excluded pairs) {
    neighbours_.exclude(std::move(pairs));
    invalidate();
  }
  /// Of pairs left out until now: the next update, at the same poses, starts their contacts with
  /// what bonds leave. `store(n, energy)` is called with what that of pair n stores [J].
  template <class Store>
  void begin_contacts(const Particles& particles, std::span<const FormerPair<Image>> former,
                      Store&& store) {
    if (neighbours_.is_stale(particles, domain_, Serial{})) search(particles);
    for (std::size_t n = 0; n < former.size(); ++n)
      if (ContactType* const pair =
              table().list().find({.a = former[n].a, .b = former[n].b, .image = former[n].image}))
        store(n, begin_contact(*pair, former[n].bond, particles, narrow_, law_, domain_));
  }

  /// After body i was removed, and those behind it have moved up: the next update, which must come
  /// at once, finds the other contacts with their histories.
  void remove(BodyIndex i) {
    neighbours_.remove(i);
    detection_.carry(map());
  }

  /// After the particle at `parent` has broken into a piece at the same index and one at the
  /// highest: `update_pieces`, which must come next, hands the histories of its contacts to those
  /// of the pieces.
  /// @param whole the parent, before it broke
  /// @param of_second whether a point [m] lies on the side of the second piece
  template <class OfSecond>
  void divide(const Particles& particles, const Body& whole, BodyIndex parent, BodyIndex second,
              OfSecond&& of_second) {
    record(parent);
    pieces_.histories.divide(parent, second, domain_, of_second);
    pieces_.add(second);
    neighbours_.divide(particles, whole, parent, second);
    if (neighbours_.is_complete()) detection_.carry(map());
  }
  /// After a part of the particle at `parent` has been cut off and removed: `update_pieces`, which
  /// must come next, keeps the histories of contacts that are left.
  /// @param whole the parent, before it broke
  /// @param of_lost whether a point [m] lies on the side of that part
  template <class OfLost>
  void cut_off(const Particles& particles, const Body& whole, BodyIndex parent, OfLost&& of_lost) {
    record(parent);
    pieces_.histories.cut_off(parent, domain_, of_lost);
    neighbours_.divide(particles, whole, parent, parent);
  }
  /// After `divide` and `cut_off`, at the same poses: finds the contacts of the pieces and their
  /// forces, and sums those on the pieces and their neighbours anew. All others stay as they are.
  void update_pieces(Particles& particles) {
    if (!neighbours_.is_complete()) {
      (void)neighbours_.is_stale(particles, domain_, Serial{});
      search(particles);
      table().list_touching();
    }
    for (const BodyIndex piece : pieces_.pieces())
      smallest_area_ = std::min(smallest_area_, particles.shape(piece).area);
    losses_.resize(tasks());
    pieces_.update(table(), particles, narrow_, law_, domain_, losses_);
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
    neighbours_.clear();
    detection_ = {};
    search(particles);
    for (const ContactType& contact : restored_) {
      ContactType* const pair = table().list().find(contact);
      if (!pair)
        throw InvalidInput("contact of the bodies " + std::to_string(contact.a) + " and " +
                           std::to_string(contact.b) + ": they are not neighbours");
      *pair = contact;
      pair->know_bodies(particles.body(pair->a), particles.body(pair->b));
    }
    restored_ = {};
    table().list_touching();
  }

 private:
  friend TouchingPairs<ContactList>;
  using AllNeighbours = Neighbours<ContactType, Broad, Domain, List, Excluded>;

  [[nodiscard]] const PairTable<ContactType>& table() const { return neighbours_.table(); }
  [[nodiscard]] PairTable<ContactType>& table() { return neighbours_.table(); }

  // Of a particle that has broken.
  void record(BodyIndex parent) {
    pieces_.record(table(), parent, [this](std::size_t k) { detection_.forget(k); });
  }

  void search(const Particles& particles) {
    neighbours_.search(particles, domain_);
    detection_.carry(map());
    losses_.resize(tasks());
    smallest_area_ = std::numeric_limits<double>::infinity();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      smallest_area_ = std::min(smallest_area_, particles.shape(i).area);
  }

  static void clear_wrenches(Particles& particles, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      particles.body(static_cast<BodyIndex>(i)).contact = Wrench{};
  }

  // Bodies with pairs in several tasks: the division into tasks does not enter the sum.
  template <Execution E>
  void sum_shared(Particles& particles, const E& execution) {
    execution.run(tasks(), [&](std::size_t t) {
      for (const BodyIndex i : table().tasks()[t].shared_bodies)
        particles.body(i).contact = sum_forces(index().of(i), pairs());
    });
  }

  [[nodiscard]] double loss(ExactSum ContactLosses::*part) const {
    ExactSum sum;
    for (const ContactLosses& losses : losses_) sum += losses.*part;
    return sum.value();
  }

  AllNeighbours neighbours_;
  [[no_unique_address]] typename Detect::template State<Narrow> detection_;
  Narrow narrow_;
  Law law_;
  [[no_unique_address]] Domain domain_{};
  PieceContacts<ContactType> pieces_;
  std::vector<ContactType> restored_;  // touching pairs, from `for_each_field` to `restore`
  double smallest_area_ = 0;           // of a particle [m^2]
  std::vector<ContactLosses> losses_;  // of the tasks, since the start
};

}  // namespace riprap
