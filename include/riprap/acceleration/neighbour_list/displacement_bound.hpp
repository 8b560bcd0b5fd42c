// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Upper bound on the relative displacement of neighbouring bodies, for the Verlet list.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Upper bound, from the poses alone, on half of the distance by which any two vertices of
/// neighbouring bodies can have approached each other. Two bodies with a gap between them cannot
/// touch before the bound has grown by half of the gap; until then the Verlet list stays valid and
/// separated pairs are skipped with one comparison.
///
/// Displacements are measured relative to an affine motion of the whole sample: when the sample is
/// compressed, bodies at its ends move much and neighbours little relative to each other. Any
/// affine motion gives a valid bound; one close to the mean motion gives a small bound.
/// Neighbouring bodies approach each other by up to `near` times the norm of its gradient. Bodies
/// whose boxes are s > skin apart along an axis approach by up to gradient (s - skin) more, which
/// is less than the additional distance between them.
template <class Domain>
class DisplacementBound {
 public:
  /// The bound, accumulated since the start [m].
  [[nodiscard]] double value() const { return accumulated_ + current_; }
  /// Value of the bound below which two vertices that are `gap` apart now cannot touch [m].
  [[nodiscard]] double contact_threshold(double gap) const {
    return accumulated_ + 0.5 * gap - current_;
  }

  /// Measures the displacements of bodies `first` to `last`, those of a task, at their present
  /// poses, while they are in the processor's cache. `update` measures the bodies that were left
  /// out.
  void record_motion(const Particles& particles, std::size_t task, std::size_t first,
                     std::size_t last) {
    if (particles.size() != poses_.size()) return;
    const AffineMotion motion = extrapolated();
    double squared = 0;
    for (std::size_t i = first; i < last; ++i)
      squared = std::max(squared, poses_[i].squared_displacement(
                                      particles.body(static_cast<BodyIndex>(i)), motion));
    largest_[task] = squared;
  }

  /// Updates the bound to the present poses. Displacements are measured from reference poses, which
  /// are replaced when the bound has grown by `stride` [m]: oscillations do not accumulate.
  /// @param near how far apart along an axis the centres of near bodies may be [m]
  /// @param farthest_image how many periods the two bodies of a pair may be apart
  template <Execution E = Serial>
  void update(const Particles& particles, const Domain& domain, double stride, double near,
              int farthest_image, const E& execution = {}) {
    if (std::find(largest_.begin(), largest_.end(), unknown) != largest_.end())
      for_each_task(execution, poses_.size(),
                    [&](std::size_t task, std::size_t first, std::size_t last) {
                      record_motion(particles, task, first, last);
                    });
    const AffineMotion motion = extrapolated();
    double squared = 0;
    for (const double largest : largest_) squared = std::max(squared, largest);
    std::fill(largest_.begin(), largest_.end(), unknown);
    current_ = std::sqrt(squared) + 0.5 * near * motion.norm();
    if constexpr (Domain::periodic) {
      // Deviation of the images from the affine motion; half of it counts for each body of a pair.
      const Vec2 affine = domain_.period + componentwise_product(motion.gradient, domain_.period);
      const Vec2 deviation = componentwise_abs(domain.period - affine);
      const double affine_shear =
          (1 + motion.gradient.x()) * domain_.shear_offset + motion.shear * domain_.period.y();
      current_ += 0.5 * farthest_image *
                  (deviation.x() + deviation.y() + std::abs(domain.shear_offset - affine_shear));
    }
    const AffineMotion measured = measure(particles, domain);
    increment_ = {measured.gradient - last_.gradient, measured.translation - last_.translation,
                  measured.shear - last_.shear};
    last_ = measured;
    if (current_ > stride) restart(particles, domain);
  }

  /// Takes the present poses as reference poses. To be called when the set of bodies has changed.
  void restart(const Particles& particles, const Domain& domain) {
    accumulated_ += current_;
    current_ = 0;
    domain_ = domain;
    poses_.clear();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      poses_.push_back({particles.body(i).position, particles.body(i).rotation,
                        particles.shape(i).circumradius});
    largest_.assign(task_count(poses_.size()), unknown);
    find_outermost();
    last_ = {};
  }
  /// The body at `parent` has become one piece, at the same index, or two, the other one at
  /// `second`, above all others: reference poses of the pieces are those that they had as parts of
  /// the parent, so that the bound goes on.
  /// @param whole the parent, before it broke
  /// @param second `parent`, if there is one piece
  void divide(const Particles& particles, const Body& whole, BodyIndex parent, BodyIndex second) {
    const Pose reference = poses_[parent];
    const Rotation turn =
        product(reference.rotation, {whole.rotation.cosine, -whole.rotation.sine});
    const auto part = [&](BodyIndex i) -> Pose {
      const Body& body = particles.body(i);
      return {reference.position + turn * (body.position - whole.position),
              product(turn, body.rotation), particles.shape(i).circumradius};
    };
    poses_[parent] = part(parent);
    if (second == parent) return;
    poses_.push_back(part(second));
    largest_.resize(task_count(poses_.size()), unknown);
  }
  [[nodiscard]] std::size_t bodies() const { return poses_.size(); }

