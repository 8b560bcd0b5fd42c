// SPDX-License-Identifier: BSL-1.0
#include <riprap/acceleration/screening/incremental_bound.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

struct Load {
  Vec2 arm;
  Vec2 force;
};

Vec2 random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size)};
}

// Some contacts with weights, in the particle's own frame.
struct WeightedLoads {
  explicit WeightedLoads(Random& random) {
    const std::uint32_t count = random.uniform_integer(1, 8);
    for (std::uint32_t k = 0; k < count; ++k) {
      loads.push_back({random_vector(random, 0.01), random_vector(random, 1e3)});
      const auto each = [&](double size) {
        return static_cast<float>(size * std::pow(10, random.uniform(-2, 1)));
      };
      sensitivities.emplace_back(LoadSensitivity::single(loads[k].arm, loads[k].force),
                                 FourFloats{each(1e4), each(1e4), each(1e-2), each(1e-2)});
    }
  }

  [[nodiscard]] double use(const std::vector<Load>& now) const {
    double sum = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
      const FourFloats& each = sensitivities[k].weights;
      const Vec2 way = now[k].arm - loads[k].arm;
      const Vec2 by = now[k].force - loads[k].force;
      sum += static_cast<double>(each[0]) * std::abs(way.x()) +
             static_cast<double>(each[1]) * std::abs(way.y()) +
             static_cast<double>(each[2]) * std::abs(by.x()) +
             static_cast<double>(each[3]) * std::abs(by.y());
    }
    return sum;
  }
  [[nodiscard]] double round_off() const {
    double sum = 0;
    for (const LoadSensitivity& weights : sensitivities)
      sum += static_cast<double>(weights.round_off());
    return sum;
  }

  std::vector<Load> loads;
  std::vector<LoadSensitivity> sensitivities;
};

// As seen from the laboratory.
bool holds(const std::vector<LoadSensitivity>& sensitivities, const std::vector<Load>& loads,
           const Rotation& rotation, std::size_t count) {
  IncrementalBound bound(rotation, static_cast<std::uint32_t>(count));
  for (std::size_t k = loads.size(); k-- > 0;)
    bound.accumulate(sensitivities[k], rotation * loads[k].arm, rotation * loads[k].force);
  return bound.within_budget();
}

}  // namespace

TEST_CASE(
    "an incremental bound is within the budget up to it, whatever the rotation of the particle") {
  Random random(91);
  for (int sample = 0; sample < 500; ++sample) {
    const WeightedLoads weighted(random);
    const Rotation rotation = Rotation::from_angle(random.uniform(-3, 3));
    std::vector<Load> way = weighted.loads;
    for (Load& load : way) {
      load.arm += random_vector(random, 1e-4);
      load.force += random_vector(random, 100);
    }
    const double use = weighted.use(way);
    const auto at = [&](double share) {
      std::vector<Load> loads = weighted.loads;
      for (std::size_t k = 0; k < loads.size(); ++k) {
        loads[k].arm += share / use * (way[k].arm - weighted.loads[k].arm);
        loads[k].force += share / use * (way[k].force - weighted.loads[k].force);
      }
      return loads;
    };
    const auto holds_at = [&](double share) {
      return holds(weighted.sensitivities, at(share), rotation, weighted.loads.size());
    };
    // 1e-6 of what the weights allow for in loads, and of the changes: round-off of single
    // precision.
    const double off = weighted.round_off() + 2e-6;
    CHECK(holds_at(1 - off));
    CHECK_FALSE(holds_at(1 + off));
  }
}

TEST_CASE("contacts that are missing, new or without weights are detected") {
  Random random(92);
  for (int sample = 0; sample < 100; ++sample) {
    const WeightedLoads weighted(random);
    const Rotation rotation = Rotation::from_angle(random.uniform(-3, 3));
    const std::size_t count = weighted.loads.size();
    // Round-off alone may use up the budget.
    std::vector<LoadSensitivity> light = weighted.sensitivities;
    for (LoadSensitivity& weights : light) weights.weights *= 1e-3f;
    CHECK(holds(light, weighted.loads, rotation, count));
    CHECK_FALSE(holds(light, weighted.loads, rotation, count + 1));
    CHECK_FALSE(holds(light, weighted.loads, rotation, IncrementalBound::untracked));
    std::vector<Load> more = weighted.loads;
    more.push_back({{0, 0}, {0, 0}});
    light.emplace_back();
    CHECK_FALSE(holds(light, more, rotation, count));
    CHECK_FALSE(holds(light, more, rotation, count + 1));
  }
  CHECK(holds({}, {}, Rotation{}, 0));
  CHECK_FALSE(holds({}, {}, Rotation{}, IncrementalBound::untracked));
}

TEST_CASE("loads that are not numbers are detected") {
  const LoadSensitivity free(FourFloats{0, 0, 0, 0}, FourFloats{0, 0, 0, 0});
  CHECK(holds({free}, {{{1, 1}, {1, 1}}}, Rotation{}, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(holds({free}, {{{1, nan}, {1, 1}}}, Rotation{}, 1));
  CHECK_FALSE(holds({free}, {{{1, 1}, {nan, 1}}}, Rotation{}, 1));
}

TEST_CASE("the opposite sensitivity is that of the opposite force") {
  Random random(93);
  const WeightedLoads weighted(random);
  for (std::size_t k = 0; k < weighted.loads.size(); ++k) {
    const Load& load = weighted.loads[k];
    LoadSensitivity weights = weighted.sensitivities[k].opposite();
    CHECK(weights.round_off() == weighted.sensitivities[k].round_off());
    weights.weights *= 1e-3f;
    CHECK(holds({weights}, {{load.arm, -load.force}}, Rotation{}, 1));
    CHECK_FALSE(holds({weights}, {{load.arm, 1e6 * load.force}}, Rotation{}, 1));
  }
}
