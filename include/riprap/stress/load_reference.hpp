#pragma once
/// @file
/// How far can the stresses in a particle have moved since its loads were last evaluated?

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <riprap/stress/compact_operator.hpp>
#include <riprap/stress/load_box.hpp>

namespace riprap {

/// A contact force on a particle, in laboratory axes.
struct ContactLoad {
  Vec2 arm{0, 0};           ///< contact point from the centroid [m]
  Vec2 force{0, 0};         ///< on the particle [N]
  double normal_force = 0;  ///< [N]
  std::uint32_t partner = 0;
  std::uint32_t side = 0;  ///< of which pair, as by PairIndex
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
                      .norm_x = 0,  // by keep_products
                      .norm_y = 0,
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

  /// Contacts of a particle beyond which nothing is known of it.
  static constexpr std::size_t most_loads = 2 * capacity;

  /// True if the stresses under `loads` are known to be within the limit of those evaluated.
  [[nodiscard]] bool holds(std::span<const ContactLoad> loads, const Rotation& rotation) const {
    Comparison now;
    return compare(loads, rotation, now) >= 0;
  }

  /// The same, with a box for each of the loads. While the particle has the same contacts, and each
  /// stays inside its own box, the stresses are within the limit.
  [[nodiscard]] bool holds(std::span<const ContactLoad> loads, const Rotation& rotation,
                           std::array<LoadBox, most_loads>& boxes) const {
    Comparison now;
    const float left = compare(loads, rotation, now);
    if (!(left >= 0)) return false;
    give_boxes(now, loads.size(), left, boxes);
    return true;
  }

 private:
  // On bound, limit and forces: a hundred times the unit round-off of single precision.
  static constexpr double margin = 6e-6;

  struct Contact {
    float x, y;  // arm [m]
    float hold_square;
    float steepness;       // of its force
    float unit_steepness;  // of a unit force
    float norm_x, norm_y;  // of a unit force along either axis
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
    // On whichever of the edges.
    [[nodiscard]] float longer_way(float arm_x, float arm_y) const {
      const float dx = arm_x - x;
      const float dy = arm_y - y;
      const float before = std::max(0.0f, dx * before_x + dy * before_y);
      const float after = std::max(0.0f, dx * after_x + dy * after_y);
      return std::max(std::abs(before + from_corner), std::abs(after - from_corner));
    }
  };
  using Changes = std::array<float, 2 * capacity>;

  // A load beside that of the same contact then.
  struct Meeting {
    Vec2 arm, force;      // in the particle's own frame
    std::size_t contact;  // of the reference; none if it is new
    float moved;
    float along;  // the boundary, at most
    float by;     // sum of the components of the change of force
  };
  static constexpr std::size_t none = capacity;
  struct Comparison {
    std::array<Meeting, most_loads> met;
    Changes change;
  };

  // What is left of the limit; less than nothing if it may be passed.
  [[nodiscard]] float compare(std::span<const ContactLoad> loads, const Rotation& rotation,
                              Comparison& now) const {
    if (!(limit_ > 0) || loads.size() > most_loads) return -1;
    float slack = 0;
    std::size_t c = 0;
    for (std::size_t k = 0; k < loads.size(); ++k) {
      for (; c < count_ && contacts_[c].partner < loads[k].partner; ++c) open(now.change, c);
      Meeting& met = now.met[k];
      met.arm = rotation.inverse_times(loads[k].arm);
      met.force = rotation.inverse_times(loads[k].force);
      const auto fx = static_cast<float>(met.force.x());
      const auto fy = static_cast<float>(met.force.y());
      const float size = std::abs(fx) + std::abs(fy);
      if (c == count_ || contacts_[c].partner != loads[k].partner) {
        met.contact = none;
        slack += largest_norm_ * size;
        continue;
      }
      met.contact = c;
      const Contact& then = contacts_[c];
      const auto x = static_cast<float>(met.arm.x());
      const auto y = static_cast<float>(met.arm.y());
      const float square = (x - then.x) * (x - then.x) + (y - then.y) * (y - then.y);
      met.moved = std::sqrt(square);
      if (square <= then.hold_square)
        met.along = met.moved;
      else if (square <= corners_[c].hold_square)
        met.along = corners_[c].way(x, y);
      else
        return -1;
      now.change[2 * c] = fx - forces_[2 * c];
      now.change[2 * c + 1] = fy - forces_[2 * c + 1];
      met.by = std::abs(now.change[2 * c]) + std::abs(now.change[2 * c + 1]);
      slack += met.along * (then.steepness + then.unit_steepness * met.by) +
               static_cast<float>(margin) * largest_norm_ * size;
      ++c;
    }
    for (; c < count_; ++c) open(now.change, c);
    const float left = limit_ - slack;
    if (!(left > 0)) return -1;
    return left - std::sqrt(std::max(0.0f, norm_square(now.change)));
  }

