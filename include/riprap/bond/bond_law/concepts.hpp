// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the bond law: from the relative displacement of two bonded edges to a traction.

#include <array>
#include <concepts>

#include <riprap/core/policy.hpp>

namespace riprap {

/// Displacement of a point of b's edge relative to the same point of a's, since the two were
/// bonded, in axes that turn with the mean rotation of the two bodies.
struct BondDisplacement {
  double opening = 0;  ///< along the normal, which points from a to b [m]; overlap: negative
  double sliding = 0;  ///< along the tangent, the normal turned by +90 degrees [m]
};

/// What a exerts on b, per area of the edge.
struct BondTraction {
  double normal = 0;      ///< along the normal [Pa], pushing: positive, as in a contact
  double tangential = 0;  ///< along the tangent [Pa]
  double loss = 0;        ///< energy lost in this evaluation [J/m^2], >= 0
};

/// Whether and how a bond has failed.
enum class BondFailure : unsigned char { none, tension, shear };

/// What a law is given of a whole bond to decide whether it breaks. Displacements are
/// linear along the edge: those at its ends are the extremes.
template <class State>
struct BondView {
  std::array<BondDisplacement, 2> ends{};         ///< at the ends of the edge
  std::array<BondDisplacement, 2> points{};       ///< at the two integration points
  std::array<State, 2> states{State{}, State{}};  ///< of the two integration points
};

namespace requirements {

/// `L::State`: what an integration point of a bond keeps from step to step. A new bond starts with
/// `State{}`.
template <class L>
concept BondLawState = requires { typename L::State; } && std::semiregular<typename L::State>;

/// `law(displacement, state)` -> BondTraction at an integration point; updates the state. Evaluated
/// again at the same displacement it must give the same traction and lose nothing.
template <class L>
concept BondLawCall =
    requires(const L& law, const BondDisplacement& displacement, typename L::State& state) {
      { law(displacement, state) } -> std::convertible_to<BondTraction>;
    };

/// `law.stored_energy(displacement, state)` [J/m^2]: what the point can give back; the traction is
/// minus its gradient.
template <class L>
concept BondLawEnergy =
    requires(const L& law, const BondDisplacement& displacement, const typename L::State& state) {
      { law.stored_energy(displacement, state) } -> std::convertible_to<double>;
    };

/// `law.failure(bond)` -> BondFailure, from a BondView after the tractions have been evaluated: a
/// bond that fails is gone, as a whole and for good.
template <class L>
concept BondLawFailure = requires(const L& law, const BondView<typename L::State>& bond) {
  { law.failure(bond) } -> std::convertible_to<BondFailure>;
};

/// `law.peak_stiffness()` [Pa/m]: largest slope of traction against displacement; sets the time
/// step.
template <class L>
concept BondLawStiffness = requires(const L& law) {
  { law.peak_stiffness() } -> std::convertible_to<double>;
};

}  // namespace requirements

/// A `BondLaw` computes the tractions of bonds between particles, and when they break.
template <class L>
concept BondLaw = Policy<L> && requirements::BondLawState<L> && requirements::BondLawCall<L> &&
                  requirements::BondLawEnergy<L> && requirements::BondLawFailure<L> &&
                  requirements::BondLawStiffness<L>;

template <class L>
consteval bool check_bond_law() {
  check_policy<L>();
  static_assert(requirements::BondLawState<L>,
                "riprap: a BondLaw must have a type State that can be default-constructed and "
                "copied");
  if constexpr (requirements::BondLawState<L>) {  // the others cannot be checked without it
    static_assert(requirements::BondLawCall<L>,
                  "riprap: a BondLaw must have BondTraction operator()(const BondDisplacement&, "
                  "State&) const");
    static_assert(requirements::BondLawEnergy<L>,
                  "riprap: a BondLaw must have double stored_energy(const BondDisplacement&, const "
                  "State&) const");
    static_assert(requirements::BondLawFailure<L>,
                  "riprap: a BondLaw must have BondFailure failure(const BondView<State>&) const");
    static_assert(requirements::BondLawStiffness<L>,
                  "riprap: a BondLaw must have double peak_stiffness() const");
  }
  return BondLaw<L>;
}

}  // namespace riprap
