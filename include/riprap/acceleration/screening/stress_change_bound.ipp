// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/acceleration/screening/stress_change_bound.hpp>

namespace riprap {

RIPRAP_INLINE void StressChangeBound::reset(std::span<const ContactLoad> loads,
                                            std::span<const BoundaryLoad> placed,
                                            std::span<const LocatedPoint> places,
                                            const Rotation& rotation,
                                            const WeightedInfluence& influence, double limit) {
  clear();
  if (loads.size() > capacity) return;
  count_ = static_cast<std::uint32_t>(loads.size());
  largest_norm_ = static_cast<float>(influence.largest_norm());
  double forces = 0;
  for (std::size_t c = 0; c < loads.size(); ++c) {
    const Vec2 arm = rotation.inverse_times(loads[c].arm_lab);
    const Vec2& force = placed[c].force_body;
    const PositionSensitivity& position = influence.position_sensitivity(c);
    const auto reach = static_cast<double>(position.radius);
    const double valid_radius = reduced(std::min(places[c].valid_radius, reach), arm);
    const double corner_radius =
        position.holds_round_corner ? std::min(places[c].corner_radius, reach) : -1;
    contacts_[c] = {.load = LoadSensitivity::single(arm, force),
                    .valid_radius = static_cast<float>(valid_radius),
                    .position_sensitivity = position.force,
                    .unit_sensitivity = position.unit,
                    .norm_x = 0,  // by store_products
                    .norm_y = 0,
                    .inverse_short_arc = 0,
                    .partner = loads[c].partner};
    corners_[c] = {places[c], reduced(corner_radius, arm),
                   round_off * (std::abs(arm.x()) + std::abs(arm.y()))};
    forces += force.norm();
  }
  store_products(influence);
  // Arms, forces and columns are rounded to 6e-8 of their size. An arm is up to some twenty node
  // spacings long, and a force that moves by a node spacing changes the stresses by up to twice the
  // norm.
  limit_ = static_cast<float>((1 - margin) * limit - margin * influence.shape_factor() *
                                                         influence.largest_norm() * forces);
  // Its square must not underflow.
  if (!(limit_ > 1e-12f)) clear();
}

RIPRAP_INLINE float StressChangeBound::compare(std::span<const ContactLoad> loads,
                                               const Rotation& rotation,
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
  return remaining > 0 ? remaining - std::sqrt(std::max(0.0f, norm_square(comparison.change))) : -1;
}

RIPRAP_INLINE bool StressChangeBound::find_arc_length(MatchedLoad& matched) const {
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

RIPRAP_INLINE StressChangeBound::Allowance StressChangeBound::allowance(const MatchedLoad& matched,
                                                                        float share) const {
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

RIPRAP_INLINE FourFloats StressChangeBound::weights(const Contact& then, const Allowance& allowed,
                                                    float budget) const {
  if (!(allowed.valid_radius > 0)) return LoadSensitivity{}.weights;
  const float arm = std::max({budget * then.inverse_short_arc, budget / allowed.valid_radius,
                              allowed.position_sensitivity});
  const float more = then.unit_sensitivity * (allowed.arc + budget / arm) +
                     static_cast<float>(margin) * largest_norm_;
  return FourFloats{arm, arm, then.norm_x + more, then.norm_y + more};
}

RIPRAP_INLINE void StressChangeBound::find_sensitivities(std::span<const MatchedLoad> matched,
                                                         float remaining,
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

RIPRAP_INLINE void StressChangeBound::store_products(const WeightedInfluence& influence) {
  // An error of e n_i n_j in each product changes the form by e sum_ij |g_i n_i g_j n_j| at most,
  // and so by less than e N sum_i (g_i n_i)^2: put on the diagonal, it is covered. Twice, for the
  // norms are computed, and the form is summed in single precision.
  const auto inflated = static_cast<float>(1 + 2 * WeightedInfluence::product_error * 2 * count_);
  FourFloats* block = products_.data();
  for (std::size_t c = 0; c < count_; ++c) {
    for (std::size_t d = 0; d < c; ++d) {
      const AxisForm one = influence.product(c, d);
      *block++ = 2 * FourFloats{one.xx, one.xy, one.yx, one.yy};
    }
    const AxisForm own = influence.product(c, c);
    const float x = inflated * own.xx;
    const float y = inflated * own.yy;
    *block++ = FourFloats{x, own.xy, own.yx, y};
    Contact& contact = contacts_[c];
    contact.norm_x = static_cast<float>(1 + margin) * std::sqrt(x);
    contact.norm_y = static_cast<float>(1 + margin) * std::sqrt(y);
    contact.inverse_short_arc =
        4 * contact.unit_sensitivity / std::min(contact.norm_x, contact.norm_y);
  }
}

RIPRAP_INLINE float StressChangeBound::norm_square(const Changes& change) const {
  FourFloats sum{0, 0, 0, 0};
  const FourFloats* block = products_.data();
  for (std::size_t c = 0; c < count_; ++c) {
    FourFloats row{0, 0, 0, 0};
    for (std::size_t d = 0; d <= c; ++d) row += *block++ * change[d];
    sum += row * __builtin_shufflevector(change[c], change[c], 0, 0, 1, 1);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace riprap
