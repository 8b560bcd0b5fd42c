// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The Brazilian strength of a model: at which load a disc between two forces breaks.

#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/stress/particle_stress.hpp>

namespace riprap {

/// A regular polygon between two opposed forces at corners. To set the strengths of models with
/// different triggers to the same Brazilian strength.
struct BrazilianTest {
  double diameter = 0.016;   ///< of the circle through the corners [m]
  double thickness = 0.016;  ///< [m]
  unsigned sides = 24;       ///< an even number

  /// 2 F / (pi D t) [Pa] at the least force F at which the trigger fires, to a share of 1e-9; that
  /// of a particle to which the trigger gives a strength factor of 1. Infinite if it does not fire
  /// below 1e15 Pa. Throws InvalidInput if a parameter breaks a rule.
  /// @param model offers `breakage_model` and `stress_model`
  /// @param material of the disc, for a criterion that has one for each
  template <class ModelType>
  [[nodiscard]] double strength(const ModelType& model, const Rock& rock,
                                MaterialIndex material = 0) const {
    validate();
    rock.validate();
    Particles particles(thickness, rock.density);
    particles.add(disc(), Motion::free);
    double high = 1;
    const auto breaks = breaks_under(model, rock, material, particles);
    while (high < 1e15 && !breaks(high)) high *= 2;
    if (!(high < 1e15)) return std::numeric_limits<double>::infinity();
    double low = 0.5 * high;
    while (high - low > 1e-9 * high) {
      const double middle = 0.5 * (low + high);
      (breaks(middle) ? high : low) = middle;
    }
    return high;
  }

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require_positive("BrazilianTest.diameter", diameter);
    require_positive("BrazilianTest.thickness", thickness);
    require(sides >= 4 && sides <= max_polygon_vertices && sides % 2 == 0, "BrazilianTest.sides",
            sides, "must be an even number of 4 to 64");
  }

 private:
  [[nodiscard]] ConvexPolygon disc() const {
    std::vector<Vec2> corners;
    for (unsigned k = 0; k < sides; ++k)
      corners.push_back(Rotation::from_angle(2 * std::numbers::pi * k / sides) *
                        Vec2{0, 0.5 * diameter});
    return ConvexPolygon(std::move(corners));
  }
  [[nodiscard]] std::vector<ContactLoad> loads(double tension) const {
    const double force = 0.5 * std::numbers::pi * diameter * thickness * tension;
    return {{.arm_lab = {0, 0.5 * diameter}, .force_lab = {0, -force}, .normal_force = force},
            {.arm_lab = {0, -0.5 * diameter}, .force_lab = {0, force}, .normal_force = force}};
  }
  // A function of 2 F / (pi D t). Elements are made for triggers that need them.
  template <class ModelType>
  [[nodiscard]] auto breaks_under(const ModelType& model, const Rock& rock, MaterialIndex material,
                                  const Particles& particles) const {
    using TriggerT = decltype(ModelType::breakage_model.trigger);
    std::shared_ptr<const InfluenceOperator> op;
    if constexpr (!LoadTrigger<TriggerT>)
      op = build_operator(model.stress_model, rock, particles, 0);
    return [this, &model, &rock, material, &particles, op](double tension) {
      const auto& criterion = criterion_of(model.breakage_model.criterion, material);
      const auto& trigger = model.breakage_model.trigger;
      const std::vector<ContactLoad> pressed = loads(tension / rock.strength_factor);
      const CriterionView view{criterion};
      const LoadedParticle particle{particles, 0, pressed, rock, view};
      if constexpr (LoadTrigger<TriggerT>) {
        return static_cast<FailureMode>(trigger(particle)) != FailureMode::intact;
      } else {
        StressEvaluation evaluate;
        const ElementStress& stress =
            evaluate(*op, model.stress_model.support, Rotation{}, pressed, 1);
        return fires(trigger,
                     count_failures(criterion, stress, op->sampling_points(), particle.area()),
                     particle);
      }
    };
  }
};

}  // namespace riprap
