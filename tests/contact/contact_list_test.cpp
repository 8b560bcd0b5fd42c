// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/uniform_grid.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_list.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/simulation/default_acceleration.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;
using riprap::test::rectangle;

namespace {

using List = ContactList<UniformGrid, OverlapChord, LinearSpringCoulomb, UnboundedDomain,
                         DefaultNeighbourList, DefaultDetection>;

constexpr double stiffness = 1e6;  // [N/m], normal and tangential
constexpr LinearSpringCoulomb law{
    .normal_stiffness = stiffness, .tangential_stiffness = stiffness, .friction = 0.5};

List list_with_skin(double relative_skin) {
  return {UniformGrid{.relative_skin = relative_skin}, OverlapChord{}, law};
}

/// Moves a body by hand, as an integrator would.
void put(Particles& particles, BodyIndex i, const Vec2& position, double angle = 0) {
  particles.body(i).position = position;
  particles.body(i).rotation = Rotation::from_angle(angle);
  particles.update_ring(i);
}

const List::ContactType& only_touching(const List& list) {
  const List::ContactType* found = nullptr;
  int count = 0;
  list.for_each_touching([&](const auto& c) {
    found = &c;
    ++count;
  });
  REQUIRE(count == 1);
  return *found;
}

int touching_count(const List& list) {
  int count = 0;
  list.for_each_touching([&](const auto&) { ++count; });
  return count;
}

/// Random polygons in a square, many of them overlapping.
Particles crowd(std::uint64_t seed, int count) {
  Particles particles(1, 2500);
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const ConvexPolygon polygon = random_polygon({}, random.uniform(0.7, 1.3), random);
    const Vec2 place{random.uniform(-4, 4), random.uniform(-4, 4)};
    const BodyIndex body = particles.add(polygon.moved({}, place), Motion::free);
    particles.body(body).velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
    particles.body(body).angular_velocity = random.uniform(-1, 1);
  }
  return particles;
}

void drift_all(Particles& particles, double time_step) {
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    Body& body = particles.body(i);
    body.position += time_step * body.velocity;
    body.rotation = body.rotation.turned(time_step * body.angular_velocity);
    particles.update_ring(i);
  }
}

/// Two blocks, one on the other and pushed together by 1 mm, sheared by `way` [m].
Particles two_blocks() {
  Particles particles(1, 2500);
  particles.add(rectangle({0, 0}, 3, 1), Motion::free);
  particles.add(rectangle({0, 0.999}, 1, 1), Motion::free);
  return particles;
}

void shear(Particles& particles, List& list, double way) {
  list.update(particles, 0);
  particles.body(1).velocity = {way, 0};
  put(particles, 1, particles.body(1).position + Vec2{way, 0});
  list.update(particles, 1);
  particles.body(1).velocity = {0, 0};
}

}  // namespace

// --- Pairs --------------------------------------------------------------------------------------

TEST_CASE("pairs are sorted by their bodies, a before b, and hold every contact") {
  Particles particles = crowd(1, 60);
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  const auto pairs = list.pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    CHECK(pairs[k].a < pairs[k].b);
    if (k > 0) CHECK(std::pair(pairs[k - 1].a, pairs[k - 1].b) < std::pair(pairs[k].a, pairs[k].b));
  }
  // Compared with the narrow phase of all pairs.
  std::vector<std::pair<BodyIndex, BodyIndex>> expected;
  for (BodyIndex i = 0; i < particles.size(); ++i)
    for (BodyIndex j = i + 1; j < particles.size(); ++j) {
      OverlapChord::Cache cache;
      if (OverlapChord{}(particles.ring(i), particles.ring(j), cache)) expected.emplace_back(i, j);
    }
  std::vector<std::pair<BodyIndex, BodyIndex>> found;
  list.for_each_touching([&](const auto& c) { found.emplace_back(c.a, c.b); });
  CHECK(found == expected);
  CHECK(found.size() > 30);
}

