// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/stress_change_bound.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/weighted_norm.hpp>

using namespace riprap;

namespace {

// With three nodes or, of as many sampling points, six.
InfluenceOperator random_operator(Random& random) {
  if (random.uniform_integer(0, 1) == 0)
    return {test::random_mesh(random, 100),
            ConstantStrainTriangle{},
            PlaneStress{},
            Rock{},
            0.016,
            false};
  return {
      test::random_mesh(random, 25), LinearStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false};
}

// A particle that turns, under contacts that move, open and close.
struct Loaded {
  explicit Loaded(Random& random)
      : op(random_operator(random)), compact(op),
        factors(test::random_factors(random, compact.elements())),
        rotation(Rotation::from_angle(random.uniform(-3, 3))) {
    const std::uint32_t count = random.uniform_integer(1, 8);
    for (std::uint32_t k = 0; k < count; ++k) loads.push_back(contact(random, 10 * k));
  }

  [[nodiscard]] ContactLoad contact(Random& random, std::uint32_t partner) const {
    const Mesh& mesh = op.mesh();
    // Every other one within a hundredth or so of the size from a corner, on either side of it.
    const auto corners = static_cast<unsigned>(mesh.corners.size());
    const bool at_corner = random.uniform(0, 1) < 0.5;
    const std::uint32_t corner = mesh.corners[random.uniform_integer(0, corners - 1)];
    const std::uint32_t node =
        at_corner ? corner : random.uniform_integer(0, mesh.boundary_nodes - 1);
    if (at_corner) {
      const double deep = std::pow(10, random.uniform(-5, -2));
      const Rotation aside = Rotation::from_angle(random.uniform(-0.01, 0.01));
      return {rotation * (aside * ((1 - deep) * mesh.nodes[node])),
              {random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)},
              0,
              partner};
    }
    // Up to a hundredth of the size inside.
    const Vec2 place =
        random.uniform(0.98, 1) *
        mesh.position({node, (node + 1) % mesh.boundary_nodes, random.uniform(0, 1)});
    return {rotation * place, {random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)}, 0, partner};
  }

  [[nodiscard]] std::vector<BoundaryLoad>
  placed(std::vector<LocatedPoint>* places = nullptr) const {
    std::vector<BoundaryLoad> all;
    for (const ContactLoad& load : loads) {
      const LocatedPoint found = compact.locator().nearest(rotation.inverse_times(load.arm_lab));
      all.push_back({found.at, rotation.inverse_times(load.force_lab), 0});
      if (places) places->push_back(found);
    }
    return all;
  }
  [[nodiscard]] ElementStress stress() const { return test::stress_of(op, placed()); }

  // Everything by a random amount of up to `amount` of its size.
  void move(Random& random, double amount) {
    const double turn = random.uniform(-1, 1) * amount;
    rotation = rotation.turned(turn);
    for (ContactLoad& load : loads) {
      load.arm_lab = Rotation::from_angle(turn) * load.arm_lab;
      load.force_lab = Rotation::from_angle(turn) * load.force_lab;
      load.arm_lab += 0.016 * amount * Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
      load.force_lab += 1e3 * amount * Vec2{random.uniform(-1, 1), random.uniform(-1, 1)};
    }
    if (random.uniform(0, 1) < 0.1 && loads.size() > 1)
      loads.erase(loads.begin() + random.uniform_integer(0, unsigned(loads.size()) - 1));
    if (random.uniform(0, 1) < 0.1) {
      const std::uint32_t at = random.uniform_integer(0, unsigned(loads.size()));
      ContactLoad fresh = contact(random, at == 0 ? 0 : loads[at - 1].partner + 1);
      fresh.force_lab *= amount;
      if (at == loads.size() || loads[at].partner > fresh.partner)
        loads.insert(loads.begin() + at, fresh);
    }
  }

  void reset(StressChangeBound& reference, double limit) const {
    std::vector<LocatedPoint> places;
    const auto all = placed(&places);
    WeightedInfluence influence;
    influence.assign(compact, all, places, factors);
    reference.reset(loads, all, places, rotation, influence, limit);
  }
  // Norm of the stresses, or of their change.
  [[nodiscard]] double norm(const ElementStress& now) const {
    return test::weighted_norm(now, factors);
  }
  [[nodiscard]] double change(const ElementStress& then, ElementStress now) const {
    now.values() -= then.values();
    return norm(now);
  }

  InfluenceOperator op;
  InfluenceOperatorF32 compact;
  std::vector<float> factors;
  Rotation rotation;
  std::vector<ContactLoad> loads;
};

