// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What an experiment may change between steps, beside the bodies and the policies.

#include <concepts>
#include <cstddef>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/body_force/uniform_body_force.hpp>
#include <riprap/simulation/breakage_stage.hpp>

namespace riprap {

/// Base of a Simulation.
template <class Sim, class ModelType>
class Settings {
 public:
  void set_breakage(bool active) { sim().breakage_active_ = active; }
  [[nodiscard]] bool breakage() const { return sim().breakage_active_; }
  /// Sets the acceleration of the body force on free bodies [m/s^2], if it is uniform.
  void set_body_force(const Vec2& acceleration)
    requires std::same_as<decltype(ModelType::motion_model.body_force), UniformBodyForce>
  {
    const UniformBodyForce body_force{acceleration};
    body_force.validate();
    sim().motion_.body_force = body_force;
  }
  [[nodiscard]] const auto& body_force() const { return sim().motion_.body_force; }
  /// Replaces the time step [s] that the rule chose; stability is the caller's responsibility. With
  /// bonds it falls to that of the rule, if this is smaller, when a particle breaks.
  void set_time_step(double seconds) {
    require_positive("time step", seconds);
    sim().time_step_ = seconds;
  }

  /// Memory for influence operators [bytes], with an OperatorCache: results do not depend on it.
  void set_operator_budget(std::size_t bytes)
    requires requires(BreakageStage<ModelType>& stage) { stage.operators.set_budget(bytes); }
  {
    sim().breakage_.operators.set_budget(bytes);
  }

 private:
  friend Sim;
  Settings() = default;
  [[nodiscard]] Sim& sim() { return static_cast<Sim&>(*this); }
  [[nodiscard]] const Sim& sim() const { return static_cast<const Sim&>(*this); }
};

}  // namespace riprap