TEST_CASE("the contacts of a task are those with one of its bodies, in order") {
  constexpr int bodies = 3 * task_size - 100;
  Particles particles = crowd(4, bodies);
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;
  std::size_t found = 0;
  for (std::size_t task = 0; task < task_count(bodies); ++task) {
    Pairs expected;
    list.for_each_touching([&](const auto& c) {
      if (task_of(c.a) == task || task_of(c.b) == task) expected.emplace_back(c.a, c.b);
    });
    Pairs of_task;
    list.for_each_touching_of(task, [&](const auto& c, std::size_t k) {
      of_task.emplace_back(c.a, c.b);
      CHECK(&c == &list.pairs()[k]);
    });
    CHECK(of_task == expected);
    found += of_task.size();
  }
  CHECK(found > static_cast<std::size_t>(touching_count(list)));  // some are of two tasks
  list.for_each_touching_of(task_count(bodies), [&](const auto&, std::size_t) { CHECK(false); });
}

namespace {

// Runs the tasks in another order than Serial.
struct LastTaskFirst {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    for (std::size_t k = tasks; k-- > 0;) work(k);
  }
};

}  // namespace

TEST_CASE(
    "a wrench is the sum over the pairs in rising order, whatever the tasks, to the last bit") {
  constexpr int bodies = 3 * task_size - 100;
  Particles particles = crowd(4, bodies);
  Particles same = particles;
  List list = list_with_skin(0.1);
  List other = list_with_skin(0.1);
  for (int step = 0; step < 3; ++step) {
    drift_all(particles, 0.01);
    drift_all(same, 0.01);
    list.update(particles, 0.01);
    other.update(same, 0.01, LastTaskFirst{});
    std::vector<Wrench> sums(bodies);
    list.for_each_touching([&](const auto& c) {  // in rising order, without tasks
      const Vec2 on_b = c.force_on_b();
      sums[c.a].subtract(on_b, cross(c.arm_a, on_b));
      sums[c.b].add(on_b, cross(c.arm_b, on_b));
    });
    for (BodyIndex i = 0; i < bodies; ++i) {
      const Wrench& found = particles.body(i).contact;
      CHECK(found.force == sums[i].force);
      CHECK(found.moment == sums[i].moment);
      CHECK(same.body(i).contact.force == found.force);
      CHECK(same.body(i).contact.moment == found.moment);
    }
  }
  CHECK(touching_count(list) > 2 * bodies);
}

TEST_CASE("the revision changes if pairs were added, removed or reordered, and only then") {
  Particles particles = crowd(2, 40);
  List list = list_with_skin(0.1);
  using Pairs = std::vector<std::pair<BodyIndex, BodyIndex>>;
  Pairs before;
  std::uint64_t number = list.revision();
  int kept = 0;
  int renumbered = 0;
  for (int step = 0; step < 100; ++step) {
    drift_all(particles, 0.01);
    list.invalidate();
    list.update(particles, 0.01);
    Pairs now;
    for (const auto& c : list.pairs()) now.emplace_back(c.a, c.b);
    CHECK((list.revision() == number) == (now == before));
    CHECK(list.map().from() == number);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const auto place = std::find(before.begin(), before.end(), now[k]) - before.begin();
      const bool is_new = list.map().previous_index(k) == PairMap::not_present;
      CHECK((is_new ? before.size() : list.map().previous_index(k)) ==
            static_cast<std::size_t>(place));
    }
    ++(now == before ? kept : renumbered);
    before = now;
    number = list.revision();
    // Lists of the same pairs have the same revision.
    List other = list_with_skin(0.1);
    other.update(particles, 0);
    CHECK(other.revision() == number);
  }
  CHECK(kept > 10);
  CHECK(renumbered > 10);
}

