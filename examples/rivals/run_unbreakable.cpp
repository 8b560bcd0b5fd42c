// SPDX-License-Identifier: BSL-1.0
// No particle breaks.

#include <riprap/breakage/criterion/never_fails.hpp>

#include "run_model.hpp"

rivals::Json rivals::run_unbreakable(const Case& c) {
  return run_model(riprap::Model{}.criterion(riprap::NeverFails{}), c);
}