// Incremental bound of the present contacts, with weights for some of them.
bool within_budget(const StressChangeBound::Sensitivities& sensitivities, std::size_t weighted,
                   const Loaded& particle) {
  IncrementalBound bound(particle.rotation, static_cast<std::uint32_t>(weighted));
  for (std::size_t k = 0; k < particle.loads.size(); ++k)
    bound.accumulate(sensitivities[k], particle.loads[k].arm_lab, particle.loads[k].force_lab);
  return bound.within_budget();
}

// A change of all loads, or of one of them alone: of its force, of its place or of both, along an
// axis of the particle or not.
struct Change {
  Change(Random& random, const Loaded& particle)
      : ways(particle.loads.size(), Vec2{0, 0}), forces(ways) {
    const std::uint32_t kind = random.uniform_integer(0, 3);
    const bool along_axis = random.uniform_integer(0, 1) == 0;
    const auto any = [&](double size) {
      const Vec2 both{random.uniform(-size, size), random.uniform(-size, size)};
      const Vec2 one = random.uniform_integer(0, 1) == 0 ? Vec2{both.x(), 0} : Vec2{0, both.y()};
      return particle.rotation * (along_axis ? one : both);
    };
    const std::uint32_t only =
        random.uniform_integer(0, static_cast<unsigned>(particle.loads.size()) - 1);
    const double far = std::pow(10, random.uniform(-5, -2.5));
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (kind > 0 && k != only) continue;
      if (kind != 1) ways[k] = any(far);
      if (kind != 2) forces[k] = any(3e3);
    }
    if (kind == 0) turn = random.uniform(-1, 1);
  }
  // By a share of it.
  [[nodiscard]] Loaded of(const Loaded& before, double share) const {
    Loaded after = before;
    const Rotation turned = Rotation::from_angle(share * turn);
    after.rotation = Rotation::from_angle(before.rotation.angle() + share * turn);
    for (std::size_t k = 0; k < after.loads.size(); ++k) {
      after.loads[k].arm_lab = turned * (before.loads[k].arm_lab + share * ways[k]);
      after.loads[k].force_lab = turned * (before.loads[k].force_lab + share * forces[k]);
    }
    return after;
  }

  std::vector<Vec2> ways;
  std::vector<Vec2> forces;
  double turn = 0;
};

}  // namespace

TEST_CASE("within the limit of a reference, stresses have changed by no more than it") {
  Random random(81);
  int held = 0;
  int asked = 0;
  for (int sample = 0; sample < 60; ++sample) {
    Loaded particle(random);
    for (int history = 0; history < 40; ++history) {
      const ElementStress then = particle.stress();
      const Loaded before = particle;
      const double amount = std::pow(10, random.uniform(-7, -1.5));
      for (int step = 0; step < 3; ++step) {
        particle.move(random, amount);
        const double change = particle.change(then, particle.stress());
        StressChangeBound reference;
        // Were the bound lower than the change by a thousandth, this would show it.
        before.reset(reference, 0.999 * change);
        CHECK_FALSE(reference.within_limit(particle.loads, particle.rotation));
        before.reset(reference, 2 * change);
        held += reference.within_limit(particle.loads, particle.rotation);
        ++asked;
      }
    }
  }
  // Nor is it twice as high in most cases. Places move much here; where contacts open and close
  // often, or go round a corner, it may be.
  CHECK(held > 0.4 * asked);
}

TEST_CASE("a load gets weights as long as a tenth of the limit is left") {
  Random random(87);
  for (int sample = 0; sample < 20; ++sample) {
    Loaded particle(random);
    const ElementStress stress = particle.stress();
    const double limit = particle.norm(stress);
    StressChangeBound reference;
    particle.reset(reference, limit);
    const std::vector<ContactLoad> loads = particle.loads;
    // With its places as they are, the stress grows as its forces do: by these parts of the limit,
    // which the bound finds to its margins of some thousandths, twice as many with six nodes.
    const double below = particle.op.mesh().mid_sides.empty() ? 0.99 : 0.98;
    for (const double grown : {0.5, 0.88, 0.91, below, 1.01}) {
      CAPTURE(grown);
      for (std::size_t k = 0; k < loads.size(); ++k)
        particle.loads[k].force_lab = (1 + grown) * loads[k].force_lab;
      StressChangeBound::Sensitivities sensitivities;
      CHECK(reference.within_limit(particle.loads, particle.rotation) == (grown < 1));
      CHECK(reference.within_limit(particle.loads, particle.rotation, sensitivities) ==
            (grown < 0.9));
    }
  }
}