TEST_CASE("no contact is missed while bodies move far beyond the skin, or all of them together") {
  for (const double strain : {0.0, 0.003, -0.003}) {  // a step
    CAPTURE(strain);
    Particles particles = crowd(2, 40);
    List list = list_with_skin(0.1);
    std::size_t most = 0;
    std::size_t least = 1000;
    for (int step = 0; step < 300; ++step) {
      drift_all(particles, 0.01);
      for (BodyIndex i = 0; i < particles.size(); ++i) {
        Vec2 position = particles.body(i).position;
        position.y() -= strain * position.y();
        put(particles, i, position, particles.body(i).rotation.angle());
      }
      list.update(particles, 0.01);
      List fresh = list_with_skin(0);
      fresh.update(particles, 0);
      std::vector<std::pair<BodyIndex, BodyIndex>> found, expected;
      list.for_each_touching([&](const auto& c) { found.emplace_back(c.a, c.b); });
      fresh.for_each_touching([&](const auto& c) { expected.emplace_back(c.a, c.b); });
      REQUIRE(found == expected);
      most = std::max(most, found.size());
      least = std::min(least, found.size());
    }
    CHECK(most > least + 10);
  }
}

TEST_CASE("bodies that approach from beyond the skin touch as soon as they overlap") {
  const double width = 2 * std::sqrt(0.5) * 0.1;  // of the skin: 0.1 of the mean diameter [m]
  const double step = 0.02 * width;
  for (const Vec2& direction : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
    for (double gap = 0.05 * width; gap < 3 * width; gap += 0.0931 * width)
      for (const double share : {0.0, 0.5, 1.0}) {  // of the approach, done by the first body
        CAPTURE(gap / width);
        Particles particles(1, 2500);
        particles.add(rectangle({0, 0}, 1, 1), Motion::free);
        particles.add(rectangle((1 + gap) * direction, 1, 1), Motion::free);
        List list = list_with_skin(0.1);
        list.update(particles, 0);
        double way = 0;
        while (way <= gap) {
          way += step;
          put(particles, 0, share * way * direction);
          put(particles, 1, (1 + gap - (1 - share) * way) * direction);
          list.update(particles, 1);
        }
        REQUIRE(touching_count(list) == 1);
      }
}

TEST_CASE("a bar that only turns touches as soon as its end overlaps") {
  for (int i = 1; i < 100; ++i) {
    const double contact_angle = 0.005 * i;
    Particles particles(1, 2500);
    particles.add(rectangle({0, 0}, 6, 0.1), Motion::free);
    // A diamond whose lower tip the bar's upper side reaches at that angle, 2.5 m along the bar.
    const Vec2 tip = Rotation::from_angle(contact_angle) * Vec2{2.5, 0.05};
    particles.add(
        ConvexPolygon{tip, tip + Vec2{0.1, 0.3}, tip + Vec2{0, 0.6}, tip + Vec2{-0.1, 0.3}},
        Motion::free);
    List list = list_with_skin(0.02);
    list.update(particles, 0);
    for (double angle = 0; angle <= contact_angle; angle += 0.001) {
      put(particles, 0, {0, 0}, angle);
      list.update(particles, 1);
    }
    put(particles, 0, {0, 0}, contact_angle + 1e-4);
    list.update(particles, 1);
    REQUIRE(touching_count(list) == 1);
  }
}

TEST_CASE("forces do not depend on the skin of the broad phase, to the last bit") {
  const auto run = [](double skin) {
    Particles particles = crowd(3, 40);
    List list = list_with_skin(skin);
    for (int step = 0; step < 200; ++step) {
      drift_all(particles, 0.002);
      list.update(particles, 0.002);
    }
    return std::pair(std::move(particles), list.friction_loss());
  };
  const auto [thin, slipped_thin] = run(0);
  for (const double skin : {0.03, 0.3, 2.0}) {
    CAPTURE(skin);
    const auto [thick, slipped_thick] = run(skin);
    for (BodyIndex i = 0; i < thin.size(); ++i) {
      CHECK(thin.body(i).contact.force == thick.body(i).contact.force);
      CHECK(thin.body(i).contact.moment == thick.body(i).contact.moment);
    }
    CHECK(slipped_thin == slipped_thick);
  }
  CHECK(slipped_thin > 0);
}

TEST_CASE("only pairs with a free body are kept") {
  const std::vector<Motion> motions{Motion::free, Motion::prescribed, Motion::strain_field};
  for (const Motion first : motions)
    for (const Motion second : motions) {
      Particles particles(1, 2500);
      particles.add(rectangle({0, 0}, 1, 1), first);
      particles.add(rectangle({0.1, 0.9}, 1, 1), second);
      List list = list_with_skin(0.1);
      list.update(particles, 0);
      const bool expected = first == Motion::free || second == Motion::free;
      CHECK(list.pairs().size() == (expected ? 1 : 0));
      CHECK((particles.body(0).contact.force.norm() > 0) == expected);
    }
}

// --- Forces -------------------------------------------------------------------------------------

TEST_CASE("a pressed contact pushes both bodies apart with stiffness times depth") {
  Particles particles = two_blocks();
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  const auto& contact = only_touching(list);
  CHECK(contact.geometry.depth == near_relative(1e-3, 1e-12));
  CHECK((contact.force_on_b() - Vec2{0, 1000}).norm() <= 1e-9);
  CHECK((particles.body(1).contact.force - Vec2{0, 1000}).norm() <= 1e-9);
  CHECK((particles.body(0).contact.force + Vec2{0, 1000}).norm() <= 1e-9);
  CHECK(std::abs(particles.body(0).contact.moment) <= 1e-9);
  // From the centroid of the lower block to that of the upper one.
  CHECK((contact.branch() - Vec2{0, 0.999}).norm() <= 1e-14);
}

TEST_CASE("a contact force off the centroids turns the bodies by its lever arms") {
  Particles particles(1, 2500);
  particles.add(rectangle({0, 0}, 3, 1), Motion::free);
  particles.add(rectangle({0.7, 0.999}, 1, 1), Motion::free);
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  // 1000 N upwards on the upper block under its centroid, downwards on the lower one at x = 0.7 m.
  CHECK(particles.body(0).contact.moment == near_relative(-700, 1e-11));
  CHECK(std::abs(particles.body(1).contact.moment) <= 1e-9);
}

TEST_CASE("friction turns both bodies the same way") {
  Particles particles = two_blocks();
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-4);
  // The upper block has moved to the right and is held back with 200 N, 0.5 m below its centroid;
  // the lower one is drawn to the right at its upper side, and feels 1000 N at x = 0.2 mm.
  CHECK((particles.body(1).contact.force - Vec2{-200, 1000}).norm() <= 1e-9);
  CHECK(particles.body(1).contact.moment == near_relative(-200 * (0.999 - 0.5), 1e-9));
  CHECK(particles.body(0).contact.moment == near_relative(-200 * 0.5 - 1000 * 2e-4, 1e-9));
}

