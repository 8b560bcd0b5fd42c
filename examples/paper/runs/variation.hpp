// SPDX-License-Identifier: BSL-1.0
#pragma once
// What a run does otherwise than its series, one thing at a time: a row of the study.

#include <string>

namespace study {

enum class Variation {
  none,
  mean_tension_line,
  failure_plane,
  small_pieces,
  weak_rock,
  two_pinned_contacts,
  periodic_cell,
  stocky_pieces,
  large_pieces,
  blunt_particles,
  slow_shear,
  stiff_contacts,
  many_particles,
  recommended_preset,
  paper_preset
};

// As the name of a run ends; nothing for none.
std::string to_text(Variation variation);

}  // namespace study
