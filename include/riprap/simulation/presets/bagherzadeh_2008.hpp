// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The model of the paper to the letter.

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/breakage/trigger/failed_element_ratio.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

namespace riprap::presets {

/// Bagherzadeh-Khalkhali, Mirghasemi and Mohammadi, Particuology 6 (2008): Table 1; two contacts
/// pinned; RatF 0.4, the share of failed 3-node triangles, of about 100; X or Y by the planes of
/// the first failed element. Table 1's elastic constants and density are those of Rock{}.
///
/// The paper names no law of contact. Linear springs at the chord of the overlap are the plain
/// reading of its two stiffnesses per contact; they do not conserve energy (docs/choices.md).
[[nodiscard]] inline auto bagherzadeh_2008() {
  return Model{}
      .narrow_phase(OverlapChord{})
      .contact_law(LinearSpringCoulomb{
          .normal_stiffness = 2e7, .tangential_stiffness = 2e7, .friction = 0.5})
      .time_step(MassFloor{.fraction = 0.12})
      .mesher(UniformMesher{.triangles = 100})
      .element(ConstantStrainTriangle{})
      .plane_state(PlaneStress{})
      .support(TwoPinnedContacts{})
      .criterion(HoekBrown{.compressive_strength = 300e6, .m_b = 25, .s = 1, .a_b = 0.5})
      .trigger(FailedElementRatio{.critical = 0.4})
      .line_fit(WeightedXY{});
}

}  // namespace riprap::presets