TEST_CASE("a turning body shears its contact with the velocity of the contact point") {
  Particles particles = two_blocks();
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  particles.body(0).angular_velocity = -4e-4;  // its upper side moves to the right
  list.update(particles, 1);
  CHECK(only_touching(list).force.tangential == near_relative(-200, 1e-9));
  CHECK(particles.body(1).contact.force.x() == near_relative(200, 1e-9));
}

TEST_CASE("a platen is smooth, and the branch of a contact with it ends where it is touched") {
  for (const bool platen_first : {true, false}) {
    Particles particles(1, 2500);
    const ConvexPolygon wall = rectangle({0, 0}, 3, 1);
    const ConvexPolygon block = rectangle({0.4, 0.999}, 1, 1);
    particles.add(platen_first ? wall : block, platen_first ? Motion::platen : Motion::free);
    particles.add(platen_first ? block : wall, platen_first ? Motion::free : Motion::platen);
    List list = list_with_skin(0.1);
    list.update(particles, 0);
    Body& free = particles.body(platen_first ? 1 : 0);
    free.velocity = {0.3, 0};
    list.update(particles, 1);
    const auto& contact = only_touching(list);
    CHECK(contact.at_platen);
    CHECK(contact.force.tangential == 0);
    CHECK((free.contact.force - Vec2{0, 1000}).norm() <= 1e-9);
    // The boundaries cross on the platen's face: from there to the centroid of the block it is half
    // a metre less the depth. To round-off.
    const double sign = platen_first ? 1 : -1;
    CHECK((contact.branch() - sign * Vec2{0, 0.499}).norm() <= 1e-9);
    CHECK((platen_first ? contact.arm_a : contact.arm_b) == Vec2{0, 0});
  }
}

