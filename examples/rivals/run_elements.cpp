// SPDX-License-Identifier: BSL-1.0
// Bagherzadeh-Khalkhali et al. (2008): the share of failed finite elements.

#include "run_model.hpp"

rivals::Json rivals::run_elements(const Case& c) {
  riprap::HoekBrown criterion{};
  criterion.compressive_strength *= strength_factor(riprap::Model{}, c);
  return run_model(riprap::Model{}.criterion(criterion), c);
}
