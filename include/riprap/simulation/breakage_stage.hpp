// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a simulation keeps for its breakage passes.

#include <cstddef>
#include <type_traits>

#include <riprap/bond/bond_law/no_bonds.hpp>
#include <riprap/breakage/breakage_input.hpp>
#include <riprap/breakage/breakage_pass.hpp>
#include <riprap/breakage/screening/concepts.hpp>
#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/simulation/piece_limit.hpp>

namespace riprap {

/// For a criterion that never fails: nothing.
template <class ModelType>
struct BreakageStage {
  explicit BreakageStage(const ModelType&) {}
  void remove(BodyIndex, std::size_t) {}
  [[nodiscard]] static std::size_t operator_bytes() { return 0; }
  [[nodiscard]] static const InfluenceOperator* find_operator(BodyIndex) { return nullptr; }
  static void for_each_field(auto&, auto&&) {}
  void restart(const ModelType&) {}
};

/// Influence operators, screening, refused cuts and number of pieces.
template <class ModelType>
  requires(!decltype(ModelType::breakage_model)::never_fails)
struct BreakageStage<ModelType> {
  using BreakagePart = decltype(ModelType::breakage_model);
  using StressPart = decltype(ModelType::stress_model);
  static constexpr bool bonded = makes_bonds<decltype(ModelType::contact_model.bond_law)>;
  // The screening follows contacts: with bonds every loaded particle is evaluated.
  using ScreeningPolicy =
      std::conditional_t<bonded, EvaluateAll, decltype(ModelType::acceleration_model.screening)>;
  static_assert(check_screening_state<ScreeningPolicy, BreakagePart, StressPart>());

  explicit BreakageStage(const ModelType& model)
      : operators(model.acceleration_model.operator_store),
        screening(model.breakage_model, model.stress_model) {}

  /// Cracks of the present state. Throws SimulationError for a particle that has broken into too
  /// many pieces.
  template <class Contacts, class OnPhaseEnd>
  const BreakagePass::Cracks& find_cracks(const ModelType& model, const Rocks& rocks,
                                          double mean_area, const Particles& particles,
                                          const Contacts& contacts, OnPhaseEnd&& on_phase_end) {
    const BreakageInput input{
        model.breakage_model,  model.stress_model, rocks, mean_area, particles, contacts, operators,
        model.execution_policy};
    const BreakagePass::Cracks& cracks = pass.find(input, screening, on_phase_end);
    for (const auto& [i, crack] : cracks)
      if (!crack.leaves_dust())
        piece_limit.add_break(model.breakage_model.splitter, particles.ancestry(i));
    return cracks;
  }
  /// Another particle has index i now.
  void forget(BodyIndex i) {
    operators.forget(i);
    screening.forget(i);
  }
  /// Particle i was removed of `count` in all; those behind it have moved up. Their operators are
  /// built again, and all screening begins anew: a pair may be numbered now as another one was.
  void remove(BodyIndex i, std::size_t count) {
    for (BodyIndex k = 0; k < count; ++k) {
      if (k >= i) operators.forget(k);
      screening.forget(k);
    }
    pass.remove(i);
  }
  [[nodiscard]] std::size_t operator_bytes() const { return operators.bytes(); }
  [[nodiscard]] const InfluenceOperator* find_operator(BodyIndex i) const {
    return operators.find(i);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("pass", self.pass);
    visit("pieces", self.piece_limit);
    if constexpr (bonded) visit("cells", self.piece_limit.cells);
  }
  /// After the fields have been written: operators and screening are of other particles.
  void restart(const ModelType& model) {
    operators = decltype(operators)(model.acceleration_model.operator_store);
    screening = decltype(screening)(model.breakage_model, model.stress_model);
  }

  typename decltype(ModelType::acceleration_model.operator_store)::State operators;
  typename ScreeningPolicy::template State<BreakagePart, StressPart> screening;
  BreakagePass pass;
  PieceLimit piece_limit;
};

}  // namespace riprap
