// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Upper bound on the change of the stresses in a particle since its last evaluation.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include <riprap/acceleration/screening/corner_arc_length.hpp>
#include <riprap/acceleration/screening/incremental_bound.hpp>
#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// The loads of one particle at its last evaluation (the reference), in its own frame, and the
/// Frobenius norm of a change of its stresses below which it need not be evaluated again. By linear
/// superposition the change is that due to the changes of the forces at the reference points, whose
/// norm is a quadratic form in them, plus the contributions of contacts that moved or are new.
/// Single precision; margins account for its round-off.
///
/// What the bound leaves of the limit is distributed over the contacts as weights. Let the force of
/// a contact have changed by g since the reference and its point have moved by an arc length w, and
/// let them change by another d and v. By the triangle inequality the bound grows by no more than
///     v (s + u |g|) + (w + v) u |d| + n_x |d_x| + n_y |d_y|
/// with s the position sensitivity of the reference force, u that of a unit force and n the norms
/// of unit forces. While v is below a valid radius h, that is bounded by a linear form in the
/// changes.
class StressChangeBound {
 public:
  /// Contacts of a reference; a particle with more is evaluated every time.
  static constexpr std::size_t capacity = 10;
  /// Contacts of a particle that can be compared with a reference.
  static constexpr std::size_t max_loads = 2 * capacity;
  using Sensitivities = std::array<LoadSensitivity, max_loads>;

  /// Discards the reference: every comparison fails.
  void clear() { limit_ = -1; }

  /// Takes the loads, at their boundary points, as the new reference.
  /// @param limit Frobenius norm of a change of all stresses under which no evaluation is needed
  /// [Pa]
  void reset(std::span<const ContactLoad> loads, std::span<const BoundaryLoad> placed,
             std::span<const LocatedPoint> places, const Rotation& rotation,
             const InfluenceOperatorF32& op, double limit) {
    clear();
    if (loads.size() > capacity) return;
    count_ = static_cast<std::uint32_t>(loads.size());
    largest_norm_ = static_cast<float>(op.largest_norm());
    double forces = 0;
    for (std::size_t c = 0; c < loads.size(); ++c) {
      const Vec2 arm = rotation.inverse_times(loads[c].arm_lab);
      const Vec2& force = placed[c].force;
      const BoundaryPoint& at = places[c].at;
      const double valid_radius =
          reduced(std::min(places[c].valid_radius, op.valid_radius(at)), arm);
      contacts_[c] = {.load = LoadSensitivity::single(arm, force),
                      .valid_radius = static_cast<float>(valid_radius),
                      .position_sensitivity =
                          static_cast<float>(op.position_sensitivity(at, force)),
                      .unit_sensitivity = static_cast<float>(op.position_sensitivity(at)),
                      .norm_x = 0,  // by store_products
                      .norm_y = 0,
                      .inverse_short_arc = 0,
                      .partner = loads[c].partner};
      corners_[c] = {places[c], reduced(places[c].corner_radius, arm), round_off * arm.lpNorm<1>()};
      forces += force.norm();
    }
    store_products(placed, op);
    // Arms and forces are rounded to 6e-8 of their size. An arm is up to some twenty node spacings
    // long, and a force that moves by a node spacing changes the stresses by up to twice the norm.
    limit_ = static_cast<float>((1 - margin) * limit - margin * op.largest_norm() * forces);
    // Its square must not underflow.
    if (!(limit_ > 1e-12f)) clear();
  }

  /// True if the bound on the change of the stresses under `loads` is within the limit.
  [[nodiscard]] bool within_limit(std::span<const ContactLoad> loads,
                                  const Rotation& rotation) const {
    Comparison comparison;
    return compare(loads, rotation, comparison) >= 0;
  }
  /// The same, if at least a tenth of the limit remains; then every load gets weights with which an
  /// IncrementalBound continues from here. With less remaining, an evaluation now is cheaper than
  /// the comparisons that would soon follow.
  [[nodiscard]] bool within_limit(std::span<const ContactLoad> loads, const Rotation& rotation,
                                  Sensitivities& sensitivities) const {
    Comparison comparison;
    const float remaining = compare(loads, rotation, comparison);
    if (!(remaining >= 0.1f * limit_)) return false;
    find_sensitivities({comparison.matched.data(), loads.size()}, remaining, sensitivities);
    return true;
  }

