// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Element stresses of one particle under its contact loads.

#include <memory>
#include <span>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

/// Meshes particle i in its own frame and computes its influence operator.
/// @param model offers `mesher`, `element`, `plane_state` and `support`
template <class StressPart>
[[nodiscard]] std::unique_ptr<InfluenceOperator>
build_operator(const StressPart& model, const Rock& rock, const Particles& particles, BodyIndex i) {
  return std::make_unique<InfluenceOperator>(model.mesher(particles.local_ring(i)), model.element,
                                             model.plane_state, rock, particles.thickness(),
                                             decltype(model.support)::needs_flexibility);
}

/// Evaluates particles one after the other; keeps its workspace.
class StressEvaluation {
 public:
  /// Element stresses under `scale` times the loads, in the particle's own frame. The reference is
  /// valid until the next call. Throws InvalidInput for a load that is not finite.
  template <class Support>
  const ElementStress& operator()(const InfluenceOperator& op, const Support& support,
                                  const Rotation& rotation, std::span<const ContactLoad> loads,
                                  double scale) {
    balanced_.clear();
    for (const ContactLoad& load : loads) {
      require_finite(load);
      balanced_.push_back({op.locator().nearest(rotation.inverse_times(load.arm_lab)).at,
                           rotation.inverse_times(load.force_lab), load.normal_force});
    }
    support.apply_reactions(std::span<BoundaryLoad>(balanced_), op);
    stress_.reset(op.sampling_points().size());
    for (const BoundaryLoad& load : balanced_)
      op.add_stress(load.at, scale * load.force_body, stress_);
    return stress_;
  }

 private:
  std::vector<BoundaryLoad> balanced_;
  ElementStress stress_;
};

}  // namespace riprap
