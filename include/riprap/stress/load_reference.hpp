// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How far can the stresses in a particle have moved since its loads were last evaluated?

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <riprap/stress/compact_operator.hpp>
#include <riprap/stress/corner_way.hpp>
#include <riprap/stress/load_watch.hpp>

namespace riprap {

/// A contact force on a particle, in laboratory axes.
struct ContactLoad {
  Vec2 arm{0, 0};           ///< contact point from the centroid [m]
  Vec2 force{0, 0};         ///< on the particle [N]
  double normal_force = 0;  ///< [N]
  std::uint32_t partner = 0;
  std::uint32_t side = 0;  ///< which one of which pair, as by PairIndex
};

/// The loads of one particle at its last evaluation, in its own frame, and by how much the stresses
/// may move before it has to be evaluated again. The Frobenius norm of the change is bounded by
/// that of the change of forces at the places of then, a quadratic form in them, plus what each
/// contact adds by moving or by being new. Single precision; the margins cover it.
///
/// Where that leaves something of the limit, it is shared out in prices: be a contact then at g
/// more of force and a way w along the boundary, and now at d more and v farther. The norm of a sum
/// is no more than the sum of the norms, so the bound has grown by no more than
///     v (s + u |g|) + (w + v) u |d| + n_x |d_x| + n_y |d_y|
/// with s the steepness of the force of the reference, u and n those of unit forces. While v is
/// kept below a hold h, that is linear in the changes.
class LoadReference {
 public:
  /// Contacts in a reference; a particle with more has to be evaluated every time.
  static constexpr std::size_t capacity = 10;
  /// Contacts with which it can be told whether a particle holds.
  static constexpr std::size_t most_loads = 2 * capacity;
  using Prices = std::array<LoadPrice, most_loads>;

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
      contacts_[c] = {.load = LoadPrice::single(arm, force),
                      .hold = static_cast<float>(hold),
                      .steepness = static_cast<float>(op.steepness(at, force)),
                      .unit_steepness = static_cast<float>(op.steepness(at)),
                      .norm_x = 0,  // by keep_products
                      .norm_y = 0,
                      .short_way = 0,
                      .partner = loads[c].partner};
      corners_[c] = {places[c], safely(places[c].corner_hold, arm), round_off * arm.lpNorm<1>()};
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
    Comparison now;
    return compare(loads, rotation, now) >= 0;
  }
  /// The same, and a tenth of the limit is left; if so, every load has a price at which a LoadWatch
  /// may go on from here. With less it would not go far: to evaluate the particle now saves more
  /// comparisons (a twentieth of all checking) than it costs evaluations.
  [[nodiscard]] bool holds(std::span<const ContactLoad> loads, const Rotation& rotation,
                           Prices& prices) const {
    Comparison now;
    const float left = compare(loads, rotation, now);
    if (!(left >= 0.1f * limit_)) return false;
    find_prices({now.met.data(), loads.size()}, left, prices);
    return true;
  }

 private:
  // On bound, limit and forces: a hundred times the unit round-off of single precision.
  static constexpr double margin = 6e-6;

  struct Contact {
    FourFloats load;  // arm and force, as a LoadPrice has them
    float hold;
    float steepness;       // of its force
    float unit_steepness;  // of a unit force
    float norm_x, norm_y;  // of a unit force along either axis
    float short_way;       // one over a way that adds little to the norms
    std::uint32_t partner;
  };

  // Of forces: x, y, x, y for each contact.
  using Changes = std::array<FourFloats, capacity>;
  [[nodiscard]] static FourFloats force_twice(const FourFloats& load) {
    return __builtin_shufflevector(load, load, 2, 3, 2, 3);
  }

