#pragma once
/// @file
/// How far can the stresses in a particle have moved since its loads were last evaluated?

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <riprap/stress/compact_operator.hpp>

namespace riprap {

/// A contact force on a particle, in laboratory axes.
struct ContactLoad {
  Vec2 arm{0, 0};           ///< contact point from the centroid [m]
  Vec2 force{0, 0};         ///< on the particle [N]
  double normal_force = 0;  ///< [N]
  std::uint32_t partner = 0;
};

/// The loads of one particle at its last evaluation, in its own frame, and by how much the stresses
/// may move before it has to be evaluated again. The Frobenius norm of the change is bounded by
/// that of the change of forces at the places of then, a quadratic form in them, plus what each
/// contact adds by moving, by opening or by being new. Single precision; the margins cover it.
class LoadReference {
 public:
  /// Contacts in a reference; a particle with more has to be evaluated every time.
  static constexpr std::size_t capacity = 10;

  /// No change is known to be harmless.
  void forget() { limit_ = -1; }

  /// Keeps the loads, as they were put on the boundary.
  /// @param limit Frobenius norm of a change of all stresses that is harmless [Pa]
  void renew(std::span<const ContactLoad> loads, std::span<const BoundaryLoad> placed,
             std::span<const double> holds, const Rotation& rotation, const CompactOperator& op,
             double limit) {
    forget();
    if (loads.size() > capacity) return;
    count_ = static_cast<std::uint32_t>(loads.size());
    largest_norm_ = static_cast<float>(op.largest_norm());
    double forces = 0;
    for (std::size_t c = 0; c < loads.size(); ++c) {
      const Vec2 arm = rotation.inverse_times(loads[c].arm);
      const Vec2& force = placed[c].force;
      const double hold = 0.99 * std::min(holds[c], op.reach(placed[c].at));
      contacts_[c] = {static_cast<float>(arm.x()), static_cast<float>(arm.y()),
                      static_cast<float>(hold * hold),
                      static_cast<float>(op.steepness(placed[c].at)), loads[c].partner};
      forces_[2 * c] = static_cast<float>(force.x());
      forces_[2 * c + 1] = static_cast<float>(force.y());
      forces += force.norm();
    }
    keep_products(placed, op);
    // Arms and forces are kept to 6e-8 of their size. An arm is up to some twenty node spacings
    // long, and a force that moves by a node spacing changes the stresses by up to twice the norm.
    limit_ = static_cast<float>((1 - margin) * limit - margin * op.largest_norm() * forces);
  }

  /// True if the stresses under `loads` are known to be within the limit of those evaluated.
  [[nodiscard]] bool holds(std::span<const ContactLoad> loads, const Rotation& rotation) const {
    if (!(limit_ > 0)) return false;
    std::array<float, 2 * capacity> change;
    float slack = 0;
    std::size_t c = 0;
    for (const ContactLoad& load : loads) {
      const Vec2 force_now = rotation.inverse_times(load.force);
      const auto fx = static_cast<float>(force_now.x());
      const auto fy = static_cast<float>(force_now.y());
      const float size = std::abs(fx) + std::abs(fy);
      for (; c < count_ && contacts_[c].partner < load.partner; ++c) open(change, c);
      if (c == count_ || contacts_[c].partner != load.partner) {
        slack += largest_norm_ * size;
        continue;
      }
      const Contact& then = contacts_[c];
      const Vec2 arm = rotation.inverse_times(load.arm);
      const float dx = static_cast<float>(arm.x()) - then.x;
      const float dy = static_cast<float>(arm.y()) - then.y;
      const float moved = dx * dx + dy * dy;
      if (!(moved <= then.hold_square)) return false;
      slack += then.steepness * std::sqrt(moved * (fx * fx + fy * fy)) +
               static_cast<float>(margin) * largest_norm_ * size;
      change[2 * c] = fx - forces_[2 * c];
      change[2 * c + 1] = fy - forces_[2 * c + 1];
      ++c;
    }
    for (; c < count_; ++c) open(change, c);
    const float left = limit_ - slack;
    return left > 0 && norm_square(change) <= left * left;
  }

 private:
  // On bound, limit and forces: a hundred times the unit round-off of single precision.
  static constexpr double margin = 6e-6;

  struct Contact {
    float x, y;  // arm [m]
    float hold_square;
    float steepness;
    std::uint32_t partner;
  };
  using Changes = std::array<float, 2 * capacity>;

  void open(Changes& change, std::size_t c) const {
    change[2 * c] = -forces_[2 * c];
    change[2 * c + 1] = -forces_[2 * c + 1];
  }

  // Rows of the lower triangle; what is off the diagonal counts twice.
  void keep_products(std::span<const BoundaryLoad> placed, const CompactOperator& op) {
    std::size_t at = 0;
    // |error| <= e sum_ij |g_i| |g_j| n_i n_j <= e N sum_i (g_i n_i)^2: it goes on the diagonal.
    const double inflated =
        1 + 2 * CompactOperator::product_error * 2 * static_cast<double>(placed.size());
    for (std::size_t c = 0; c < placed.size(); ++c) {
      std::array<std::array<float, 2 * capacity>, 2> rows;
      for (std::size_t d = 0; d <= c; ++d) {
        const Eigen::Matrix2d block = op.product(placed[c].at, placed[d].at);
        for (int axis = 0; axis < 2; ++axis)
          for (int other = 0; other < 2; ++other)
            rows[static_cast<std::size_t>(axis)][2 * d + static_cast<std::size_t>(other)] =
                static_cast<float>(axis == other && c == d ? inflated * block(axis, other)
                                                           : 2 * block(axis, other));
      }
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t k = 0; k <= 2 * c + axis; ++k) products_[at++] = rows[axis][k];
    }
  }

  [[nodiscard]] float norm_square(const Changes& change) const {
    float sum = 0;
    const float* row = products_.data();
    for (std::size_t i = 0; i < 2 * count_; ++i) {
      float inner = 0;
      for (std::size_t k = 0; k <= i; ++k) inner += row[k] * change[k];
      sum += inner * change[i];
      row += i + 1;
    }
    return sum;
  }

  float limit_ = -1;
  float largest_norm_ = 0;
  std::uint32_t count_ = 0;
  std::array<Contact, capacity> contacts_;
  std::array<float, 2 * capacity> forces_;
  std::array<float, capacity * (2 * capacity + 1)> products_;
};

}  // namespace riprap
