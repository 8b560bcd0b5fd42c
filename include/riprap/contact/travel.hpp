#pragma once
/// @file
/// How far bodies have moved, at most.

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/contact/plane.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// An upper bound on the way of every vertex, from poses alone. What was `gap` apart stays apart
/// until the bound has grown by half of it: until then neither lists of neighbours nor pairs that
/// do not touch need a look. That leaves one comparison of what a pair apart cost (5 ns of 6).
template <class Plane>
class Travel {
 public:
  /// Bound on the way of any vertex since the start [m]. Never falls.
  [[nodiscard]] double so_far() const { return before_ + now_; }
  /// What `so_far` will be at the earliest when two vertices that are `gap` apart now meet [m].
  [[nodiscard]] double until_closed(double gap) const { return before_ + 0.5 * gap - now_; }

  /// Measures the ways of bodies `first` to `last`, those of a task, at the present poses: for who
  /// has just moved them and has them in the cache. `update` measures those that were left out.
  void follow(const Particles& particles, std::size_t task, std::size_t first, std::size_t last) {
    if (particles.size() != poses_.size()) return;
    double squared = 0;
    for (std::size_t i = first; i < last; ++i)
      squared = std::max(squared, poses_[i].way_squared(particles.body(static_cast<BodyIndex>(i))));
    longest_[task] = squared;
  }

  /// Brings the bound to the present poses. Ways are measured from a pose that is taken anew when
  /// one is longer than `stride` [m]: bodies that only tremble do not add up.
  /// @param farthest_image how many periods the two bodies of a pair may be apart
  template <Execution E = Serial>
  void update(const Particles& particles, const Plane& plane, double stride, int farthest_image,
              const E& execution = {}) {
    if (std::find(longest_.begin(), longest_.end(), unknown) != longest_.end())
      for_each_task(execution, poses_.size(),
                    [&](std::size_t task, std::size_t first, std::size_t last) {
                      follow(particles, task, first, last);
                    });
    double squared = 0;
    for (const double longest : longest_) squared = std::max(squared, longest);
    std::fill(longest_.begin(), longest_.end(), unknown);
    now_ = std::sqrt(squared);
    if constexpr (Plane::periodic) {
      // Images move with the cell; each body of a pair takes half.
      const Vec2 shrunk = (plane.period - plane_.period).cwiseAbs();
      now_ += 0.5 * farthest_image * (shrunk.x() + shrunk.y());
    }
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
  }
  [[nodiscard]] std::size_t bodies() const { return poses_.size(); }

 private:
  struct Pose {
    Vec2 position;
    Rotation rotation;
    double reach;

    [[nodiscard]] double way_squared(const Body& body) const {
      const Vec2 shift = body.position - position;
      const double dc = body.rotation.cosine - rotation.cosine;
      const double ds = body.rotation.sine - rotation.sine;
      // (p + q)^2 <= 2 (p^2 + q^2): no root needed to bound the way of the farthest vertex.
      return 2 * (shift.dot(shift) + reach * reach * (dc * dc + ds * ds));
    }
  };

  std::vector<Pose> poses_;
  static constexpr double unknown = -1;
  std::vector<double> longest_;  // squares of the longest ways, task by task
  [[no_unique_address]] Plane plane_{};
  double before_ = 0;
  double now_ = 0;
};

}  // namespace riprap