 private:
  // Of bound, limit and forces: a hundred times the unit round-off of single precision.
  static constexpr double margin = 6e-6;

  struct Contact {
    FourFloats load;  // arm and force, see LoadSensitivity
    float valid_radius;
    float position_sensitivity;  // of its force
    float unit_sensitivity;      // of a unit force
    float norm_x, norm_y;        // of a unit force along either axis
    float inverse_short_arc;     // one over an arc length that adds little to the norms
    std::uint32_t partner;
  };

  // Changes of the forces: x, y, x, y of each contact.
  using Changes = std::array<FourFloats, capacity>;
  [[nodiscard]] static FourFloats force_twice(const FourFloats& load) {
    return __builtin_shufflevector(load, load, 2, 3, 2, 3);
  }

  // A load and its change against the same contact of the reference.
  struct MatchedLoad {
    FourFloats load;  // in the particle's own frame
    std::size_t contact;
    float moved;         // the arm
    float arc;           // the boundary, at most
    float force_change;  // the force, sum of its components
  };
  static constexpr std::size_t unmatched = capacity;  // contact of a load that has come since
  struct Comparison {
    std::array<MatchedLoad, max_loads> matched;
    Changes change;
  };

  // What remains of the limit; negative if the bound exceeds it.
  [[nodiscard]] float compare(std::span<const ContactLoad> loads, const Rotation& rotation,
                              Comparison& comparison) const {
    if (!(limit_ > 0) || loads.size() > max_loads) return -1;
    float bound = 0;
    std::size_t c = 0;
    for (std::size_t k = 0; k < loads.size(); ++k) {
      for (; c < count_ && contacts_[c].partner < loads[k].partner; ++c)
        remove_contact(comparison.change, c);
      MatchedLoad& matched = comparison.matched[k];
      matched = {.load = LoadSensitivity::single(rotation.inverse_times(loads[k].arm_lab),
                                                 rotation.inverse_times(loads[k].force_lab)),
                 .contact = unmatched,
                 .moved = 0,
                 .arc = 0,
                 .force_change = 0};
      const float size = std::abs(matched.load[2]) + std::abs(matched.load[3]);
      if (c == count_ || contacts_[c].partner != loads[k].partner) {
        bound += largest_norm_ * size;
        continue;
      }
      matched.contact = c;
      if (!find_arc_length(matched)) return -1;
      comparison.change[c] = force_twice(matched.load - contacts_[c].load);
      matched.force_change = std::abs(comparison.change[c][0]) + std::abs(comparison.change[c][1]);
      bound += matched.arc * (contacts_[c].position_sensitivity +
                              contacts_[c].unit_sensitivity * matched.force_change) +
               static_cast<float>(margin) * largest_norm_ * size;
      ++c;
    }
    for (; c < count_; ++c) remove_contact(comparison.change, c);
    const float remaining = limit_ - bound;
    return remaining > 0 ? remaining - std::sqrt(std::max(0.0f, norm_square(comparison.change)))
                         : -1;
  }

  // False if the contact point is outside the valid radius.
  [[nodiscard]] bool find_arc_length(MatchedLoad& matched) const {
    const Contact& then = contacts_[matched.contact];
    const CornerArcLength& corner = corners_[matched.contact];
    const float dx = matched.load[0] - then.load[0];
    const float dy = matched.load[1] - then.load[1];
    matched.moved = std::sqrt(dx * dx + dy * dy);
    if (matched.moved <= then.valid_radius)
      matched.arc = matched.moved;
    else if (matched.moved <= corner.valid_radius)
      matched.arc = corner.arc_length(corner.projections(matched.load[0], matched.load[1]));
    else
      return false;
    return true;
  }

  // Contact c has been lost.
  void remove_contact(Changes& change, std::size_t c) const {
    change[c] = force_twice(-contacts_[c].load);
  }

  // By how much a contact point may move on, with the sensitivity that is valid until there.
  struct Allowance {
    float valid_radius;          // of its arm
    float arc;                   // the boundary, already
    float position_sensitivity;  // of its force, as it is
    float cost;                  // part of what is left
  };