  // A load beside that of the same contact in the reference.
  struct Meeting {
    FourFloats load;  // in the particle's own frame
    std::size_t contact;
    float moved;  // the arm
    float along;  // the boundary, at most
    float by;     // the force, sum of its components
  };
  static constexpr std::size_t fresh = capacity;  // contact of a load that has come since
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
      met = {.load = LoadPrice::single(rotation.inverse_times(loads[k].arm),
                                       rotation.inverse_times(loads[k].force)),
             .contact = fresh,
             .moved = 0,
             .along = 0,
             .by = 0};
      const float size = std::abs(met.load[2]) + std::abs(met.load[3]);
      if (c == count_ || contacts_[c].partner != loads[k].partner) {
        slack += largest_norm_ * size;
        continue;
      }
      met.contact = c;
      if (!find_way(met)) return -1;
      now.change[c] = force_twice(met.load - contacts_[c].load);
      met.by = std::abs(now.change[c][0]) + std::abs(now.change[c][1]);
      slack += met.along * (contacts_[c].steepness + contacts_[c].unit_steepness * met.by) +
               static_cast<float>(margin) * largest_norm_ * size;
      ++c;
    }
    for (; c < count_; ++c) open(now.change, c);
    const float left = limit_ - slack;
    return left > 0 ? left - std::sqrt(std::max(0.0f, norm_square(now.change))) : -1;
  }

  // False if the arm has left where steepness is known.
  [[nodiscard]] bool find_way(Meeting& met) const {
    const Contact& then = contacts_[met.contact];
    const CornerWay& corner = corners_[met.contact];
    const float dx = met.load[0] - then.load[0];
    const float dy = met.load[1] - then.load[1];
    met.moved = std::sqrt(dx * dx + dy * dy);
    if (met.moved <= then.hold)
      met.along = met.moved;
    else if (met.moved <= corner.hold)
      met.along = corner.way(corner.feet(met.load[0], met.load[1]));
    else
      return false;
    return true;
  }

  // Contact c is no more.
  void open(Changes& change, std::size_t c) const { change[c] = force_twice(-contacts_[c].load); }

  // How far a contact may go on from here, and what is known of it until there.
  struct Freedom {
    float hold;       // of its arm
    float along;      // the boundary, already
    float steepness;  // of its force, as it is
    float cost;       // part of what is left
  };

  // A place near a corner stays on its edge, if that leaves it enough to go; or it may change edges
  // and the jump is paid for now, if that costs no more than `share` of what is left.
  [[nodiscard]] Freedom freedom(const Meeting& met, float share) const {
    const Contact& then = contacts_[met.contact];
    const CornerWay& corner = corners_[met.contact];
    const float steepness = then.steepness + then.unit_steepness * met.by;
    Freedom free{
        .hold = then.hold - met.moved, .along = met.along, .steepness = steepness, .cost = 0};
    const float hold = corner.hold - met.moved;
    if (!(hold > free.hold)) return free;
    const auto feet = corner.feet(met.load[0], met.load[1]);
    free.hold = std::max(free.hold, std::min(corner.edge_hold(feet), hold));
    const float along = std::max(met.along, feet.longer_way());
    const float cost = (along - met.along) * steepness;
    if (free.hold * steepness > share || cost > share) return free;
    return {.hold = hold, .along = along, .steepness = steepness, .cost = cost};
  }

  // In terms of the norm, with the price of a way that takes the whole budget.
  [[nodiscard]] FourFloats price(const Contact& then, const Freedom& free, float budget) const {
    if (!(free.hold > 0)) return LoadPrice{}.price;
    const float arm = std::max({budget * then.short_way, budget / free.hold, free.steepness});
    const float more = then.unit_steepness * (free.along + budget / arm) +
                       static_cast<float>(margin) * largest_norm_;
    return FourFloats{arm, arm, then.norm_x + more, then.norm_y + more};
  }

  // By coming so far the loads have left `left` of the limit.
  void find_prices(std::span<const Meeting> met, float left, Prices& prices) const {
    float budget = (1 - 2 * static_cast<float>(margin)) * left;
    const float share = 0.5f * budget / static_cast<float>(met.size());
    std::array<Freedom, most_loads> free;
    for (std::size_t k = 0; k < met.size(); ++k) {
      if (met[k].contact == fresh) continue;
      free[k] = freedom(met[k], share);
      budget -= free[k].cost;
    }
    float errors = 0;
    for (std::size_t k = 0; k < met.size(); ++k) {
      const FourFloats norms = met[k].contact == fresh
                                   ? FourFloats{0, 0, largest_norm_, largest_norm_}
                                   : price(contacts_[met[k].contact], free[k], budget);
      prices[k] = {met[k].load, norms};
      errors += prices[k].round_off();
    }
    // Nothing is known where round-off alone may cost the budget.
    const float rest = budget - errors;
    const float scale = rest > 0 ? 1 / rest : LoadPrice::none;
    for (std::size_t k = 0; k < met.size(); ++k) prices[k].price *= scale;
  }

  // Of differences of arms, with room.
  static constexpr double round_off = 1e-6;
  // Less than nothing where round-off may hide the whole hold.
  [[nodiscard]] static double safely(double hold, const Vec2& arm) {
    return 0.99 * hold - round_off * arm.lpNorm<1>();
  }

  // The lower triangle of blocks, row by row; what is off the diagonal counts twice.
  void keep_products(std::span<const BoundaryLoad> placed, const CompactOperator& op) {
    // An error of e n_i n_j in each product changes the form by e sum_ij |g_i n_i g_j n_j| at most,
    // and so by less than e N sum_i (g_i n_i)^2: put on the diagonal, it is covered. Four times,
    // for n_i is less between two nodes than at them, and the form is summed in single precision.
    const auto inflated = static_cast<float>(1 + 4 * CompactOperator::product_error * 2 *
                                                     static_cast<double>(placed.size()));
    FourFloats* block = products_.data();
    for (std::size_t c = 0; c < placed.size(); ++c) {
      for (std::size_t d = 0; d < c; ++d) {
        const Eigen::Matrix2f two = 2 * op.product(placed[c].at, placed[d].at);
        *block++ = FourFloats{two(0, 0), two(0, 1), two(1, 0), two(1, 1)};
      }
      const Eigen::Matrix2f own = op.product(placed[c].at, placed[c].at);
      const float x = inflated * own(0, 0);
      const float y = inflated * own(1, 1);
      *block++ = FourFloats{x, own(0, 1), own(1, 0), y};
      Contact& contact = contacts_[c];
      contact.norm_x = static_cast<float>(1 + margin) * std::sqrt(x);
      contact.norm_y = static_cast<float>(1 + margin) * std::sqrt(y);
      contact.short_way = 4 * contact.unit_steepness / std::min(contact.norm_x, contact.norm_y);
    }
  }

  [[nodiscard]] float norm_square(const Changes& change) const {
    FourFloats sum{0, 0, 0, 0};
    const FourFloats* block = products_.data();
    for (std::size_t c = 0; c < count_; ++c) {
      FourFloats row{0, 0, 0, 0};
      for (std::size_t d = 0; d <= c; ++d) row += *block++ * change[d];
      sum += row * __builtin_shufflevector(change[c], change[c], 0, 0, 1, 1);
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

  float limit_ = -1;
  float largest_norm_ = 0;
  std::uint32_t count_ = 0;
  std::array<Contact, capacity> contacts_;
  std::array<CornerWay, capacity> corners_;
  std::array<FourFloats, capacity*(capacity + 1) / 2> products_;
};

}  // namespace riprap