TEST_CASE("renumbering two bodies leaves the forces on them as they were") {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const ConvexPolygon p = random_polygon({}, 1, random);
    const ConvexPolygon q = random_polygon({}, 1, random).moved({}, {0.6, 0.2});
    const Vec2 velocity{random.uniform(-1, 1), random.uniform(-1, 1)};
    const auto wrench_on_q = [&](bool p_first) {
      Particles particles(1, 2500);
      particles.add(p_first ? p : q, Motion::free);
      particles.add(p_first ? q : p, Motion::free);
      Body& body = particles.body(p_first ? 1 : 0);
      body.velocity = velocity;
      body.angular_velocity = 0.3;
      List list = list_with_skin(0.1);
      list.update(particles, 1e-3);
      return body.contact;
    };
    const Wrench second = wrench_on_q(true);
    const Wrench first = wrench_on_q(false);
    // Round-off of the clipping, 1e-15 m, times the stiffness and shared by a short chord.
    CHECK((second.force - first.force).norm() <= 1e-8);
    CHECK(std::abs(second.moment - first.moment) <= 1e-8);
  }
}

TEST_CASE("updating again without motion repeats the forces and loses nothing") {
  Particles particles = two_blocks();
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-3);  // well into slip
  const double friction_loss = list.friction_loss();
  const Vec2 force = particles.body(1).contact.force;
  CHECK(friction_loss > 0);
  list.update(particles, 0);
  list.update(particles, 0);
  CHECK(particles.body(1).contact.force == force);
  CHECK(list.friction_loss() == friction_loss);
}

TEST_CASE("slip energy is the sum over all contacts") {
  Particles particles = two_blocks();
  particles.add(rectangle({0.9, 0.999}, 0.5, 1), Motion::free);
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  for (const BodyIndex i : {BodyIndex{1}, BodyIndex{2}}) {
    particles.body(i).velocity = {2e-3, 0};
    put(particles, i, particles.body(i).position + Vec2{2e-3, 0});
  }
  list.update(particles, 1);
  // Each spring loads to mu N = 500 N over 0.5 mm and slips 1.5 mm, at 250 N on average.
  CHECK(list.friction_loss() == near_relative(2 * 250 * 1.5e-3, 1e-9));
  CHECK(list.viscous_loss() == 0);
}

// --- Histories ----------------------------------------------------------------------------------

TEST_CASE("the history of a contact survives a rebuild of the pairs") {
  Particles particles = two_blocks();
  particles.add(rectangle({10, 10}, 0.1, 0.1), Motion::free);
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-4);
  // The normal is +y, so the tangent -x.
  CHECK(only_touching(list).history.tangential_force == near_relative(200, 1e-9));
  // The small block flies past, again and again beyond the skin.
  for (int i = 0; i < 50; ++i) {
    put(particles, 2, {10 - 0.4 * i, 2});
    list.update(particles, 1);
  }
  CHECK(only_touching(list).history.tangential_force == near_relative(200, 1e-9));
  CHECK(particles.body(1).contact.force.x() == near_relative(-200, 1e-9));
}

