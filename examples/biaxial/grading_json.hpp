// SPDX-License-Identifier: BSL-1.0
#pragma once
// Indices of breakage for a summary.

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include <riprap/measurement/breakage_indices.hpp>

// Sieves for Marsal's index: each opening is the one before over the square root of two.
inline std::vector<double> sieves_below(double largest) {
  std::vector<double> sieves;
  for (int k = 16; k > 0; --k) sieves.push_back(largest * std::pow(2, -0.5 * k));
  return sieves;
}

// An index that has no meaning for this grading (all of it below Hardin's limit, say) is null.
template <class Index>
nlohmann::ordered_json index_json(Index index) {
  try {
    return index();
  } catch (const riprap::InvalidInput&) {
    return nullptr;
  }
}

inline nlohmann::ordered_json indices_json(const riprap::Grading& before,
                                           const riprap::Grading& after) {
  return {{"hardin_b_r", index_json([&] { return riprap::hardin_breakage(before, after); })},
          {"marsal_b_g", riprap::marsal_breakage(before, after, sieves_below(before.largest()))},
          {"lade_b_10", riprap::lade_breakage(before, after)},
          {"einav_b_r", index_json([&] { return riprap::einav_breakage(before, after); })}};
}
