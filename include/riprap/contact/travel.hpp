// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How far near bodies have moved beside each other, at most.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <riprap/contact/plane.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// An upper bound on how far near bodies have moved beside each other, from poses alone: half of
/// the way by which any two of their vertices may have come nearer. What was `gap` apart stays
/// apart until the bound has grown by half of it: until then neither lists of neighbours nor pairs
/// that do not touch need a look. That leaves one comparison of what a pair apart cost (5 ns of 6).
///
/// Ways are measured beside a flow that carries all bodies along: when a sample shrinks as a whole,
/// its ends move much and neighbours little (an eighth of a step of 100,000 particles, a twentieth
/// of one of 5,000). Any flow gives a bound, a good one a low bound. Bodies near each other come
/// nearer by up to `near` times its stretch. Those with boxes s apart along an axis, more than a
/// skin, do so by up to stretch (s - skin) more: less than what they are farther apart.
template <class Plane>
class Travel {
 public:
  /// The bound since the start [m].
  [[nodiscard]] double so_far() const { return before_ + now_; }
  /// What `so_far` will be at the earliest when two vertices that are `gap` apart now meet [m].
  [[nodiscard]] double until_closed(double gap) const { return before_ + 0.5 * gap - now_; }

  /// Measures the ways of bodies `first` to `last`, those of a task, at the present poses: for who
  /// has just moved them and has them in the cache. `update` measures those that were left out.
  void follow(const Particles& particles, std::size_t task, std::size_t first, std::size_t last) {
    if (particles.size() != poses_.size()) return;
    const Flow flow = foreseen();
    double squared = 0;
    for (std::size_t i = first; i < last; ++i)
      squared =
          std::max(squared, poses_[i].way_squared(particles.body(static_cast<BodyIndex>(i)), flow));
    longest_[task] = squared;
  }

  /// Brings the bound to the present poses. Ways are measured from a pose that is taken anew when
  /// the bound has grown by `stride` [m]: bodies that only tremble do not add up.
  /// @param near how far apart along an axis the centres of near bodies may be [m]
  /// @param farthest_image how many periods the two bodies of a pair may be apart
  template <Execution E = Serial>
  void update(const Particles& particles, const Plane& plane, double stride, double near,
              int farthest_image, const E& execution = {}) {
    if (std::find(longest_.begin(), longest_.end(), unknown) != longest_.end())
      for_each_task(execution, poses_.size(),
                    [&](std::size_t task, std::size_t first, std::size_t last) {
                      follow(particles, task, first, last);
                    });
    const Flow flow = foreseen();
    double squared = 0;
    for (const double longest : longest_) squared = std::max(squared, longest);
    std::fill(longest_.begin(), longest_.end(), unknown);
    now_ = std::sqrt(squared) + 0.5 * near * flow.stretch.norm();
    if constexpr (Plane::periodic) {
      // Images that are not carried along as the flow says; each body of a pair takes half.
      const Vec2 carried = plane_.period + componentwise_product(flow.stretch, plane_.period);
      const Vec2 astray = componentwise_abs(plane.period - carried);
      now_ += 0.5 * farthest_image * (astray.x() + astray.y());
    }
    const Flow measured = measure(particles, plane);
    growth_ = {measured.stretch - last_.stretch, measured.shift - last_.shift};
    last_ = measured;
    if (now_ > stride) restart(particles, plane);
  }

  /// Measures from the present poses on. To be called when there are other bodies than before.
  void restart(const Particles& particles, const Plane& plane) {
    before_ += now_;
    now_ = 0;
    plane_ = plane;
    poses_.clear();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      poses_.push_back({particles.body(i).position, particles.body(i).rotation,
                        particles.shape(i).circumradius});
    longest_.assign(task_count(poses_.size()), unknown);
    find_ends();
    last_ = {};
  }
  [[nodiscard]] std::size_t bodies() const { return poses_.size(); }

 private:
  // Takes what was at x to x + stretch * x + shift, axis by axis.
  struct Flow {
    Vec2 stretch{0, 0};
    Vec2 shift{0, 0};
  };

  struct Pose {
    Vec2 position;
    Rotation rotation;
    double reach;

    [[nodiscard]] double way_squared(const Body& body, const Flow& flow) const {
      const Vec2 carried = componentwise_product(flow.stretch, position) + flow.shift;
      const Vec2 shift = body.position - position - carried;
      const double dc = body.rotation.cosine - rotation.cosine;
      const double ds = body.rotation.sine - rotation.sine;
      // (p + q)^2 <= 2 (p^2 + q^2): no root needed to bound the way of the farthest vertex.
      return 2 * (shift.dot(shift) + reach * reach * (dc * dc + ds * ds));
    }
  };

  // Which bodies lie farthest out.
  void find_ends() {
    for (const Eigen::Index axis : {0, 1}) {
      const auto before = [axis](const Pose& p, const Pose& q) {
        return p.position[axis] < q.position[axis];
      };
      const auto [low, high] = std::minmax_element(poses_.begin(), poses_.end(), before);
      ends_[static_cast<std::size_t>(axis)] = {static_cast<BodyIndex>(low - poses_.begin()),
                                               static_cast<BodyIndex>(high - poses_.begin())};
    }
  }

  // The flow since the poses: that of the cell, or of those bodies.
  [[nodiscard]] Flow measure(const Particles& particles, const Plane& plane) const {
    Flow flow;
    for (const Eigen::Index axis : {0, 1}) {
      if constexpr (Plane::periodic) {
        flow.stretch[axis] = plane.period[axis] / plane_.period[axis] - 1;
      } else {
        if (poses_.empty()) break;
        const auto [low, high] = ends_[static_cast<std::size_t>(axis)];
        const double from = poses_[low].position[axis];
        const double extent = poses_[high].position[axis] - from;
        const double to = particles.body(low).position[axis];
        const double now = particles.body(high).position[axis] - to;
        if (extent > 0) flow.stretch[axis] = now / extent - 1;
        flow.shift[axis] = to - from - flow.stretch[axis] * from;
      }
    }
    return flow;
  }

  // Ways are measured before all bodies have moved: beside the flow that is to be expected then.
  // None is, where bodies far apart might by its stretch meet before the others.
  [[nodiscard]] Flow foreseen() const {
    const Flow flow{last_.stretch + growth_.stretch, last_.shift + growth_.shift};
    return flow.stretch.norm() < 0.5 ? flow : Flow{};
  }

  std::vector<Pose> poses_;
  static constexpr double unknown = -1;
  std::vector<double> longest_;  // squares of the longest ways, task by task
  [[no_unique_address]] Plane plane_{};
  double before_ = 0;
  double now_ = 0;
  std::array<std::pair<BodyIndex, BodyIndex>, 2> ends_{};  // along either axis
  Flow last_;                                              // as measured last
  Flow growth_;                                            // a step
};

}  // namespace riprap