  // How far a contact may go on, and what that costs.
  struct Freedom {
    float hold;       // of its arm
    float steepness;  // of its force
    float along;      // the boundary, until now
  };

  void give_boxes(const Comparison& now, std::size_t loads, float left,
                  std::array<LoadBox, most_loads>& boxes) const {
    const float share = (1 - static_cast<float>(margin)) * left / static_cast<float>(4 * loads);
    std::array<Freedom, most_loads> freedoms;
    float rest = (1 - static_cast<float>(margin)) * left;
    for (std::size_t k = 0; k < loads; ++k)
      if (now.met[k].contact != none) rest -= find_freedom(now.met[k], share, freedoms[k]);
    const float part = rest / static_cast<float>(3 * loads);
    for (std::size_t k = 0; k < loads; ++k) {
      const Meeting& met = now.met[k];
      if (met.contact == none) {
        const float by = 1.5f * part / largest_norm_;
        boxes[k] = LoadBox::around(met.arm, met.force, std::numeric_limits<float>::max(), by, by);
        continue;
      }
      const Contact& then = contacts_[met.contact];
      const Freedom& free = freedoms[k];
      const float way = std::min(free.hold, part / free.steepness);
      const float turn =
          then.unit_steepness * (free.along + way) + static_cast<float>(margin) * largest_norm_;
      boxes[k] = LoadBox::around(met.arm, met.force, way, part / (then.norm_x + turn),
                                 part / (then.norm_y + turn));
    }
  }

  // Returns what it costs that the contact may change edges, where that is less than `share`.
  [[nodiscard]] float find_freedom(const Meeting& met, float share, Freedom& free) const {
    const Contact& then = contacts_[met.contact];
    const Corner& corner = corners_[met.contact];
    const float steepness = then.steepness + then.unit_steepness * met.by;
    const float edge_hold =
        then.hold_square > 0 ? std::sqrt(then.hold_square) - met.moved : -met.moved;
    free = {edge_hold, steepness, met.along};
    if (!(corner.hold_square > 0)) return 0;
    const float hold = std::sqrt(corner.hold_square) - met.moved;
    const float along = std::max(met.along, corner.longer_way(static_cast<float>(met.arm.x()),
                                                              static_cast<float>(met.arm.y())));
    const float jump = (along - met.along) * steepness;
    if (hold <= edge_hold || jump > share) return 0;
    free = {hold, steepness, along};
    return jump;
  }

  // Contact c is no more.
  void open(Changes& change, std::size_t c) const {
    change[2 * c] = -forces_[2 * c];
    change[2 * c + 1] = -forces_[2 * c + 1];
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
      contacts_[c].norm_x = static_cast<float>(1 + margin) * std::sqrt(upper[2 * c]);
      contacts_[c].norm_y = static_cast<float>(1 + margin) * std::sqrt(lower[2 * c + 1]);
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