TEST_CASE("a rebuild on demand changes neither forces nor histories") {
  Particles particles = crowd(4, 40);
  List list = list_with_skin(0.1);
  for (int step = 0; step < 50; ++step) {
    drift_all(particles, 0.002);
    list.update(particles, 0.002);
  }
  const std::vector<Body> before = particles.bodies();
  const double friction_loss = list.friction_loss();
  list.invalidate();
  list.update(particles, 0);
  CHECK(list.friction_loss() == friction_loss);
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    CHECK(particles.body(i).contact.force == before[i].contact.force);
    CHECK(particles.body(i).contact.moment == before[i].contact.moment);
  }
}

TEST_CASE("a contact that opens loses its history, even if the pair stays in the list") {
  Particles particles = two_blocks();
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-4);
  const Vec2 place = particles.body(1).position;
  put(particles, 1, place + Vec2{0, 0.01});
  list.update(particles, 1);
  CHECK(touching_count(list) == 0);
  CHECK(particles.body(1).contact.force.norm() == 0);
  put(particles, 1, place);
  list.update(particles, 1);
  CHECK(only_touching(list).history.tangential_force == 0);
  CHECK(std::abs(particles.body(1).contact.force.x()) <= 1e-9);
}

// --- Effective mass -----------------------------------------------------------------------------

namespace {

/// A law that only keeps the motion it was given.
struct MotionRecorder {
  struct History {
    ContactMotion motion;
  };
  ContactForce operator()(const ContactGeometry&, const ContactMotion& motion,
                          History& history) const {
    history.motion = motion;
    return {};
  }
  double stored_energy(const ContactGeometry&, const History&) const { return 0; }
  double peak_stiffness() const { return 1; }
};

ContactMotion recorded_motion(Motion first, Motion second, double scaling) {
  Particles particles(1, 1000);
  particles.add(rectangle({0, 0}, 2, 1), first);       // 2000 kg
  particles.add(rectangle({0, 0.999}, 1, 1), second);  // 1000 kg
  particles.body(1).mass_scaling = scaling;
  particles.body(0).velocity = {1, 2};
  particles.body(1).velocity = {4, -5};
  ContactList<UniformGrid, OverlapChord, MotionRecorder> list({}, {}, {});
  list.update(particles, 0.25);
  ContactMotion motion;
  list.for_each_touching([&](const auto& c) { motion = c.history.motion; });
  return motion;
}

}  // namespace

TEST_CASE("a law gets the relative velocity of b, and the effective mass of the pair") {
  const ContactMotion free = recorded_motion(Motion::free, Motion::free, 1);
  CHECK(free.normal_velocity == near_relative(-7, 1e-12));
  CHECK(free.tangential_velocity == near_relative(-3, 1e-12));  // the tangent is -x here
  CHECK(free.time_step == 0.25);
  CHECK(free.effective_mass == near_relative(2000.0 / 3, 1e-12));
  // Driven bodies are infinitely heavy; scaled masses count as the equations of motion see them.
  CHECK(recorded_motion(Motion::prescribed, Motion::free, 1).effective_mass ==
        near_relative(1000, 1e-12));
  CHECK(recorded_motion(Motion::free, Motion::strain_field, 1).effective_mass ==
        near_relative(2000, 1e-12));
  CHECK(recorded_motion(Motion::free, Motion::free, 2).effective_mass ==
        near_relative(1000, 1e-12));
}

// --- Breakage -----------------------------------------------------------------------------------

