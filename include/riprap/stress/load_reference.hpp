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
             std::span<const OutlinePoint> places, const Rotation& rotation,
             const CompactOperator& op, double limit) {
    forget();
    if (loads.size() > capacity) return;
    count_ = static_cast<std::uint32_t>(loads.size());
    largest_norm_ = static_cast<float>(op.largest_norm());
    double forces = 0;
    for (std::size_t c = 0; c < loads.size(); ++c) {
      const Vec2 arm = rotation.inverse_times(loads[c].arm);
      const Vec2& force = placed[c].force;
      const BoundaryPoint& at = places[c].at;
      const double hold = safely(std::min(places[c].hold, op.reach(at)), arm);
      contacts_[c] = {.x = static_cast<float>(arm.x()),
                      .y = static_cast<float>(arm.y()),
                      .hold_square = static_cast<float>(hold * std::abs(hold)),
                      .steepness = static_cast<float>(op.steepness(at, force)),
                      .unit_steepness = static_cast<float>(op.steepness(at)),
                      .unit_norm = 0,  // by keep_products
                      .partner = loads[c].partner};
      corners_[c] = corner_of(places[c], arm);
      forces_[2 * c] = static_cast<float>(force.x());
      forces_[2 * c + 1] = static_cast<float>(force.y());
      forces += force.norm();
    }
    keep_products(placed, op);
    // Arms and forces are kept to 6e-8 of their size. An arm is up to some twenty node spacings
    // long, and a force that moves by a node spacing changes the stresses by up to twice the norm.
    limit_ = static_cast<float>((1 - margin) * limit - margin * op.largest_norm() * forces);
    // Its square must be far above the smallest numbers.
    if (!(limit_ > 1e-12f)) forget();
  }

  /// True if the stresses under `loads` are known to be within the limit of those evaluated.
  [[nodiscard]] bool holds(std::span<const ContactLoad> loads, const Rotation& rotation) const {
    if (!(limit_ > 0)) return false;
    std::array<float, 2 * capacity> change;
    float slack = 0;
    float sum = 0;  // bound on the norm of the change of forces
    std::size_t c = 0;
    for (const ContactLoad& load : loads) {
      const Vec2 force_now = rotation.inverse_times(load.force);
      const auto fx = static_cast<float>(force_now.x());
      const auto fy = static_cast<float>(force_now.y());
      const float size = std::abs(fx) + std::abs(fy);
      for (; c < count_ && contacts_[c].partner < load.partner; ++c) sum += open(change, c);
      if (c == count_ || contacts_[c].partner != load.partner) {
        slack += largest_norm_ * size;
        continue;
      }
      const Contact& then = contacts_[c];
      const Vec2 arm = rotation.inverse_times(load.arm);
      const float dx = static_cast<float>(arm.x()) - then.x;
      const float dy = static_cast<float>(arm.y()) - then.y;
      const float moved = dx * dx + dy * dy;
      float along = 0;
      if (moved <= then.hold_square)
        along = std::sqrt(moved);
      else if (moved <= corners_[c].hold_square)
        along = corners_[c].way(static_cast<float>(arm.x()), static_cast<float>(arm.y()));
      else
        return false;
      const float by_x = fx - forces_[2 * c];
      const float by_y = fy - forces_[2 * c + 1];
      change[2 * c] = by_x;
      change[2 * c + 1] = by_y;
      const float by = std::abs(by_x) + std::abs(by_y);
      slack += along * (then.steepness + then.unit_steepness * by) +
               static_cast<float>(margin) * largest_norm_ * size;
      sum += then.unit_norm * by;
      ++c;
    }
    for (; c < count_; ++c) sum += open(change, c);
    const float left = limit_ - slack;
    // The norm of a sum is no more than the sum of the norms: often that is enough, and saves the
    // form, a fourth of the instructions.
    if (sum <= left) return true;
    return left > 0 && norm_square(change) <= left * left;
  }

 private:
  // On bound, limit and forces: a hundred times the unit round-off of single precision.
  static constexpr double margin = 6e-6;

  struct Contact {
    float x, y;  // arm [m]
    float hold_square;
    float steepness;       // of its force
    float unit_steepness;  // of a unit force
    float unit_norm;       // of a unit force along either axis, the larger one
    std::uint32_t partner;
  };

  // Places near the corner of a particle, the most common ones, change edges often. What their
  // boundary points then move by follows from the edges: that of the longer foot is the nearer one.
  struct Corner {
    float hold_square = -1;
    float x = 0, y = 0;
    float before_x = 0, before_y = 0;
    float after_x = 0, after_y = 0;
    float from_corner = 0;
    float round_off = 0;

    [[nodiscard]] float way(float arm_x, float arm_y) const {
      const float dx = arm_x - x;
      const float dy = arm_y - y;
      const float before = std::max(0.0f, dx * before_x + dy * before_y);
      const float after = std::max(0.0f, dx * after_x + dy * after_y);
      const float if_before = std::abs(before + from_corner);
      const float if_after = std::abs(after - from_corner);
      if (before > after + round_off) return if_before;
      if (after > before + round_off) return if_after;
      return std::max(if_before, if_after);
    }
  };
  using Changes = std::array<float, 2 * capacity>;

  // Contact c is no more. Returns what that adds to the norm at most.
  [[nodiscard]] float open(Changes& change, std::size_t c) const {
    change[2 * c] = -forces_[2 * c];
    change[2 * c + 1] = -forces_[2 * c + 1];
    return contacts_[c].unit_norm * (std::abs(forces_[2 * c]) + std::abs(forces_[2 * c + 1]));
  }

  [[nodiscard]] static Corner corner_of(const OutlinePoint& place, const Vec2& arm) {
    const double hold = safely(place.corner_hold, arm);
    if (!(hold > 0)) return {};
    return {.hold_square = static_cast<float>(hold * hold),
            .x = static_cast<float>(place.corner.x()),
            .y = static_cast<float>(place.corner.y()),
            .before_x = static_cast<float>(place.before.x()),
            .before_y = static_cast<float>(place.before.y()),
            .after_x = static_cast<float>(place.after.x()),
            .after_y = static_cast<float>(place.after.y()),
            .from_corner = static_cast<float>(place.from_corner),
            .round_off = static_cast<float>(round_off * arm.lpNorm<1>())};
  }

  // Of differences of arms, with room.
  static constexpr double round_off = 1e-6;
  // Less than nothing where round-off may hide the whole hold.
  [[nodiscard]] static double safely(double hold, const Vec2& arm) {
    return 0.99 * hold - round_off * arm.lpNorm<1>();
  }

  // Rows of the lower triangle; what is off the diagonal counts twice.
  void keep_products(std::span<const BoundaryLoad> placed, const CompactOperator& op) {
    // An error of e n_i n_j in each product changes the form by e sum_ij |g_i n_i g_j n_j| at most,
    // and so by less than e N sum_i (g_i n_i)^2: put on the diagonal, it is covered. Four times,
    // for n_i is less between two nodes than at them, and the form is summed in single precision.
    const auto inflated = static_cast<float>(1 + 4 * CompactOperator::product_error * 2 *
                                                     static_cast<double>(placed.size()));
    float* upper = products_.data();
    for (std::size_t c = 0; c < placed.size(); ++c) {
      float* lower = upper + 2 * c + 1;
      for (std::size_t d = 0; d < c; ++d) {
        const Eigen::Matrix2f block = 2 * op.product(placed[c].at, placed[d].at);
        upper[2 * d] = block(0, 0);
        upper[2 * d + 1] = block(0, 1);
        lower[2 * d] = block(1, 0);
        lower[2 * d + 1] = block(1, 1);
      }
      const Eigen::Matrix2f own = op.product(placed[c].at, placed[c].at);
      upper[2 * c] = inflated * own(0, 0);
      lower[2 * c] = own(0, 1) + own(1, 0);
      lower[2 * c + 1] = inflated * own(1, 1);
      contacts_[c].unit_norm =
          static_cast<float>(1 + margin) * std::sqrt(std::max(upper[2 * c], lower[2 * c + 1]));
      upper = lower + 2 * c + 2;
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
  std::array<Corner, capacity> corners_;
  std::array<float, 2 * capacity> forces_;
  std::array<float, capacity * (2 * capacity + 1)> products_;
};

}  // namespace riprap