 private:
  [[nodiscard]] static Rotation product(const Rotation& p, const Rotation& q) {
    const Vec2 turned = p * Vec2{q.cosine, q.sine};
    return {turned.x(), turned.y()};
  }

  // Moves x to x + gradient * x + translation, axis by axis; shear * x_2 comes on top along axis 1.
  struct AffineMotion {
    Vec2 gradient{0, 0};
    Vec2 translation{0, 0};
    double shear = 0;  // of a periodic cell only

    // Of the largest displacement of a point at most 1 away along each axis, an upper bound.
    [[nodiscard]] double norm() const {
      if constexpr (!Domain::periodic) return gradient.norm();
      return Vec2{std::abs(gradient.x()) + std::abs(shear), gradient.y()}.norm();
    }
  };

  struct Pose {
    Vec2 position;
    Rotation rotation;
    double circumradius;

    [[nodiscard]] double squared_displacement(const Body& body, const AffineMotion& motion) const {
      Vec2 affine = componentwise_product(motion.gradient, position) + motion.translation;
      if constexpr (Domain::periodic) affine.x() += motion.shear * position.y();
      const Vec2 translation = body.position - position - affine;
      const double dc = body.rotation.cosine - rotation.cosine;
      const double ds = body.rotation.sine - rotation.sine;
      // (p + q)^2 <= 2 (p^2 + q^2): bounds the displacement of the farthest vertex without a root.
      return 2 * (translation.dot(translation) + circumradius * circumradius * (dc * dc + ds * ds));
    }
  };

  // The outermost bodies along each axis.
  void find_outermost() {
    for (const Eigen::Index axis : {0, 1}) {
      const auto before = [axis](const Pose& p, const Pose& q) {
        return p.position[axis] < q.position[axis];
      };
      const auto [low, high] = std::minmax_element(poses_.begin(), poses_.end(), before);
      outermost_[static_cast<std::size_t>(axis)] = {static_cast<BodyIndex>(low - poses_.begin()),
                                                    static_cast<BodyIndex>(high - poses_.begin())};
    }
  }

  // Affine motion since the reference poses: that of the cell, or of the outermost bodies.
  [[nodiscard]] AffineMotion measure(const Particles& particles, const Domain& domain) const {
    AffineMotion motion;
    for (const Eigen::Index axis : {0, 1}) {
      if constexpr (Domain::periodic) {
        motion.gradient[axis] = domain.period[axis] / domain_.period[axis] - 1;
      } else {
        if (poses_.empty()) break;
        const auto [low, high] = outermost_[static_cast<std::size_t>(axis)];
        const double from = poses_[low].position[axis];
        const double extent = poses_[high].position[axis] - from;
        const double to = particles.body(low).position[axis];
        const double now = particles.body(high).position[axis] - to;
        if (extent > 0) motion.gradient[axis] = now / extent - 1;
        motion.translation[axis] = to - from - motion.gradient[axis] * from;
      }
    }
    if constexpr (Domain::periodic)
      motion.shear = (domain.shear_offset - (1 + motion.gradient.x()) * domain_.shear_offset) /
                     domain_.period.y();
    return motion;
  }

  // Displacements are measured before all bodies have moved, so relative to an affine motion
  // extrapolated by one step. Zero for large gradients, by which distant bodies might touch first.
  [[nodiscard]] AffineMotion extrapolated() const {
    const AffineMotion motion{last_.gradient + increment_.gradient,
                              last_.translation + increment_.translation,
                              last_.shear + increment_.shear};
    return motion.norm() < 0.5 ? motion : AffineMotion{};
  }

  std::vector<Pose> poses_;
  static constexpr double unknown = -1;
  std::vector<double> largest_;  // squares of the largest displacements, task by task
  [[no_unique_address]] Domain domain_{};
  double accumulated_ = 0;
  double current_ = 0;
  std::array<std::pair<BodyIndex, BodyIndex>, 2> outermost_{};  // along either axis
  AffineMotion last_;                                           // measured last
  AffineMotion increment_;                                      // in one step
};

}  // namespace riprap