namespace {

/// Where the block that breaks, and then its second piece, stand among the others.
struct Broken {
  Particles particles{1, 2500};
  List list = list_with_skin(0.1);
  BodyIndex parent = 0;
  BodyIndex second = 0;
  Body whole{};  // the beam, before it broke
};

/// A beam of 3 m on or under two blocks at x = -1 and x = 1, pressed by 1 mm and sheared by 0.2 mm,
/// that breaks at x = 0: the left piece keeps its place in the list.
Broken break_beam(bool beam_first) {
  Broken b;
  const ConvexPolygon beam = rectangle({0, 0}, 3, 1);
  const ConvexPolygon left = rectangle({-1, 0.999}, 0.5, 1);
  const ConvexPolygon right = rectangle({1, 0.999}, 0.5, 1);
  if (beam_first) b.parent = b.particles.add(beam, Motion::free);
  const BodyIndex first_block = b.particles.add(left, Motion::free);
  b.particles.add(right, Motion::free);
  if (!beam_first) b.parent = b.particles.add(beam, Motion::free);
  b.list.update(b.particles, 0);
  for (const BodyIndex block : {first_block, first_block + 1}) {
    b.particles.body(block).velocity = {2e-4, 0};
    put(b.particles, block, b.particles.body(block).position + Vec2{2e-4, 0});
  }
  b.list.update(b.particles, 1);
  for (const BodyIndex block : {first_block, first_block + 1})
    b.particles.body(block).velocity = {0, 0};
  const Ancestry ancestry = b.particles.ancestry(b.parent);
  b.whole = b.particles.body(b.parent);
  b.particles.replace(b.parent, rectangle({-0.75, 0}, 1.5, 1), Motion::free, ancestry);
  b.second = b.particles.add(rectangle({0.75, 0}, 1.5, 1), Motion::free, &ancestry);
  return b;
}

}  // namespace

TEST_CASE("contacts of a broken body go to the piece on whose side they lie") {
  for (const bool beam_first : {true, false}) {
    CAPTURE(beam_first);
    Broken b = break_beam(beam_first);
    std::vector<Vec2> on_blocks;
    const BodyIndex first_block = beam_first ? 1 : 0;
    for (const BodyIndex i : {first_block, first_block + 1})
      on_blocks.push_back(b.particles.body(i).contact.force);
    b.list.divide(b.particles, b.whole, b.parent, b.second,
                  [](const Vec2& point) { return point.x() > 0; });
    b.list.update_pieces(b.particles);
    CHECK(touching_count(b.list) == 2);
    for (std::size_t k = 0; k < b.list.pairs().size(); ++k) {
      const auto& pair = b.list.pairs()[k];
      if (!pair.touching) continue;
      CHECK((b.list.map().previous_index(k) == PairMap::not_present) == (pair.b == b.second));
      const BodyIndex block = pair.a == first_block || pair.a == first_block + 1 ? pair.a : pair.b;
      CHECK(pair.a + pair.b - block == (block == first_block ? b.parent : b.second));
    }
    const double friction_loss = b.list.friction_loss();
    CHECK(friction_loss == 0);
    // Friction too has survived: 200 N on each block, in the sense it had.
    for (const BodyIndex i : {first_block, first_block + 1}) {
      CHECK((on_blocks[i - first_block] - Vec2{-200, 1000}).norm() <= 1e-8);
      CHECK((b.particles.body(i).contact.force - Vec2{-200, 1000}).norm() <= 1e-8);
    }
    for (const BodyIndex piece : {b.parent, b.second})
      CHECK((b.particles.body(piece).contact.force - Vec2{200, -1000}).norm() <= 1e-8);
  }
}

TEST_CASE("of a contact that both pieces touch, the piece at its point keeps the history") {
  Particles particles(1, 2500);
  particles.add(rectangle({0, 0}, 3, 1), Motion::free);
  particles.add(rectangle({0.1, 0.999}, 1, 1), Motion::free);
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-4);
  const Ancestry ancestry = particles.ancestry(0);
  const Body whole = particles.body(0);
  particles.replace(0, rectangle({-0.75, 0}, 1.5, 1), Motion::free, ancestry);
  const BodyIndex second = particles.add(rectangle({0.75, 0}, 1.5, 1), Motion::free, &ancestry);
  list.divide(particles, whole, 0, second, [](const Vec2& point) { return point.x() > 0; });
  list.update_pieces(particles);
  CHECK(touching_count(list) == 2);
  list.for_each_touching([&](const auto& c) {
    // Pieces do not overlap each other: both contacts are with the block.
    const bool with_second = c.b == second;
    CHECK(c.a == (with_second ? 1 : 0));
    CHECK(c.b == (with_second ? second : 1));
    CHECK(c.history.tangential_force == near(with_second ? 200 : 0, 1e-9));
  });
}

