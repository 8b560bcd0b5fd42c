// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/piece_contacts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include <riprap/riprap.hpp>

using namespace riprap;

namespace {

// Tasks from the last to the first: no order but that of the sums may enter a result.
struct FromTheLast {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    for (std::size_t k = tasks; k-- > 0;) work(k);
  }
};

// All numbers of a type with fields, in order.
template <class T>
void append_fields(std::vector<double>& numbers, const T& value) {
  if constexpr (std::is_arithmetic_v<T>)
    numbers.push_back(static_cast<double>(value));
  else if constexpr (std::is_same_v<T, Vec2>)
    numbers.insert(numbers.end(), {value.x(), value.y()});
  else if constexpr (requires { T::for_each_field(value, [](const char*, const auto&) {}); })
    T::for_each_field(value,
                      [&](const char*, const auto& field) { append_fields(numbers, field); });
  else
    static_assert(std::is_empty_v<T>);
}

// Wrenches of all bodies and the records of all contacts in order, with what they have dissipated.
// As numbers: a tangential force of -0 is +0 once it is evaluated again.
template <class Contacts>
std::vector<double> state_of(const Contacts& contacts, const Particles& particles) {
  std::vector<double> numbers;
  for (const Body& body : particles.bodies())
    numbers.insert(numbers.end(),
                   {body.contact.force.x(), body.contact.force.y(), body.contact.moment});
  contacts.for_each_touching([&](const auto& contact) {
    append_fields(numbers, contact);
    for (const bool flag :
         {contact.at_platen, contact.a_is_wall, contact.b_is_wall, contact.crosses_boundary})
      numbers.push_back(flag);
  });
  numbers.insert(numbers.end(),
                 {contacts.friction_loss(), contacts.viscous_loss(), contacts.image_power()});
  return numbers;
}

// Compares the contacts after every break with those that a search and evaluation of all pairs find
// at the same poses, and the indices of the list with its pairs.
struct CompareWithSearch {
  std::size_t passes = 0;
  std::size_t appended = 0;

  template <class Sim>
  void after_splits(const Sim& sim) {
    ++passes;
    const auto& contacts = sim.contacts();
    Particles particles = sim.particles();
    auto searched = contacts;
    searched.invalidate();
    searched.update(particles, 0, sim.model().execution_policy);
    REQUIRE(searched.tasks() == contacts.tasks());
    CHECK(state_of(contacts, sim.particles()) == state_of(searched, particles));
    // Of the pairs of a body and of a task those that touch, in the same order.
    const auto partners = [](const auto& list, BodyIndex i) {
      std::vector<BodyIndex> found;
      for (const PairSide side : list.index().of(i)) {
        const auto& pair = list.pairs()[side.pair()];
        CHECK((side.is_b() ? pair.b : pair.a) == i);
        if (pair.touching) found.push_back(side.is_b() ? pair.a : pair.b);
      }
      return found;
    };
    const auto touching_of = [](const auto& list, std::size_t task) {
      std::vector<BodyIndex> found;
      list.for_each_touching_of(task, [&](const auto& contact, std::size_t k) {
        CHECK(&contact == &list.pairs()[k]);
        found.insert(found.end(), {contact.a, contact.b});
      });
      return found;
    };
    for (BodyIndex i = 0; i < particles.size(); ++i)
      CHECK(partners(contacts, i) == partners(searched, i));
    for (std::size_t task = 0; task < contacts.tasks(); ++task)
      CHECK(touching_of(contacts, task) == touching_of(searched, task));
    appended += static_cast<std::size_t>(
        !std::ranges::is_sorted(contacts.pairs(), {}, [](const auto& p) { return p.a; }));
  }
};

// The Verlet list, searched anew after each break.
struct SearchAfterBreaks {
  static constexpr bool uses_skin = true;
  template <class Domain>
  struct State : private VerletList::State<Domain> {
    using Base = VerletList::State<Domain>;
    using Base::contact_threshold;
    using Base::displacement;
    using Base::invalidate;
    using Base::is_stale;
    using Base::rebuilt;
    using Base::record_motion;
  };
};

template <class ModelType>
Assembly sample_for(const ModelType&, unsigned count) {
  using Boundary = decltype(ModelType::motion_model.boundary);
  const RandomAssembly options{.count = count, .seed = 3};
  if constexpr (std::is_same_v<Boundary, RigidPlatens>) return random_platen_assembly(options);
  if constexpr (std::is_same_v<Boundary, PeriodicCell>) return random_periodic_assembly(options);
  return random_assembly(options);
}

// Weak rock compressed from both sides until particles have broken in so many steps.
template <class ModelType, class... Observers>
auto crushed(const ModelType& model, unsigned count, std::size_t steps_with_breaks,
             Observers&... observers) {
  const auto weak = model.criterion(HoekBrown{.compressive_strength = 3e6});
  Simulation sim{weak, sample_for(weak, count), Rock{}};
  std::size_t found = 0;
  for (double rate = 5; found < steps_with_breaks; rate += 3000 * sim.time_step()) {
    const std::size_t before = sim.breaks().size();
    sim.boundary().set_rate(0.5 * rate, rate);
    sim.step(observers...);
    found += sim.breaks().size() > before;
  }
  return sim;
}

template <class ModelType>
void compare_with_search(const ModelType& model, unsigned count = 60) {
  CompareWithSearch compare;
  (void)crushed(model, count, 8, compare);
  CHECK(compare.passes == 8);
  CHECK(compare.appended >= 4);
}

constexpr unsigned several_tasks = 300;  // particles: a task has 256
const StraightCut dusty{.minimum_area = 0.1, .dust = true};

}  // namespace

TEST_CASE("contacts after a break are those of a search and evaluation of all pairs") {
  compare_with_search(Model{});
  compare_with_search(Model{}.boundary(PeriodicCell{}));
}

TEST_CASE("with dashpots, dust and tasks in another order, too") {
  const auto model = Model{}.contact_law(SpringDashpot{}).splitter(dusty);
  compare_with_search(model.execution(FromTheLast{}), several_tasks);
  compare_with_search(model.boundary(RigidPlatens{}).execution(FromTheLast{}), several_tasks);
  compare_with_search(model.boundary(PeriodicCell{}).execution(FromTheLast{}), several_tasks);
}

TEST_CASE("a run is the same, whether the list follows pieces or is searched after each break") {
  const auto end_of = [](const auto& model) {
    const auto sim = crushed(model, 60, 12);
    std::vector<double> numbers = state_of(sim.contacts(), sim.particles());
    for (const Body& body : sim.particles().bodies()) append_fields(numbers, body.position);
    numbers.push_back(static_cast<double>(sim.steps()));
    return numbers;
  };
  const auto compare = [&](const auto& model) {
    const std::vector<double> followed = end_of(model);
    CHECK(followed == end_of(model.neighbour_list(SearchAfterBreaks{})));
    CHECK(followed == end_of(model.without_acceleration()));
  };
  static_assert(!requirements::FollowsPieces<SearchAfterBreaks::State<UnboundedDomain>>);
  // With a second kick, velocities are no longer those of the forces when particles break.
  compare(Model{}.integrator(VelocityVerlet{}).contact_law(SpringDashpot{}).splitter(dusty));
  compare(Model{}.boundary(PeriodicCell{}));
}
