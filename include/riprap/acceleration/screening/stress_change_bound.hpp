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
#include <riprap/acceleration/screening/weighted_influence.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// The loads of one particle at its last evaluation (the reference), in its own frame, and the
/// weighted norm of a change of its stresses below which it need not be evaluated again. By linear
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
  /// @param influence of unit forces there, @param limit weighted norm of a change of all stresses
  /// under which no evaluation is needed [Pa]
  void reset(std::span<const ContactLoad> loads, std::span<const BoundaryLoad> placed,
             std::span<const LocatedPoint> places, const Rotation& rotation,
             const WeightedInfluence& influence, double limit);

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
                              Comparison& comparison) const;

  // False if the contact point is outside the valid radius.
  [[nodiscard]] bool find_arc_length(MatchedLoad& matched) const;

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
  [[nodiscard]] Allowance allowance(const MatchedLoad& matched, float share) const;

  // Weights in terms of the norm, with a move of the point that uses up the whole budget.
  [[nodiscard]] FourFloats weights(const Contact& then, const Allowance& allowed,
                                   float budget) const;

  // Weights of all contacts when `remaining` is left of the limit.
  void find_sensitivities(std::span<const MatchedLoad> matched, float remaining,
                          Sensitivities& sensitivities) const;

  // Relative round-off of differences of arms, with a margin.
  static constexpr double round_off = 1e-6;
  // Negative where round-off may exceed the valid radius.
  [[nodiscard]] static double reduced(double valid_radius, const Vec2& arm) {
    return 0.99 * valid_radius - round_off * (std::abs(arm.x()) + std::abs(arm.y()));
  }

  // The lower triangle of blocks, row by row; blocks off the diagonal count twice.
  void store_products(const WeightedInfluence& influence);

  [[nodiscard]] float norm_square(const Changes& change) const;

  float limit_ = -1;
  float largest_norm_ = 0;
  std::uint32_t count_ = 0;
  std::array<Contact, capacity> contacts_;
  std::array<CornerArcLength, capacity> corners_;
  std::array<FourFloats, capacity*(capacity + 1) / 2> products_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/acceleration/screening/stress_change_bound.ipp>
#endif