TEST_CASE("a body that has lost a part keeps the contacts of the rest") {
  for (const bool right_is_lost : {true, false}) {
    CAPTURE(right_is_lost);
    Broken b = break_beam(true);
    const Ancestry ancestry = b.particles.ancestry(b.parent);
    Particles left(1, 2500);
    left.add(rectangle({right_is_lost ? -0.75 : 0.75, 0}, 1.5, 1), Motion::free, &ancestry);
    for (const BodyIndex block : {1U, 2U}) {
      const Ring ring = b.particles.ring(block);
      left.add(ConvexPolygon{std::vector<Vec2>(ring.begin(), ring.end())}, Motion::free);
    }
    b.list.cut_off(left, b.whole, b.parent,
                   [&](const Vec2& point) { return (point.x() > 0) == right_is_lost; });
    b.list.update_pieces(left);
    const auto& pair = only_touching(b.list);
    CHECK(pair.a == 0);
    CHECK(pair.b == (right_is_lost ? 1 : 2));
    CHECK((left.body(0).contact.force - Vec2{200, -1000}).norm() <= 1e-8);
    CHECK(left.body(right_is_lost ? 2 : 1).contact.force.norm() == 0);
  }
}

TEST_CASE("contacts of other bodies are untouched when one breaks") {
  Particles particles = two_blocks();
  particles.add(rectangle({20, 0}, 1, 1), Motion::free);
  List list = list_with_skin(0.1);
  shear(particles, list, 2e-4);
  const Ancestry ancestry = particles.ancestry(2);
  const Body whole = particles.body(2);
  particles.replace(2, rectangle({19.75, 0}, 0.5, 1), Motion::free, ancestry);
  const BodyIndex second = particles.add(rectangle({20.25, 0}, 0.5, 1), Motion::free, &ancestry);
  list.divide(particles, whole, 2, second, [](const Vec2&) { return true; });
  list.update_pieces(particles);
  CHECK(only_touching(list).a == 0);
  CHECK(only_touching(list).b == 1);
  CHECK(only_touching(list).history.tangential_force == near_relative(200, 1e-9));
}

TEST_CASE("a contact list refuses a law that breaks its rules") {
  CHECK_THROWS_WITH_AS(List(UniformGrid{}, OverlapChord{}, {.normal_stiffness = -1}),
                       "LinearSpringCoulomb.normal_stiffness = -1: must be a finite number above 0",
                       InvalidInput);
}

TEST_CASE("of tips in a floor, found together, those that are lifted touch no longer") {
  constexpr int tips = 9;
  const auto lifted = [](int k) { return k % 3 == 1; };
  Particles particles(1, 2500);
  const BodyIndex floor = particles.add(rectangle({5, -1}, 14, 2), Motion::prescribed);
  for (int k = 0; k < tips; ++k)
    particles.add(ConvexPolygon{{1.2 * k, -1e-3}, {1.2 * k + 0.5, 1}, {1.2 * k - 0.5, 1}},
                  Motion::free);
  List list = list_with_skin(0.1);
  list.update(particles, 0);
  list.update(particles, 1e-6);  // now every pair knows its cap
  CHECK(touching_count(list) == tips);
  for (int k = 0; k < tips; ++k)
    if (lifted(k)) {
      const auto i = static_cast<BodyIndex>(k + 1);
      put(particles, i, particles.body(i).position + Vec2{0, 2e-3});
    }
  list.update(particles, 1e-6);
  CHECK(touching_count(list) == tips - 3);
  list.for_each_touching([&](const auto& c) {
    CHECK(c.a == floor);
    CHECK(!lifted(static_cast<int>(c.b) - 1));
    CHECK(c.geometry.depth == near_relative(1e-3, 1e-12));
  });
}
