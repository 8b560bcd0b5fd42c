// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Particles under random contact loads, for the axioms of triggers and line fits.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/failure/loaded_particle.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>

namespace riprap::internal {

/// A polygon, its loads, and what they are in other axes and units.
struct LoadedSample {
  ConvexPolygon polygon{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  double thickness = 1;
  std::vector<ContactLoad> loads{};

  /// Turned, drawn larger and shifted, in this order; stresses stay as they are.
  [[nodiscard]] LoadedSample moved(const Rotation& turn, double scale, const Vec2& shift) const {
    std::vector<Vec2> vertices;
    for (const Vec2& v : polygon) vertices.push_back(scale * (turn * v) + shift);
    LoadedSample out{ConvexPolygon(std::move(vertices)), scale * thickness, loads};
    for (ContactLoad& load : out.loads) {
      load.arm_lab = scale * (turn * load.arm_lab);
      load.force_lab = scale * scale * (turn * load.force_lab);
      load.normal_force *= scale * scale;
    }
    return out;
  }
  /// Under `factor` times the loads.
  [[nodiscard]] LoadedSample times(double factor) const {
    LoadedSample out = *this;
    for (ContactLoad& load : out.loads) {
      load.force_lab *= factor;
      load.normal_force *= factor;
    }
    return out;
  }
  [[nodiscard]] LoadedSample reversed() const {
    LoadedSample out = *this;
    std::reverse(out.loads.begin(), out.loads.end());
    return out;
  }
  /// What `use` makes of the particle, of rock and under a criterion with the default values.
  template <class Use>
  [[nodiscard]] auto particle(Use&& use) const {
    const Rock rock;
    const HoekBrown hoek_brown;
    const CriterionView criterion{hoek_brown};
    Particles particles(thickness, rock.density);
    particles.add(polygon, Motion::free);
    return use(LoadedParticle{particles, 0, loads, rock, criterion});
  }
};

/// Polygons of about `size` [m] as thick as large, under two to six forces of up to 1 N towards the
/// inside, each at most 30 degrees off the normal of its edge; nothing is balanced.
[[nodiscard]] inline std::vector<LoadedSample> loaded_samples(double size, std::size_t count) {
  Random random(3);
  std::vector<LoadedSample> samples;
  while (samples.size() < count) {
    LoadedSample sample{random_polygon({}, size, random), size, {}};
    const std::size_t n = sample.polygon.size();
    for (unsigned k = random.uniform_integer(2, 6); k > 0; --k) {
      const std::size_t edge = random.uniform_integer(0, static_cast<unsigned>(n - 1));
      const Vec2& from = sample.polygon[edge];
      const Vec2 along = sample.polygon[(edge + 1) % n] - from;
      const Vec2 inwards = perpendicular(along) / along.norm();
      const double force = random.uniform(0.1, 1);
      ContactLoad load;
      load.arm_lab = from + random.uniform(0, 1) * along;
      load.force_lab = force * (Rotation::from_angle(random.uniform(-0.52, 0.52)) * inwards);
      load.normal_force = load.force_lab.dot(inwards);
      sample.loads.push_back(load);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace riprap::internal