TEST_CASE("while an incremental bound is within its budget, the stresses are within the limit") {
  Random random(85);
  int asked = 0;
  double used = 0;  // of the limit
  for (int sample = 0; sample < 60; ++sample) {
    const Loaded then(random);
    const ElementStress stress = then.stress();
    for (int history = 0; history < 100; ++history) {
      const double limit = std::pow(10, random.uniform(-3, 0)) * then.norm(stress);
      StressChangeBound reference;
      then.reset(reference, limit);
      Loaded before = then;
      if (history % 2 == 0) before.move(random, std::pow(10, random.uniform(-7, -2)));
      StressChangeBound::Sensitivities sensitivities;
      if (!reference.within_limit(before.loads, before.rotation, sensitivities)) continue;
      const std::size_t weighted = before.loads.size();
      const Change change(random, before);
      double share = 0;
      double too_much = 1;
      for (int k = 0; k < 25; ++k) {
        const double middle = 0.5 * (share + too_much);
        (within_budget(sensitivities, weighted, change.of(before, middle)) ? share : too_much) =
            middle;
      }
      const Loaded after = change.of(before, share);
      const double moved = then.change(stress, after.stress());
      CHECK(moved <= limit);
      // So the reference says, whose bound is bounded by the weights.
      CHECK(reference.within_limit(after.loads, after.rotation));
      used += moved / limit;
      ++asked;
    }
  }
  CHECK(asked > 4000);
  // Triangle inequalities and components in place of sizes take half.
  CHECK(used > 0.4 * asked);
}

TEST_CASE("for forces that change at fixed places the bound is the change itself") {
  Random random(82);
  for (int sample = 0; sample < 100; ++sample) {
    Loaded particle(random);
    const ElementStress then = particle.stress();
    StressChangeBound tight;
    StressChangeBound wide;
    const Loaded before = particle;
    for (ContactLoad& load : particle.loads)
      load.force_lab += Vec2{random.uniform(-300, 300), random.uniform(-300, 300)};
    const double change = particle.change(then, particle.stress());
    // The diagonal of the form is inflated by up to 1.3e-3; stresses of several forces may cancel.
    before.reset(tight, 0.999 * change);
    before.reset(wide, 1.02 * change);
    CHECK_FALSE(tight.within_limit(particle.loads, particle.rotation));
    CHECK(wide.within_limit(particle.loads, particle.rotation));
  }
}

TEST_CASE("a single force along the stiffer axis leaves the sum of norms no room either") {
  Random random(84);
  for (int sample = 0; sample < 100; ++sample) {
    const Loaded before(random);
    const ElementStress then = before.stress();
    for (std::size_t c = 0; c < before.loads.size(); ++c)
      for (const Vec2& axis : {Vec2{1, 0}, Vec2{0, 1}}) {
        Loaded after = before;
        after.loads[c].force_lab += before.rotation * (random.uniform(100, 300) * axis);
        StressChangeBound reference;
        before.reset(reference, 0.999 * before.change(then, after.stress()));
        CHECK_FALSE(reference.within_limit(after.loads, after.rotation));
      }
  }
}

TEST_CASE(
    "a reference that is new holds, one that is discarded or has too many contacts does not") {
  Random random(83);
  Loaded particle(random);
  StressChangeBound reference;
  CHECK_FALSE(reference.within_limit(particle.loads, particle.rotation));
  particle.reset(reference, 1e6);
  CHECK(reference.within_limit(particle.loads, particle.rotation));
  reference.clear();
  CHECK_FALSE(reference.within_limit(particle.loads, particle.rotation));
  particle.reset(reference, 0);
  CHECK_FALSE(reference.within_limit(particle.loads, particle.rotation));
  while (particle.loads.size() <= StressChangeBound::capacity)
    particle.loads.push_back(particle.contact(random, particle.loads.back().partner + 1));
  particle.reset(reference, 1e12);
  CHECK_FALSE(reference.within_limit(particle.loads, particle.rotation));
}

TEST_CASE("loads that are not numbers are within no limit") {
  Random random(84);
  Loaded particle(random);
  StressChangeBound reference;
  particle.reset(reference, 1e9);
  auto broken = particle.loads;
  broken[0].force_lab.x() = std::nan("");
  CHECK_FALSE(reference.within_limit(broken, particle.rotation));
  broken = particle.loads;
  broken[0].arm_lab.y() = std::nan("");
  CHECK_FALSE(reference.within_limit(broken, particle.rotation));
}
