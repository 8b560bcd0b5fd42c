// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Two particles moved and split by hand, as an observer of a biaxial test sees them.

#include <algorithm>

#include <riprap/experiment/stage.hpp>
#include <riprap/geometry/cut.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>
#include <support/rectangle.hpp>

namespace riprap::test {

/// Body 0 is free, 20 mm by 10 mm; body 1 is driven, a square of 10 mm to the east of it.
class BrokenSample {
 public:
  BrokenSample() : particles_(0.016, 2500) {
    particles_.add(rectangle({0.01, 0.005}, 0.02, 0.01), Motion::free);
    particles_.add(rectangle({0.04, 0.005}, 0.01, 0.01), Motion::strain_field);
  }

  /// Adds body 2, below the others.
  void add_platen() { particles_.add(rectangle({0.02, -0.02}, 0.06, 0.01), Motion::platen); }

  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] BiaxialView<BrokenSample> view() const {
    return {.sim = *this, .stage = Stage::shear};
  }

  void move(BodyIndex i, const Vec2& by) {
    particles_.body(i).position += by;
    particles_.update_ring(i);
  }

  /// Splits particle i upright, at 0.7 of its centroid's distance from its western end.
  BreakEvent split(BodyIndex i) {
    const Ancestry parent = particles_.ancestry(i);
    const Vec2 centroid = particles_.body(i).position;
    double west = centroid.x();
    for (const Vec2& v : particles_.ring(i)) west = std::min(west, v.x());
    const Line line{{west + 0.7 * (centroid.x() - west), centroid.y()}, {0, 1}};
    const auto pieces = cut(particles_.ring(i), line);
    const ConvexPolygon left{pieces.value().left};
    const ConvexPolygon right{pieces.value().right};
    particles_.replace(i, left, Motion::free, parent);
    const BodyIndex second = particles_.add(right, Motion::free, &parent);
    BreakEvent event;
    event.particle = parent;
    event.line = line;
    event.pieces = {particles_.ancestry(i).id, particles_.ancestry(second).id};
    event.areas = {particles_.shape(i).area, particles_.shape(second).area};
    event.centroids = {particles_.body(i).position, particles_.body(second).position};
    return event;
  }

 private:
  Particles particles_;
};

}  // namespace riprap::test