  // A point near a corner stays on its edge, if its valid radius there is large enough; or it may
  // change edges, with the jump added to the bound now if that is no more than `share`.
  [[nodiscard]] Allowance allowance(const MatchedLoad& matched, float share) const {
    const Contact& then = contacts_[matched.contact];
    const CornerArcLength& corner = corners_[matched.contact];
    const float position_sensitivity =
        then.position_sensitivity + then.unit_sensitivity * matched.force_change;
    Allowance allowed{.valid_radius = then.valid_radius - matched.moved,
                      .arc = matched.arc,
                      .position_sensitivity = position_sensitivity,
                      .cost = 0};
    const float valid_radius = corner.valid_radius - matched.moved;
    if (!(valid_radius > allowed.valid_radius)) return allowed;
    const auto projections = corner.projections(matched.load[0], matched.load[1]);
    allowed.valid_radius =
        std::max(allowed.valid_radius, std::min(corner.edge_radius(projections), valid_radius));
    const float arc = std::max(matched.arc, projections.longer_arc());
    const float cost = (arc - matched.arc) * position_sensitivity;
    if (allowed.valid_radius * position_sensitivity > share || cost > share) return allowed;
    return {.valid_radius = valid_radius,
            .arc = arc,
            .position_sensitivity = position_sensitivity,
            .cost = cost};
  }

  // Weights in terms of the norm, with a move of the point that uses up the whole budget.
  [[nodiscard]] FourFloats weights(const Contact& then, const Allowance& allowed,
                                   float budget) const {
    if (!(allowed.valid_radius > 0)) return LoadSensitivity{}.weights;
    const float arm = std::max({budget * then.inverse_short_arc, budget / allowed.valid_radius,
                                allowed.position_sensitivity});
    const float more = then.unit_sensitivity * (allowed.arc + budget / arm) +
                       static_cast<float>(margin) * largest_norm_;
    return FourFloats{arm, arm, then.norm_x + more, then.norm_y + more};
  }

  // Weights of all contacts when `remaining` is left of the limit.
  void find_sensitivities(std::span<const MatchedLoad> matched, float remaining,
                          Sensitivities& sensitivities) const {
    float budget = (1 - 2 * static_cast<float>(margin)) * remaining;
    const float share = 0.5f * budget / static_cast<float>(matched.size());
    std::array<Allowance, max_loads> allowed;
    for (std::size_t k = 0; k < matched.size(); ++k) {
      if (matched[k].contact == unmatched) continue;
      allowed[k] = allowance(matched[k], share);
      budget -= allowed[k].cost;
    }
    float errors = 0;
    for (std::size_t k = 0; k < matched.size(); ++k) {
      const FourFloats norms = matched[k].contact == unmatched
                                   ? FourFloats{0, 0, largest_norm_, largest_norm_}
                                   : weights(contacts_[matched[k].contact], allowed[k], budget);
      sensitivities[k] = {matched[k].load, norms};
      errors += sensitivities[k].round_off();
    }
    // NaN weights where round-off alone may use up the budget.
    const float rest = budget - errors;
    const float scale = rest > 0 ? 1 / rest : LoadSensitivity::none;
    for (std::size_t k = 0; k < matched.size(); ++k) sensitivities[k].weights *= scale;
  }

  // Relative round-off of differences of arms, with a margin.
  static constexpr double round_off = 1e-6;
  // Negative where round-off may exceed the valid radius.
  [[nodiscard]] static double reduced(double valid_radius, const Vec2& arm) {
    return 0.99 * valid_radius - round_off * arm.lpNorm<1>();
  }

  // The lower triangle of blocks, row by row; blocks off the diagonal count twice.
  void store_products(std::span<const BoundaryLoad> placed, const InfluenceOperatorF32& op) {
    // An error of e n_i n_j in each product changes the form by e sum_ij |g_i n_i g_j n_j| at most,
    // and so by less than e N sum_i (g_i n_i)^2: put on the diagonal, it is covered. Four times,
    // for n_i is less between two nodes than at them, and the form is summed in single precision.
    const auto inflated = static_cast<float>(1 + 4 * InfluenceOperatorF32::product_error * 2 *
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
      contact.inverse_short_arc =
          4 * contact.unit_sensitivity / std::min(contact.norm_x, contact.norm_y);
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
  std::array<CornerArcLength, capacity> corners_;
  std::array<FourFloats, capacity*(capacity + 1) / 2> products_;
};

}  // namespace riprap
